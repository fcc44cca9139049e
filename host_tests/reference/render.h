/* SPDX-License-Identifier: MIT */
/* The frame loop (SPEC.md, section 4), in double. */
#ifndef REF_RENDER_H
#define REF_RENDER_H

#include "reference/clipper.h"
#include "reference/display_list.h"
#include "reference/order.h"
#include "reference/sphere.h"

typedef struct {
    const ref_scene *scene;
    ref_lens lens;
    ref_camera camera;
    ref_frustum frustum; /* what cuts */
    ref_view_frustum view_frustum;
    ref_lattice_point eye;
    ref_order_entry *instances, *faces;
    unsigned cuts; /* of the planes, those that cut: REF_CUT_ALL unless set between frames */
    ref_counters counters;
    ref_display_list list; /* the frame's polygons */
    bool keeps_doubt;      /* set before a frame: the list tells what depends on rounding */
    bool by_bsp;      /* set before a frame: what hides what is the scene's tree, if it has one */
    uint32_t unsplit; /* objects of the frame that were not cut to the tree */
} ref_renderer;

/* False where memory is short. The scene must outlive the renderer. */
bool ref_renderer_init(ref_renderer *renderer, const ref_scene *scene, const ref_lens *lens);
void ref_renderer_close(ref_renderer *renderer);

/* Works out everything that the frame draws: fills list and counters. False
 * where memory is short. */
bool ref_frame_begin(ref_renderer *renderer, const ref_pose *pose);

/* Draws the frame's polygons that reach it over a band that the caller has cleared. */
void ref_frame_draw(const ref_renderer *renderer, const ref_band *band);

#endif
