/* SPDX-License-Identifier: MIT */
/* The plane through three points. Source: notes on a line and a plane (B1). */
#ifndef FXL_PLANE_FROM_POINTS_H
#define FXL_PLANE_FROM_POINTS_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Makes the plane through three points of the world, for fxl_plane_distance and all that takes a
 * plane. Its normal is (b - a) x (c - a) at unit length. It points towards the side from which a,
 * b, c run clockwise, as the normal of a face does.
 * FXL_E_ARGUMENT: a pointer is null.
 * FXL_E_RANGE: a coordinate is beyond FXL_COORDINATE_MAX.
 * FXL_E_DEGENERATE: the points lie on one line, exactly.
 * In all three cases *plane is untouched.
 * Error: 2.5 units of 2^-30 a component of the normal. The plane passes through a exactly, and
 * within 2^-13 world unit of b and c. */
fxl_status fxl_plane_from_points(const fxl_point *a, const fxl_point *b, const fxl_point *c,
                                 fxl_plane *plane);

#ifdef __cplusplus
}
#endif

#endif
