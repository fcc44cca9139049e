/* SPDX-License-Identifier: MIT */
#ifndef FXL_CLIP_FLAT_H
#define FXL_CLIP_FLAT_H

#include "fixel/clip_record.h"
#include "fixel/clip_view.h"

/* fxl_cut_view_by_planes for a polygon that is not textured: who calls this alone links nothing
 * for textures. */
fxl_clip_result fxl_clip_view_flat(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                   fxl_planes planes, fxl_clip_view_work *work,
                                   fxl_clip_account *account, const fxl_view_polygon **result);

#endif
