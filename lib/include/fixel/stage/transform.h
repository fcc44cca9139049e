/* SPDX-License-Identifier: MIT */
/* From the world into the view (Listing 65.3, TransformPoint). */
#ifndef FXL_TRANSFORM_H
#define FXL_TRANSFORM_H

#include "fixel/stage/camera.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The point relative to the eye along right, up and forward. Exact, given the
 * camera's matrix: three sums in 64 bits, below 2^61 units of 2^-46.
 * Requires |point| <= FXL_COORDINATE_MAX in each coordinate. */
void fxl_transform_point(const fxl_camera *camera, const fxl_point *point, fxl_view_point *view);

/* Every vertex of a polygon; texture coordinates, colour and count carried
 * over. */
void fxl_transform_polygon(const fxl_camera *camera, const fxl_polygon *polygon,
                           fxl_view_polygon *view);

#ifdef __cplusplus
}
#endif

#endif
