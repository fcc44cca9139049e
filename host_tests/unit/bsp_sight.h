/* SPDX-License-Identifier: MIT */
/* Cubes that move through the tree's cube, and what a ray sees of them first. */
#ifndef BSP_SIGHT_H
#define BSP_SIGHT_H

#include "bsp_scene.h"

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
