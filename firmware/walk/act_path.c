/* SPDX-License-Identifier: MIT */
/* The act of the walk: nothing but the camera moves. */
#include "act.h"

fxl_status act_open(const fxl_scene_image *image, const fxl_scene **scene)
{
    *scene = &image->scene;
    return FXL_OK;
}

fxl_status act_attach(fxl_renderer *renderer)
{
    (void)renderer;
    return FXL_OK;
}

fxl_status act_step(walk_path *path, uint32_t held)
{
    return walk_path_next(path, held);
}

fxl_status act_draw_over(const fxl_band *band, const fxl_lens *lens)
{
    (void)band;
    (void)lens;
    return FXL_OK;
}
