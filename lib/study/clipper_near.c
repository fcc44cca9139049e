/* SPDX-License-Identifier: MIT */
/* Clips to near and far alone. The scan clips to the sides of the screen. */
#include "../view/outcode.h"
#include "fixel/records.h"
#include "guard_band.h"

static fxl_clip_result clip(const fxl_model_view *model_view, const fxl_face *face,
                            fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    (void)work;
    return fxl_clip_with_guard_band(model_view, face, FXL_PLANES_DEPTH, screen);
}

/* place clipper: a new file beside it: the code and its record */
const fxl_clipper fxl_clipper_near = {.clip = clip, .workspace_size = sizeof(fxl_volume_workspace)};
