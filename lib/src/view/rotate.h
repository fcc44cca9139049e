/* SPDX-License-Identifier: MIT */
/* The camera's rotation. Internal. */
#ifndef FXL_ROTATE_H
#define FXL_ROTATE_H

#include "../math/arith.h"
#include "fixel/stage/camera.h"

/* Rotates a point relative to the eye, each coordinate below 2^30, into the view: along right, up
 * and forward. Three exact sums, below 2^61 (fxl_dot). */
static inline void fxl_rotate(const fxl_camera *camera, const fxl_point *point,
                              fxl_view_point *view)
{
    view->x = fxl_dot(&camera->right, point->x, point->y, point->z);
    view->y = fxl_dot(&camera->up, point->x, point->y, point->z);
    view->z = fxl_dot(&camera->forward, point->x, point->y, point->z);
}

#endif
