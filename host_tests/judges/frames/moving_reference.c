/* SPDX-License-Identifier: MIT */
#include "frames/moving_reference.h"

#include <stdlib.h>
#include <string.h>

/* The library's copies, and the reference's. */
static bool reserve(moving_reference *moving)
{
    ref_scene *scene = &moving->scene;
    const uint32_t turned = scene->instance_count - scene->first_turned;
    const ref_instance *instances = scene->instances;
    const ref_placement *placements = scene->placements;
    moving->instances = calloc(scene->instance_count, sizeof *moving->instances);
    moving->placements = calloc(turned, sizeof *moving->placements);
    scene->instances = calloc(scene->instance_count, sizeof *scene->instances);
    scene->placements = calloc(turned, sizeof *scene->placements);
    if (!moving->instances || !moving->placements || !scene->instances || !scene->placements) {
        return false;
    }
    memcpy(scene->instances, instances, scene->instance_count * sizeof *instances);
    memcpy(scene->placements, placements, turned * sizeof *placements);
    return true;
}

bool moving_reference_open(moving_reference *moving, const ref_scene_image *of,
                           const uint8_t *bytes, size_t size)
{
    fxl_scene_image opened;
    memset(moving, 0, sizeof *moving);
    moving->scene = of->scene;
    if (!of->motion_count) {
        return true;
    }
    moving->moves = true;
    if (!reserve(moving) || fxl_scene_open(bytes, size, &opened, NULL) != FXL_OK) {
        return false;
    }
    moving->moved = opened.scene;
    const uint32_t turned = of->scene.instance_count - of->scene.first_turned;
    const fxl_motion_memory memory = {moving->instances, of->scene.instance_count,
                                      moving->placements, turned};
    return fxl_motion_begin(&moving->player, &opened.motion, &moving->moved, &memory) == FXL_OK;
}

void moving_reference_play(moving_reference *moving, uint32_t frame)
{
    if (!moving->moves) {
        return;
    }
    ref_scene *scene = &moving->scene;
    fxl_motion_play(&moving->player, frame);
    for (uint32_t i = scene->first_turned; i < scene->instance_count; i++) {
        const fxl_point *centre = &moving->instances[i].centre;
        const fxl_placement *placement = &moving->placements[i - scene->first_turned];
        ref_placement *to = &scene->placements[i - scene->first_turned];
        scene->instances[i].centre = (ref_lattice_point){centre->x, centre->y, centre->z};
        _Static_assert(sizeof to->rows == sizeof placement->orientation, "nine entries each");
        memcpy(to->rows, &placement->orientation, sizeof to->rows);
        to->scale = placement->scale;
    }
}

void moving_reference_close(moving_reference *moving)
{
    if (moving->moves) { /* else they are the image's */
        free(moving->scene.instances);
        free(moving->scene.placements);
    }
    free(moving->instances);
    free(moving->placements);
    memset(moving, 0, sizeof *moving);
}
