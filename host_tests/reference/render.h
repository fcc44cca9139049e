/* SPDX-License-Identifier: MIT */
/* The frame loop (SPEC.md 4), in double. */
#ifndef REF_RENDER_H
#define REF_RENDER_H

#include "reference/frustum.h"
#include "reference/order.h"

/* A polygon that was drawn: its outline as the twin has it, and where it came
 * from. */
typedef struct {
    ref_screen_polygon polygon;
    uint32_t object, face; /* numbers in the scene and in the model */
} ref_drawn;

typedef struct {
    const ref_scene *scene;
    ref_lens lens;
    ref_camera camera;
    ref_frustum frustum;
    ref_lattice_point eye;
    ref_order_entry *objects, *faces;
    ref_counters counters;
    ref_drawn *drawn; /* the frame's polygons in the order of drawing */
    size_t drawn_count, drawn_capacity;
} ref_renderer;

/* False where memory is short. The scene must outlive the renderer. */
bool ref_renderer_init(ref_renderer *renderer, const ref_scene *scene, const ref_lens *lens);
void ref_renderer_close(ref_renderer *renderer);

/* Works out everything that the frame draws: fills drawn and counters. False
 * where memory is short. */
bool ref_frame_begin(ref_renderer *renderer, const ref_pose *pose);

/* Draws the frame's polygons over a band that the caller has cleared. */
void ref_frame_draw(const ref_renderer *renderer, const ref_band *band);

#endif
