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
    const ref_turn *turns = scene->turns;
    moving->instances = calloc(scene->instance_count, sizeof *moving->instances);
    moving->turns = calloc(turned, sizeof *moving->turns);
    scene->instances = calloc(scene->instance_count, sizeof *scene->instances);
    scene->turns = calloc(turned, sizeof *scene->turns);
    if (!moving->instances || !moving->turns || !scene->instances || !scene->turns) {
        return false;
    }
    memcpy(scene->instances, instances, scene->instance_count * sizeof *instances);
    memcpy(scene->turns, turns, turned * sizeof *turns);
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
    const fxl_motion_memory memory = {moving->instances, of->scene.instance_count, moving->turns,
                                      turned};
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
        const fxl_placement *turn = &moving->turns[i - scene->first_turned];
        ref_turn *to = &scene->turns[i - scene->first_turned];
        scene->instances[i].centre = (ref_lattice_point){centre->x, centre->y, centre->z};
        _Static_assert(sizeof to->rows == sizeof turn->orientation, "nine entries each");
        memcpy(to->rows, &turn->orientation, sizeof to->rows);
        to->scale = turn->scale;
    }
}

void moving_reference_close(moving_reference *moving)
{
    if (moving->moves) { /* else they are the image's */
        free(moving->scene.instances);
        free(moving->scene.turns);
    }
    free(moving->instances);
    free(moving->turns);
    memset(moving, 0, sizeof *moving);
}
