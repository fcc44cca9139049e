/* SPDX-License-Identifier: MIT */
/* Clips to near, far and the left side of the screen, so no span begins left of it. The scan
 * shortens spans on the right and skips rows above and below. */
#include "../view/outcode.h"
#include "fixel/records.h"
#include "guard_band.h"

#define SCREEN (FXL_PLANES_DEPTH | 1u << FXL_PLANE_LEFT)

static fxl_clip_result clip(const fxl_model_view *model_view, const fxl_face *face,
                            fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    (void)work;
    return fxl_clip_with_guard_band(model_view, face, SCREEN, screen);
}

const fxl_clipper fxl_clipper_left = {.clip = clip, .workspace_size = sizeof(fxl_volume_workspace)};
