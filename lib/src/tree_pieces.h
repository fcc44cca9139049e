/* SPDX-License-Identifier: MIT */
/* What is in the leaves of a tree: pieces of objects that move, or such objects whole. Internal. */
#ifndef FXL_TREE_PIECES_H
#define FXL_TREE_PIECES_H

#include "fixel/tree.h"
#include "walk.h"

/* No item, no vertex. */
#define FXL_ITEM_NONE 0xFFFFu

/* A piece, or an object drawn whole. */
typedef struct {
    uint32_t where; /* a node; or FXL_IN_LEAF and the leaf */
    uint16_t next;  /* in the leaf, in the order of the walk */
    uint16_t entry; /* the object's place in the order */
    uint16_t first; /* vertex; FXL_ITEM_NONE: the whole object */
    uint8_t count, colour;
} fxl_tree_item;

/* A leaf is a side of a node: twice its number, and 1 behind it. */
#define FXL_IN_LEAF ((uint32_t)1 << 31)

/* The parts of the room, and how much of the pieces' room is used. */
typedef struct {
    uint32_t *sides;                  /* a bit for each node: the eye is in front */
    uint32_t *busy;                   /* a bit for each node: there are items below it */
    uint16_t *leaves;                 /* for each leaf its first item */
    fxl_tree_item *whole;             /* items 0 .. movers - 1 */
    fxl_tree_item *items;             /* the others, upward from the pieces' room's beginning */
    struct fxl_tree_vertex *vertices; /* 0 is the last that fits, the others go downward */
    uint32_t movers;                  /* those that the room is sized for */
} fxl_tree_parts;

typedef struct fxl_tree_vertex {
    fxl_point point;
    uint16_t next; /* round the piece */
    uint16_t unused;
} fxl_tree_vertex;

fxl_tree_parts fxl_tree_parts_of(const fxl_scene *scene, fxl_tree_room *room);

/* Objects other than the tree's on its layer. */
uint32_t fxl_tree_movers(const fxl_scene *scene);

/* Cuts the movers of the frame to the leaves, and counts their faces. */
void fxl_tree_cut_movers(const fxl_walk *on, fxl_tree_room *room);

/* Gives what is in a leaf to the walk, from place->index and place->face on. False where it
 * was stopped. */
bool fxl_tree_walk_leaf(const fxl_walk *on, fxl_tree_room *room, uint32_t leaf,
                        fxl_tree_place *place);

#endif
