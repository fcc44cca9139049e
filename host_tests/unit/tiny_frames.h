/* SPDX-License-Identifier: MIT */
/* Frames of tiny.h's scene: renderers, placements, random poses about the cubes, and a billboard in
 * the place of the second model. */
#ifndef TINY_FRAMES_H
#define TINY_FRAMES_H

#include <math.h>

#include "tiny.h"
#include "fixel/billboards.h"

/* Checks the scene, and initialises a renderer of it with the tests' standard lens. */
void tiny_start(fxl_renderer *renderer, tiny_scene *tiny, uint16_t width, uint16_t height,
                const fxl_memory *memory);

/* Turns the instances from first on by placements that turn nothing; TINY_INSTANCES: none has a
 * placement. */
void tiny_place_from(tiny_scene *tiny, fxl_placement placements[TINY_INSTANCES], uint32_t first);

/* Between and beside the cubes, where many faces are cut; turned any way. */
fxl_pose tiny_pose_between(void);

/* Before, between and beside the cubes, and mostly turned to some of them. */
fxl_pose tiny_pose_about(void);

/* The three cubes are ahead, often one behind another. */
fxl_pose tiny_pose_before(void);

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

/* place sampling: definition: exact_sprite_texel */
/* The texel at a pixel's centre, or -1; -2 where a corner's rounding may decide. */
static inline int exact_sprite_texel(double at, double from, double end, int texels_of_side)
{
    const double place = (at - from) / (end - from) * texels_of_side;
    const double unsure = 4 * (texels_of_side + fabs(place)) / ((end - from) * 65536);
    if (fabs(place - floor(place + 0.5)) < unsure) {
        return -2;
    }
    return place < 0 || place > texels_of_side ? -1 : (int)place;
}

/* The scene anew. The sprite has no key and is 4 x 3 units about its centre. Its pixels are 100 and
 * more. */
void board_scene_make(board_scene *scene);

/* Attaches the billboards to the renderer, which draws palette indices. */
fxl_status board_scene_attach(board_scene *scene);

/* Sets the renderer up, with so many words of a list, and attaches them. */
void board_scene_start(board_scene *scene, uint32_t words);

#endif
