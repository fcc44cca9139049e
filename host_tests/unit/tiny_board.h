/* SPDX-License-Identifier: MIT */
/* A billboard for the second model of tiny.h's scene. */
#ifndef TINY_BOARD_H
#define TINY_BOARD_H

#include "fixel/billboards.h"
#include "tiny.h"

/* A sprite without a key, 4 x 3 units about its centre. Its pixels are 100 and more. */
static inline void tiny_board(fxl_billboard_set *set, fxl_billboard *board, uint16_t model_map[2],
                              fxl_sprite *sprite, uint8_t *texels, uint16_t width, uint16_t height)
{
    for (uint32_t i = 0; i < (uint32_t)width * height; i++) {
        texels[i] = (uint8_t)(100 + i);
    }
    *sprite = (fxl_sprite){texels, NULL, width, height, 8, FXL_SPRITE_OPAQUE};
    *board = (fxl_billboard){sprite, Q16(4), Q16(3), Q16(2), Q16(1.5)};
    model_map[0] = 0;
    model_map[1] = 1;
    *set = (fxl_billboard_set){board, 1, model_map};
}

#endif
