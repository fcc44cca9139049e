/* SPDX-License-Identifier: MIT */
/* Submission of a frame in the order of a BSP (docs/extras/bsp.md), and the functions that it
 * shares with the order by distance. */
#ifndef REF_SUBMIT_BY_BSP_H
#define REF_SUBMIT_BY_BSP_H

#include "reference/render.h"
#include "reference/split.h"

/* A face number for ref_submit_polygon: count the polygon, but do not draw it. */
#define REF_NO_FACE 0xFFFFFFFFu

/* Takes a polygon of the world to the display list, and counts its outcome. Returns false where
 * memory is short, as do the functions below. */
bool ref_submit_polygon(ref_renderer *renderer, const ref_polygon *whole, uint32_t instance,
                        uint32_t face, ref_counters *counters);

/* Takes a piece of a face, or all of it, to the display list: where beams reach it, in lit parts and dark
 * ones, each counted. */
bool ref_submit_piece(ref_renderer *renderer, const ref_piece *whole, uint32_t instance,
                      uint32_t face, ref_counters *counters);

/* Submits a face that faces the eye. */
bool ref_submit_face(ref_renderer *renderer, uint32_t instance, uint32_t face);

/* Submits an instance in its own order, and counts all its faces. */
bool ref_submit_instance(ref_renderer *renderer, uint32_t instance);

/* Submits the visible instances in their order, and those of the BSP's layer by the BSP. */
bool ref_submit_by_bsp(ref_renderer *renderer, const ref_order_entry *entries, uint32_t count);

#endif
