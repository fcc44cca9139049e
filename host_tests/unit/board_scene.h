/* SPDX-License-Identifier: MIT */
/* Tiny's scene, in which the second model has one face, whose instance shows a billboard. */
#ifndef BOARD_SCENE_H
#define BOARD_SCENE_H

#include "tiny_board.h"

enum {
    BOARD_SCENE_WIDTH = 32,
    BOARD_SCENE_HEIGHT = 24,
    BOARD_SPRITE_WIDTH = 11,
    BOARD_SPRITE_HEIGHT = 7,
    BOARD_LIST_WORDS = 120
};

/* The tables, which a test may change before board_scene_start. */
typedef struct {
    tiny_scene *tiny;
    fxl_sprite sprite;
    fxl_billboard board;
    fxl_billboard_set set;
    uint16_t model_map[2];
    uint8_t texels[BOARD_SPRITE_HEIGHT * BOARD_SPRITE_WIDTH];
    fxl_draw_entry order[TINY_INSTANCES];
    uint32_t list[BOARD_LIST_WORDS];
    fxl_renderer renderer;
    fxl_billboards billboards;
} board_scene;

/* The scene anew. The sprite has no key and is 4 x 3 units about its centre. Its pixels are 100 and
 * more. */
void board_scene_make(board_scene *scene);

/* Attaches the billboards to the renderer, which draws palette indices. */
fxl_status board_scene_attach(board_scene *scene);

/* Sets the renderer up, with so many words of a list, and attaches them. */
void board_scene_start(board_scene *scene, uint32_t words);

#endif
