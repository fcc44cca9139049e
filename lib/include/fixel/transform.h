/* SPDX-License-Identifier: MIT */
/* From the world into the view (Listing 65.3, TransformPoint). */
#ifndef FXL_TRANSFORM_H
#define FXL_TRANSFORM_H

#include "fixel/camera.h"

/* The point relative to the eye along right, up and forward. The three sums
 * are exact in 64 bits (below 2^61); then one common shift brings the largest
 * to 31 bits. Requires |point| <= FXL_COORDINATE_MAX.
 * Error: half a unit of the mantissa in each coordinate, which is at most
 * 2^-31 of the largest coordinate. */
void fxl_transform_point(const fxl_camera *camera, const fxl_point *point, fxl_view_point *view);

/* Every vertex of a polygon; colour and count carried over. */
void fxl_transform_polygon(const fxl_camera *camera, const fxl_polygon *polygon,
                           fxl_view_polygon *view);

#endif
