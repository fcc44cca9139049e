/* SPDX-License-Identifier: MIT */
/* Orders of drawing. Each is one constant record, and a program links only those that it names. */
#ifndef FXL_ORDER_H
#define FXL_ORDER_H

#include "fixel/scene.h"
#include "fixel/target.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fxl_traversal fxl_traversal; /* lib/draw/submit.h, which is internal */

/* An order of drawing. Members are internal. */
typedef struct fxl_order {
    /* Submits every face from the traversal's resume point on, in the order of drawing, or, if the
     * renderer draws near_first, in its exact reverse. Returns false if it was stopped: the resume
     * point is then the face for which there was no space. */
    bool (*submit)(const fxl_traversal *traversal);
    /* The least size of its memory, in bytes. Null: it needs none. */
    uint32_t (*memory_size)(const fxl_scene *scene);
    /* Gives a renderer the order, and the target. Null: the order needs no memory. */
    fxl_status (*choose)(fxl_renderer *renderer, const struct fxl_config *config);
} fxl_order;

/* Instances by layer and distance, the faces of a sorted model by distance, far to near. */
extern const fxl_order fxl_by_distance;

/* --- by tree ------------------------------------------------------------------------------ */

/* How far a traversal has come in the BSP. */
typedef struct {
    uint16_t node;
    uint16_t index; /* how many of the node's faces, or of the items in the leaf, are done */
    uint16_t face;  /* how many faces of an instance in the leaf are done */
    uint16_t phase;
} fxl_bsp_resume_point;

/* The memory of fxl_by_tree, `tree` of a configuration, begins with this record. The memory_size of
 * the order includes what follows it, but for the pieces, which take the rest of tree_size. It is
 * for reading only. */
typedef struct {
    void *pieces;         /* memory for pieces of instances that move; null: none */
    uint32_t pieces_size; /* bytes; memory aligned to four; 12 a piece and 16 a vertex of one */
    uint32_t unsplit;     /* instances of this frame drawn whole, for lack of memory */
    uint32_t used;        /* the most bytes of pieces that this frame used */
    uint32_t refused;     /* pieces of this frame not drawn: out of range when clipped */
    fxl_bsp_resume_point rest; /* where to resume after a full display list */
    uint16_t first, end; /* entries of the order on the layer of the BSP: first <= entry < end */
    uint16_t owner;      /* entry of the instance of the BSP; 0xFFFF: it is not visible */
    uint16_t movers;     /* the other entries of the layer */
} fxl_bsp_workspace;

/* Draws instances by layer and distance, as fxl_by_distance does, except on the layer of
 * the BSP's instance. That layer is drawn by the BSP, far to near, each polygon over those
 * before. A scene without a BSP is drawn as by fxl_by_distance. The caller moves an
 * instance by changing its centre in the scene's table; every vertex must stay in range. The
 * memory is 36 bytes and a bit for each node. Where other instances are on the layer, it is
 * another bit and 4 bytes for each node, and 12 bytes for each of these instances, in addition. */
extern const fxl_order fxl_by_tree;

#ifdef __cplusplus
}
#endif

#endif
