/* SPDX-License-Identifier: MIT */
/* Planes: a plane from a point and a normal, and the signed distance of a point. */
#ifndef FXL_PLANE_H
#define FXL_PLANE_H

#include "fixel/types.h"

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

#endif
