/* SPDX-License-Identifier: MIT */
/* The act of the walk: the camera follows the scene's path, and what has a motion moves. */
#include "act.h"

#include "fixel/motion.h"

static fxl_motion_player motion;
static bool moves;

uint32_t act_bytes(const fxl_scene_image *image)
{
    const fxl_scene *scene = &image->scene;

    if (image->motion.motion_count == 0) {
        return 0;
    }
    return (scene->instance_count * (uint32_t)sizeof(fxl_instance) +
            (scene->instance_count - scene->first_turned) * (uint32_t)sizeof(fxl_placement) + 7u) &
           ~7u;
}

/* Motions move copies of the instances. */
fxl_status act_open(fxl_scene_image *image, void *memory, const fxl_scene **scene)
{
    fxl_scene *of = &image->scene;
    fxl_motion_memory copies;

    *scene = of;
    moves = image->motion.motion_count > 0;
    if (!moves) {
        return FXL_OK;
    }
    copies.instances = memory;
    copies.instance_capacity = of->instance_count;
    copies.placements = (fxl_placement *)(void *)(copies.instances + of->instance_count);
    copies.placement_capacity = of->instance_count - of->first_turned;
    return fxl_motion_begin(&motion, &image->motion, of, &copies);
}

fxl_status act_attach(fxl_renderer *renderer)
{
    (void)renderer;
    return FXL_OK;
}

fxl_status act_step(walk_path *path, uint32_t frame, uint32_t held)
{
    if (moves) {
        fxl_motion_play(&motion, frame);
    }
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
