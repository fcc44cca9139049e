/* SPDX-License-Identifier: MIT */
/* A world over the tiny scene, and a renderer that draws it. */
#ifndef WORLD_UNIT_H
#define WORLD_UNIT_H

#include "tiny.h"

enum {
    WORLD_WIDTH = 32,
    WORLD_HEIGHT = 24,
    WORLD_BACKGROUND = 200,
    WORLD_CAPACITY = 9,
    WORLD_TURNED = 5,
    WORLD_PLACES = WORLD_CAPACITY + WORLD_TURNED,
    WORLD_LIST = 3 * FXL_DISPLAY_LIST_WORDS(6) /* not enough for a frame */
};

extern fxl_world world;
extern fxl_renderer world_renderer;
extern fxl_instance world_instances[WORLD_PLACES];
extern uint8_t world_colours[2 * 256];
extern uint8_t world_frames[2][WORLD_WIDTH * WORLD_HEIGHT];

/* Of the world, and of renderer 0 or 1. */
fxl_world_memory world_memory(void);
fxl_memory world_renderer_memory(int number);

/* The tiny scene, checked. */
tiny_scene *world_scene(void);

/* A world over it, drawn by world_renderer, which is attached. Returns the scene. */
tiny_scene *world_start(void);

fxl_instance world_cube_at(double x, double z);

/* Spawns what must be spawned. */
fxl_handle world_spawned(const fxl_instance *instance, const fxl_placement *placement);

/* A frame, from its beginning to its end. */
void world_draw(fxl_renderer *by, const fxl_pose *pose, uint8_t *frame);

/* Every function that takes a handle tells that it is stale. Returns the number of calls. */
uint32_t world_use_stale(fxl_handle handle);

#endif
