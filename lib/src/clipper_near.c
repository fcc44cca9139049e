/* SPDX-License-Identifier: MIT */
/* Near and far alone; the scan does the rest. */
#include "beyond.h"

#define SCREEN (1u << FXL_PLANE_NEAR | 1u << FXL_PLANE_FAR)

static fxl_seen_vertex *see(const fxl_placed *placed, uint32_t number)
{
    return fxl_beyond_see(placed, number, SCREEN);
}

static fxl_clip_result cut(const fxl_placed *placed, const fxl_clip_polygon *in, unsigned any,
                           const fxl_clip_polygon **result)
{
    return fxl_beyond_cut(placed, in, any, SCREEN, result);
}

static fxl_clip_result clip(const fxl_placed *placed, const fxl_face *face, fxl_clipper_work *work,
                            fxl_screen_polygon *screen)
{
    static const fxl_way way = {see, fxl_beyond_project, fxl_beyond_input, cut,
                                SCREEN | FXL_FAMILY_BEYOND}; /* bug: near-to-scan */
    (void)work;
    fxl_beyond_set_up(placed, SCREEN);
    return fxl_family_take(placed, face, screen, &way);
}

const fxl_clipper fxl_clipper_near = {clip, NULL, sizeof(fxl_volume_room)};
