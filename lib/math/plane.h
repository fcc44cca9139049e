/* SPDX-License-Identifier: MIT */
/* Planes: from a point and a normal, from three points; and the signed distance of a point.
 * Internal. */
#ifndef FXL_PLANE_H
#define FXL_PLANE_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The plane through a point, with a unit normal that points inside, moved inward by
 * inset world units.
 * Requires |point| <= FXL_COORDINATE_MAX in each coordinate, a normal of unit length to
 * within 4 units of 2^-30, 0 <= inset <= FXL_INSET_MAX. Exact: no rounding. Source: B2. */
fxl_plane fxl_plane_from_point(const fxl_point *point, const fxl_direction *normal,
                               fxl_q16_16 inset);

/* The distance of a point from the plane, in units of 2^-46 world unit; negative outside.
 * Requires |point| <= FXL_COORDINATE_MAX in each coordinate, and a plane made by
 * fxl_plane_from_point. Exact, and so is its sign. Source: B2. */
fxl_q18_46 fxl_plane_distance(const fxl_plane *plane, const fxl_point *point);

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

/* *unit = a x b, scaled to unit length. Returns false, and leaves *unit, where the product is 0.
 * Requires components of at most 2^30. Error: 2.5 units of 2^-30 a component. */
bool fxl_unit_cross(const fxl_point *a, const fxl_point *b, fxl_direction *unit);

#ifdef __cplusplus
}
#endif

#endif
