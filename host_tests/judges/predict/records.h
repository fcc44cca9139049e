/* SPDX-License-Identifier: MIT */
/* Bytes of records on a core of 32 bits. host_tests/tools/test_predict.py has the compiler for
 * boards compare them. */
#ifndef PREDICT_RECORDS_H
#define PREDICT_RECORDS_H

enum {
    ARM_INSTANCE = 16,      /* fxl_instance */
    ARM_PLACEMENT = 40,     /* fxl_placement */
    ARM_POINT = 12,         /* fxl_point */
    ARM_BEAM_LIGHT = 40,    /* what lib/draw/beam_light.c has at the start of its workspace */
    ARM_LIT_PIECES = 28,    /* fxl_lit_pieces */
    ARM_LIT_PIECE = 6,      /* fxl_lit_piece */
    ARM_SURFACE_SET = 48,   /* fxl_surface_set */
    ARM_TEXTURE = 16,       /* fxl_texture */
    ARM_BILLBOARD_SET = 12, /* fxl_billboard_set */
    ARM_BILLBOARD = 20,     /* fxl_billboard */
    ARM_SPRITE = 16,        /* fxl_sprite */
    ARM_BSP_WORKSPACE = 36, /* fxl_bsp_workspace */
    ARM_BSP_ITEM = 12       /* fxl_bsp_item */
};

#endif
