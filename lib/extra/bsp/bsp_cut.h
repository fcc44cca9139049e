/* SPDX-License-Identifier: MIT */
/* Cuts an object to the leaves of a tree (docs/extras/bsp.md, section 3). Internal. */
#ifndef FXL_BSP_CUT_H
#define FXL_BSP_CUT_H

#include "bsp_pieces.h"

/* A frame's cutting. Items and vertices grow towards each other. */
typedef struct {
    const fxl_scene *scene;
    const fxl_bsp_parts *parts;
    uint32_t capacity;                 /* bytes */
    uint32_t item_count, vertex_count; /* used */
    uint32_t first_item;               /* of the object that was cut last */
    uint32_t most;                     /* bytes used at any time */
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

/* Items from first_item to item_count are then the object's pieces, in leaves, by number.
 * False where they have no room, or a piece too many vertices: then nothing of it is kept. */
bool fxl_bsp_cut(fxl_bsp_cutter *cutter, const fxl_instance *instance, const fxl_point *eye,
                 uint32_t entry);

#endif
