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
    bool (*submit)(const fxl_traversal *on);
    /* The least size of its memory, in bytes. Null: it needs none. */
    uint32_t (*memory_size)(const fxl_scene *scene);
    /* Gives a renderer the order, and the target. Null: the order needs no memory. */
    fxl_status (*choose)(fxl_renderer *renderer, const struct fxl_config *config);
} fxl_order;

/* Instances by layer and distance, the faces of a sorted model by distance, far to near. */
extern const fxl_order fxl_by_distance;

#ifdef __cplusplus
}
#endif

#endif
