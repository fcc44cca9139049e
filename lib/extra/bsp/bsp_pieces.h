/* SPDX-License-Identifier: MIT */
/* What is in the leaves of a tree: pieces of objects that move, or such objects whole. Internal. */
#ifndef FXL_BSP_PIECES_H
#define FXL_BSP_PIECES_H

#include "fixel/extra/bsp.h"
#include "../../src/draw/submit.h"

/* No item, no vertex. */
#define FXL_ITEM_NONE 0xFFFFu

/* A piece, or an object drawn whole. */
typedef struct {
    uint32_t where; /* a node; or FXL_IN_LEAF and the leaf */
    uint16_t next;  /* in the leaf, in the order of the walk */
    uint16_t entry; /* the object's place in the order */
    uint16_t first; /* vertex; FXL_ITEM_NONE: the whole object */
    uint8_t count, colour;
} fxl_bsp_item;

/* A leaf is a side of a node: twice its number, and 1 behind it. */
#define FXL_IN_LEAF ((uint32_t)1 << 31)

/* The parts of the room, and how much of the pieces' room is used. */
typedef struct {
    uint32_t *sides;                 /* a bit for each node: the eye is in front */
    uint32_t *busy;                  /* a bit for each node: there are items below it */
    uint16_t *leaves;                /* for each leaf its first item */
    fxl_bsp_item *whole;             /* items 0 .. movers - 1 */
    fxl_bsp_item *items;             /* the others, upward from the pieces' room's beginning */
    struct fxl_bsp_vertex *vertices; /* 0 is the last that fits, the others go downward */
    uint32_t movers;                 /* those that the room is sized for */
} fxl_bsp_parts;

typedef struct fxl_bsp_vertex {
    fxl_point point;
    uint16_t next; /* round the piece */
    uint16_t unused;
} fxl_bsp_vertex;

fxl_bsp_parts fxl_bsp_parts_of(const fxl_scene *scene, fxl_bsp_workspace *workspace);

/* Objects other than the tree's on its layer. */
uint32_t fxl_bsp_movers(const fxl_scene *scene);

/* Cuts the movers of the frame to the leaves, and counts their faces. */
void fxl_bsp_cut_movers(const fxl_traversal *on, fxl_bsp_workspace *workspace);

/* Gives what is in a leaf to the walk, from place->index and place->face on. False where it
 * was stopped. */
bool fxl_submit_bsp_leaf(const fxl_traversal *on, fxl_bsp_workspace *workspace, uint32_t leaf,
                         fxl_bsp_resume_point *place);

#endif
