/* SPDX-License-Identifier: MIT */
/* The act of the walk: the camera follows the scene's path, and what has a motion moves. */
#include "act.h"

uint32_t act_bytes(const fxl_scene_image *image)
{
    (void)image;
    return 0;
}

fxl_status act_open(const fxl_scene_image *image, void *memory, fxl_setup_plan *plan)
{
    (void)memory;
    if (image->motion.motion_count > 0) {
        plan->motions = &image->motion;
        plan->begin_motions = fxl_motion_begin;
        plan->play_motions = fxl_motion_play;
    }
    return FXL_OK;
}

fxl_status act_attach(fxl_renderer *renderer)
{
    (void)renderer;
    return FXL_OK;
}

fxl_status act_step(fxl_setup *setup, walk_path *path, uint32_t frame, uint32_t held)
{
    (void)fxl_setup_frame(setup, frame);
    return walk_path_next(path, held);
}

fxl_status act_draw_over(const fxl_band *band, const fxl_lens *lens)
{
    (void)band;
    (void)lens;
    return FXL_OK;
}

fxl_status act_end(fxl_renderer *renderer)
{
    (void)renderer;
    return FXL_OK;
}
