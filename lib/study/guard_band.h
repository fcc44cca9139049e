/* SPDX-License-Identifier: MIT */
/* The clippers that leave sides of the screen to the scan. They clip to near and far, to the
 * given sides at the border of the screen, and to the other sides at the guard band. Internal. */
#ifndef FXL_GUARD_BAND_H
#define FXL_GUARD_BAND_H

#include "clippers.h"
#include "fixel/records.h"

/* Implements fxl_clipper.clip with an fxl_volume_workspace. screen: the planes at the border of
 * the screen, near and far among them. A workspace belongs to one clipper, so they are the same
 * in every call. */
fxl_clip_result fxl_clip_with_guard_band(const fxl_model_view *model_view, const fxl_face *face,
                                         unsigned screen, fxl_screen_polygon *polygon);

#endif
