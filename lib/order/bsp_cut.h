/* SPDX-License-Identifier: MIT */
/* Cuts an instance to the leaves of a BSP (docs/extras/bsp.md, section 3). Internal. */
#ifndef FXL_BSP_CUT_H
#define FXL_BSP_CUT_H

#include "bsp_pieces.h"

/* The state of one frame's cutting. Items grow upward and vertices downward in one memory. */
typedef struct {
    const fxl_scene *scene;
    const fxl_bsp_parts *parts;
    uint32_t capacity;                 /* bytes */
    uint32_t item_count, vertex_count; /* used */
    uint32_t first_item;               /* the first item of the instance that was cut last */
    uint32_t most;                     /* the most bytes in use at any time */
} fxl_bsp_cutter;

static inline uint32_t fxl_bsp_used(const fxl_bsp_cutter *cutter)
{
    return cutter->item_count * (uint32_t)sizeof(fxl_bsp_item) +
           cutter->vertex_count * (uint32_t)sizeof(fxl_bsp_vertex);
}

static inline fxl_bsp_vertex *fxl_bsp_vertex_of(const fxl_bsp_parts *parts, uint32_t number)
{
    return parts->vertices - 1 - number;
}

/* Cuts an instance. Items first_item <= i < item_count are then its pieces, each in a leaf, in
 * order of number. Returns false where memory is short, or a piece would have too many vertices;
 * then no piece is kept. */
bool fxl_bsp_cut(fxl_bsp_cutter *cutter, const fxl_instance *instance, const fxl_point *eye,
                 uint32_t entry);

#endif
