/* SPDX-License-Identifier: MIT */
/* Planes: from a point and a normal; signed distance. */
#ifndef FXL_PLANE_H
#define FXL_PLANE_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The plane through a point, with a unit normal that points inside, moved
 * inside by inset world units.
 * Requires |point| <= FXL_COORDINATE_MAX, a normal of unit length to within
 * 4 units of 2^-30, 0 <= inset <= FXL_INSET_MAX. Exact: no rounding. */
fxl_plane fxl_plane_from_point(const fxl_point *point, const fxl_direction *normal,
                               fxl_q16_16 inset);

/* How far a point lies inside the plane; negative outside. Unit 2^-46 world
 * unit. Requires |point| <= FXL_COORDINATE_MAX and a plane as above. Exact, so
 * its sign cannot err. */
fxl_q18_46 fxl_plane_distance(const fxl_plane *plane, const fxl_point *point);

#ifdef __cplusplus
}
#endif

#endif
