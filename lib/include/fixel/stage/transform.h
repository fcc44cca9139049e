/* SPDX-License-Identifier: MIT */
/* The transform from the world to the view. */
#ifndef FXL_TRANSFORM_H
#define FXL_TRANSFORM_H

#include "fixel/stage/camera.h"

/* Transforms a point: *view becomes the point relative to the eye along right, up and
 * forward. Requires |point| <= FXL_COORDINATE_MAX in each coordinate.
 * Exact, given the camera's matrix: three sums in 64 bits, below 2^61 units of 2^-46.
 * Source: A6 (Listing 65.3, TransformPoint). */
void fxl_transform_point(const fxl_camera *camera, const fxl_point *point, fxl_view_point *view);

/* Transforms every vertex of a polygon as fxl_transform_point does, and copies colour
 * and count. Source: A6. */
void fxl_transform_polygon(const fxl_camera *camera, const fxl_polygon *polygon,
                           fxl_view_polygon *view);

#endif
