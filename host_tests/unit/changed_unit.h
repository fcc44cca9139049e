/* SPDX-License-Identifier: MIT */
/* A world with everything attached that a renderer takes, for tests of what changed: cubes, a sorted
 * one with or without a tree, billboards, surfaces, light, beams, outlines, lines, colours, a horizon. */
#ifndef CHANGED_UNIT_H
#define CHANGED_UNIT_H

#include "unit.h"

enum {
    CHANGED_WIDTH = 48,
    CHANGED_HEIGHT = 40,
    CHANGED_CAPACITY = 8,
    CHANGED_TURNED = 5,
    CHANGED_PLACES = CHANGED_CAPACITY + CHANGED_TURNED,
    CHANGED_MODELS = 3, /* two cubes, the second one sorted, and a billboard */
    CHANGED_BOARDS = 2,
    CHANGED_TARGETS = 6,
    CHANGED_BEAMS = 4, /* of CHANGED_THINGS */
    CHANGED_OUTLINES = 6,
    CHANGED_LINES = 7,
    CHANGED_HORIZON = 8,
    CHANGED_THINGS = 9,
    CHANGED_KEPT =
        FXL_CHANGED_MEMORY(CHANGED_PLACES, CHANGED_TURNED, CHANGED_MODELS, CHANGED_BOARDS)
};

/* A target, and what draws into it. */
typedef struct {
    const fxl_target *target;
    const fxl_painter *painter;
    const fxl_sprite_painter *sprites;
} changed_target;

extern const changed_target *changed_into;
extern fxl_world changed_world;
extern fxl_renderer changed_renderer;
extern fxl_changed changed;
extern uint64_t changed_kept[CHANGED_KEPT];
extern uint16_t changed_colours[256];
extern uint8_t changed_sprite_pixels[CHANGED_BOARDS][5 * 4];
extern uint16_t changed_model_map[CHANGED_MODELS];
extern fxl_sprite changed_sprites[CHANGED_BOARDS];
extern fxl_billboard changed_boards[CHANGED_BOARDS];
extern fxl_handle changed_handles[CHANGED_PLACES];
extern uint32_t changed_handle_count;
extern fxl_pose changed_eye;

/* The palette, and all targets. */
extern const changed_target changed_palette, changed_targets[CHANGED_TARGETS];

/* A world and its renderer, with a lens, of a target at random, and a number of things attached. */
void changed_start(const fxl_lens *lens);

/* The same of a target, with nothing attached; with a tree if asked, whose memory has so many bytes. */
void changed_start_plain(const changed_target *into, const fxl_lens *lens, bool with_tree,
                         uint32_t tree_size);

/* Attaches or detaches one of CHANGED_THINGS: surfaces, light, light at corners, billboards, beams,
 * colours, outlines, lines, a horizon. Of two that do not go together one goes. */
void changed_attach(uint32_t thing, bool is_there);

fxl_pose changed_random_eye(void);

/* Draws a box of the frame into pixels that have its width, in the renderer's workspace or another one.
 * Answers the band that it drew. */
fxl_band changed_draw(uint16_t *pixels, const fxl_screen_box *box, fxl_workspace *core);

/* A change of the world, and of what billboards show. A world refuses some. */
void changed_change_world(void);
void changed_change_billboards(void);

#endif
