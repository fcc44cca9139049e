/* SPDX-License-Identifier: MIT */
/* A point in the view: rotated, and moved. Internal. */
#ifndef FXL_ROTATE_H
#define FXL_ROTATE_H

#include "../math/arith.h"
#include "fixel/stage/model_view.h"

/* Rotates a point relative to the eye, each coordinate below 2^30, into the view: along right, up
 * and forward. Three exact sums, below 2^61 (fxl_dot). */
static inline void fxl_rotate(const fxl_camera *camera, const fxl_point *point,
                              fxl_view_point *view)
{
    view->x = fxl_dot(&camera->right, point->x, point->y, point->z);
    view->y = fxl_dot(&camera->up, point->x, point->y, point->z);
    view->z = fxl_dot(&camera->forward, point->x, point->y, point->z);
}

/* A vertex of the model in the view: translation + rows . vertex. The translation is the rotated
 * offset, so the sum is what fxl_rotate gives for the vertex relative to the eye, to the bit, and
 * below 2^61. A vertex is within FXL_COORDINATE_MAX, so a partial sum is below 2^61 + 2^60. */
static inline void fxl_model_view_position(const fxl_model_view *model_view, uint32_t number,
                                           fxl_view_point *position)
{
    const fxl_point *vertex = &model_view->vertices[number];
    const fxl_direction *rows = model_view->rows;
    const fxl_view_point *origin = &model_view->translation;
    position->x = origin->x + fxl_dot(&rows[0], vertex->x, vertex->y, vertex->z);
    position->y = origin->y + fxl_dot(&rows[1], vertex->x, vertex->y, vertex->z);
    position->z = origin->z + fxl_dot(&rows[2], vertex->x, vertex->y, vertex->z);
}

#endif
