/* SPDX-License-Identifier: MIT */
/* The tiny scene with a tree over object 1: a cube of side 2, whose six planes cut what moves,
 * objects 0 and 2. */
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

#endif
