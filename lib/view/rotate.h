/* SPDX-License-Identifier: MIT */
/* A point in the view: rotated, and moved. Internal. */
#ifndef FXL_ROTATE_H
#define FXL_ROTATE_H

#include "../math/arith.h"
#include "fixel/stage/model_view.h"

/* *sum = *origin + axes . point: three exact sums. sum may be origin. Requires each coordinate of
 * the point below 2^30. Then each product with an axis is below 2^61 (fxl_dot), and *origin must
 * leave room for it. */
FXL_IN_PLACE void fxl_rotate(const fxl_axes *axes, const fxl_point *point,
                             const fxl_view_point *origin, fxl_view_point *sum)
#if FXL_IS_SMALL && !defined(FXL_HERE)
    ;
#else
{
    sum->x = origin->x + fxl_dot(&axes->right, point->x, point->y, point->z);
    sum->y = origin->y + fxl_dot(&axes->up, point->x, point->y, point->z);
    sum->z = origin->z + fxl_dot(&axes->forward, point->x, point->y, point->z);
}
#endif

/* A vertex of the model in the view: translation + axes . vertex. The translation is the rotated
 * offset, so the sum is that of the vertex relative to the eye, to the bit, and below 2^61. A
 * vertex is within FXL_COORDINATE_MAX, so a partial sum is below 2^61 + 2^60. */
static inline void fxl_model_view_position(const fxl_model_view *model_view, uint32_t number,
                                           fxl_view_point *position)
{
    fxl_rotate(model_view->axes, &model_view->vertices[number], &model_view->translation, position);
}

#endif
