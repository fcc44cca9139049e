/* SPDX-License-Identifier: MIT */
/* What the harnesses of whole frames share that take no byte of the input: memory of a frame, what is
 * attached to its renderer, and chance. Nothing of it is recorded. */
#ifndef ANY_FRAME_H
#define ANY_FRAME_H

#include <string.h>

#include "answers.h"
#include "parts.h"

/* --- chance ----------------------------------------------------------------------------------- */

/* Begins with the bytes that are left of the input, of which none is taken. */
void chance_begin(const fxl_lens *lens, const fxl_pose *pose, const fuzz_input *in);

/* 0 .. count - 1; of 0: 0. */
uint32_t any(uint32_t count);

static inline bool one_in(uint32_t count)
{
    return any(count) == 0;
}

/* A point before the eye, mostly, so far away and beside it. */
fxl_point any_point(const fxl_view *view);

/* Pixels a world unit of an orthographic lens, 1/16 .. 4096, of which most show some of the scene. */
fxl_q16_16 any_scale(void);

/* --- lines ------------------------------------------------------------------------------------ */

enum {
    MODEL_LINES = 8 /* at most */
};

typedef struct {
    fxl_line lines[MODEL_LINES * MADE_MODELS];
    uint32_t map[MADE_MODELS + 1];
    fxl_line_set set;
    fxl_lines attached;
} some_lines;

/* Lines of each model, or of most: edges on one face or two, free lines, points. */
void make_lines(some_lines *made, const fxl_scene *scene);

/* --- memory of a frame ------------------------------------------------------------------------ */

/* Memory for any order and target, and for the beams of a scene, and a palette. */
typedef struct {
    void *order, *depth, *tree, *beams;
    uint32_t entries, depth_size, tree_size, beams_size;
    uint16_t palette[256];
} draw_room;

/* more: entries of the order beyond the scene's. */
void draw_open_room(draw_room *room, const fxl_scene *scene, const fxl_lens *lens, uint32_t more);
void draw_close_room(draw_room *room);

/* Begins a renderer anew; its order and target are then to be chosen. */
void draw_init(fxl_renderer *renderer, const draw_room *room, const fxl_scene *scene,
               const fxl_lens *lens);

/* order: null is that by distance. */
void draw_choose_in(fxl_renderer *renderer, const draw_room *room, const fxl_order *order,
                    const fxl_target *target);

/* --- what is attached ------------------------------------------------------------------------- */

/* Each attaches what any scene may have, or, where is_there is false, detaches it. */
void attach_light(fxl_renderer *renderer, fxl_light *light, bool is_there);
void attach_outlines(fxl_renderer *renderer, fxl_outlines *outlines, bool is_there);
void attach_horizon(fxl_renderer *renderer, bool is_there);

/* Nothing, where the scene has no beams. */
void attach_beams(fxl_renderer *renderer, const draw_room *room, bool is_there);

#endif
