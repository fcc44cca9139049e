/* SPDX-License-Identifier: MIT */
/* A frame in the order of a tree (docs/extras/bsp.md), and what it shares with other orders. */
#ifndef REF_RENDER_BSP_H
#define REF_RENDER_BSP_H

#include "reference/render.h"

/* For ref_submit_polygon: count it, and draw nothing. */
#define REF_NO_FACE 0xFFFFFFFFu

/* A polygon of the world, from there to the list; what became of it is counted. False where
 * memory is short, here and below. */
bool ref_submit_polygon(ref_renderer *renderer, const ref_polygon *whole, uint32_t instance,
                        uint32_t face, ref_counters *counters);

/* A face that faces the eye. */
bool ref_submit_face(ref_renderer *renderer, uint32_t instance, uint32_t face);

/* An object in its own order, all faces counted. */
bool ref_submit_instance(ref_renderer *renderer, uint32_t instance);

/* The objects in sight, in their order; those of the tree's layer by the tree. */
bool ref_submit_by_bsp(ref_renderer *renderer, const ref_order_entry *entries, uint32_t count);

#endif
