/* SPDX-License-Identifier: MIT */
/* What hides what, by a tree (docs/extras/bsp.md): exact for what stands still, and for
 * convex objects that move about in it, which are cut to the tree's leaves. Source: chapter
 * 65 (A14). */
#ifndef FXL_BSP_H
#define FXL_BSP_H

#include "fixel/stage/visibility.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How far a walk has come in a tree. */
typedef struct {
    uint16_t node;
    uint16_t index; /* of the node's faces, or of what is in the leaf, so many are done */
    uint16_t face;  /* and so many faces of an object in the leaf */
    uint16_t phase;
} fxl_bsp_resume_point;

/* The room that fxl_visibility_bsp works in begins with this; what follows is sized by the
 * method's walk_room. The caller may set the first two between two frames, after
 * fxl_renderer_set_visibility, which clears them; the rest is for reading only. */
typedef struct {
    void *pieces;         /* room for pieces of objects that move; null: none */
    uint32_t pieces_size; /* bytes: aligned to four; 12 a piece and 16 a vertex of one */
    uint32_t unsplit; /* objects of this frame that were drawn whole: their pieces had no room */
    uint32_t used;    /* bytes of pieces that this frame took at most */
    uint32_t refused; /* pieces of this frame that could not be drawn, out of range when cut */
    fxl_bsp_resume_point rest; /* where the list was full */
    uint16_t first, end;       /* the order's entries of the tree's layer */
    uint16_t owner;            /* the tree's object in the order; 0xFFFF: not in sight */
    uint16_t movers;           /* other entries of its layer */
} fxl_bsp_workspace;

/* Objects by layer and distance, but for the layer of the tree's object, which is drawn by its
 * tree, far to near, one over another. A scene without a tree is drawn as by fxl_visibility_sorted.
 * Objects that move do so by their table's centre, which is to stay in range with every vertex.
 * Its room is 36 bytes, a bit for each node, and where other objects are on the tree's
 * layer, another bit and 4 bytes for each node and 12 for each of them. */
extern const fxl_visibility fxl_visibility_bsp;

/* The same near to far into a span buffer; its room is behind the tree's. */
extern const fxl_visibility fxl_visibility_bsp_spans;

#ifdef __cplusplus
}
#endif

#endif
