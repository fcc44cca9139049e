/* SPDX-License-Identifier: MIT */
/* Near and far alone; the scan does the rest. */
#include "beyond.h"

#define SCREEN (1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR)

static fxl_clip_result clip(const fxl_placed *placed, const fxl_face *face, fxl_clipper_work *work,
                            fxl_screen_polygon *screen)
{
    (void)work;
    return fxl_clip_beyond(placed, face, SCREEN, screen);
}

const fxl_clipper fxl_clipper_near = {clip, NULL, sizeof(fxl_volume_room)};
