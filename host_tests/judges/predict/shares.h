/* SPDX-License-Identifier: MIT */
/* The memory of a board: bytes of records, and how the walk shares it. */
#ifndef PREDICT_SHARES_H
#define PREDICT_SHARES_H

#include <stdbool.h>

#include "fixel/scene.h"

/* Bytes of records on a core of 32 bits. host_tests/tools/test_predict.py has the compiler for
 * boards compare them. */

enum {
    ARM_INSTANCE = 16,      /* fxl_instance */
    ARM_PLACEMENT = 40,     /* fxl_placement */
    ARM_POINT = 12,         /* fxl_point */
    ARM_BEAM_LIGHT = 40,    /* what lib/draw/beam_light.c has at the start of its workspace */
    ARM_LIT_PIECES = 28,    /* fxl_lit_pieces */
    ARM_LIT_PIECE = 6,      /* fxl_lit_piece */
    ARM_SURFACE_SET = 56,   /* fxl_surface_set */
    ARM_TEXTURE = 16,       /* fxl_texture */
    ARM_BILLBOARD_SET = 12, /* fxl_billboard_set */
    ARM_BILLBOARD = 20,     /* fxl_billboard */
    ARM_SPRITE = 16,        /* fxl_sprite */
    ARM_BSP_WORKSPACE = 36, /* fxl_bsp_workspace */
    ARM_BSP_ITEM = 12       /* fxl_bsp_item */
};

/* How the walk on a board shares the display list's memory: firmware/walk/plan.c. In bytes,
 * multiples of 8, with records as an Armv6-M or Armv7-M has them. */

/* What motions, beams, surfaces, billboards and a palette of RGB565 take. */
uint32_t taken_bytes(const fxl_scene_image *image);

/* What the order by tree takes of so much; may be more. 0: the scene is drawn by distance. */
uint32_t tree_bytes(const fxl_scene_image *image, uint32_t room);

/* Whether a scene is drawn by its tree. */
bool draws_by_tree(const fxl_scene_image *image);

/* What a depth buffer takes of so much; may be more. 0: the scene is drawn without one. */
uint32_t depth_bytes(const fxl_scene_image *image, uint32_t room);

#endif
