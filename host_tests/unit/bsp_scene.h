/* SPDX-License-Identifier: MIT */
/* The tiny scene with a tree over object 1: a cube of side 2, whose six planes cut what moves,
 * objects 0 and 2; and what a ray sees of the cubes first. */
#ifndef BSP_SCENE_H
#define BSP_SCENE_H

#include "tiny.h"

enum {
    BSP_NODES = 6
};

typedef struct {
    tiny_scene *tiny;
    fxl_bsp_node nodes[BSP_NODES];
} bsp_scene;

/* The scene anew; all objects on layer 0. Not checked yet. */
bsp_scene *bsp_make(void);

enum {
    BSP_WIDTH = 24, /* of the screen */
    BSP_HEIGHT = 16,
    BSP_BACKGROUND = 200
};

/* Turns the cube that moves, of a scene just made. */
void bsp_tilt(bsp_scene *made, fxl_angle yaw, fxl_angle pitch, fxl_angle roll);

/* Cubes somewhere about the tree's, mostly within it; the eye mostly outside of all. */
fxl_pose bsp_shuffle(bsp_scene *made);

typedef struct {
    double distance; /* of the nearest face that a ray hits */
    double margin;   /* by how much it was that one and no other, on the screen */
    uint8_t colour;
} bsp_sight;

/* Through the middle of a pixel, of the scene as it was tilted last. */
bsp_sight bsp_look(const bsp_scene *made, const fxl_pose *pose, uint32_t x, uint32_t y);

#endif
