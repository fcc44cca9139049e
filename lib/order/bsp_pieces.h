/* SPDX-License-Identifier: MIT */
/* The items in the leaves of a BSP: pieces of instances that move, or such instances whole.
 * Internal. */
#ifndef FXL_BSP_PIECES_H
#define FXL_BSP_PIECES_H

#include "../draw/submit.h"
#include "fixel/order.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The number that stands for no item or no vertex. */
#define FXL_ITEM_NONE 0xFFFFu

/* An item: a piece of a face, or an instance drawn whole. */
typedef struct {
    uint32_t where; /* a node; or FXL_IN_LEAF | the leaf */
    uint16_t next;  /* the next item in the leaf, in the order of traversal */
    uint16_t entry; /* the instance's entry in the order */
    uint16_t first; /* the first vertex; FXL_ITEM_NONE: the whole instance */
    uint8_t count, colour;
} fxl_bsp_item;

/* A leaf is a side of a node. Its number is twice the number of the node, plus 1 for the side
 * behind. */
#define FXL_IN_LEAF ((uint32_t)1 << 31)

/* The arrays in the workspace. */
typedef struct {
    uint32_t *sides;     /* a bit for each node: the eye is in front of it */
    uint32_t *busy;      /* a bit for each node: there are items below it */
    uint16_t *leaves;    /* the first item of each leaf */
    fxl_bsp_item *whole; /* items 0 .. movers - 1 */
    fxl_bsp_item *items; /* the other items, upward from the beginning of the memory for pieces */
    struct fxl_bsp_vertex *vertices; /* from the end of that memory downward */
    uint32_t movers;                 /* the moving instances that the workspace is sized for */
} fxl_bsp_parts;

typedef struct fxl_bsp_vertex {
    fxl_point point;
    uint16_t next; /* the next vertex around the piece */
    uint16_t face; /* of the model, whose piece this is */
} fxl_bsp_vertex;

fxl_bsp_parts fxl_bsp_parts_of(const fxl_scene *scene, fxl_bsp_workspace *workspace);

/* Whether an entry of the order shows a billboard instead of faces. */
bool fxl_bsp_shows_billboard(const fxl_renderer *renderer, const fxl_draw_entry *entry);

/* Returns how many instances other than the BSP's are on its layer. */
uint32_t fxl_bsp_movers(const fxl_scene *scene);

/* Cuts the moving instances of the frame to the leaves, and counts their faces. */
void fxl_bsp_cut_movers(const fxl_traversal *traversal, fxl_bsp_workspace *workspace);

/* Submits the items of a leaf, from place->index and place->face on. Returns false where a face
 * sink stopped the traversal. */
bool fxl_submit_bsp_leaf(const fxl_traversal *traversal, fxl_bsp_workspace *workspace,
                         uint32_t leaf, fxl_bsp_resume_point *place);

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

/* fxl_order.submit and .memory_size of fxl_by_tree. */
bool fxl_submit_by_bsp(const fxl_traversal *traversal);
uint32_t fxl_bsp_workspace_size(const fxl_scene *scene);

#ifdef __cplusplus
}
#endif

#endif
