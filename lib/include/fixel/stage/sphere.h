/* SPDX-License-Identifier: MIT */
/* A sphere against the frustum: what keeps objects that cannot be seen from
 * being ordered and looked into. */
#ifndef FXL_SPHERE_H
#define FXL_SPHERE_H

#include "fixel/stage/frustum.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A bit for each plane that a sphere may cross: 1u << FXL_PLANE_... This one
 * alone says that the sphere lies outside one of the planes. */
#define FXL_SPHERE_OUTSIDE (1u << FXL_PLANE_COUNT)

/* Which planes a sphere may cross; 0 where it lies inside all of them.
 * Its reach is the radius and 2^-9 unit, to within 2^-10 unit: that covers how
 * far matrix and planes may be from unit length, what lies between the planes of
 * the view and those of the world, and what every clipper rounds. So of a model
 * with that radius about that centre, no face is drawn, by whatever clipper,
 * where the answer is FXL_SPHERE_OUTSIDE; and every vertex is inside a plane
 * whose bit is not set.
 * Requires a camera and a frustum made by their functions, each coordinate of
 * the centre within FXL_COORDINATE_MAX, 0 <= radius <= FXL_RADIUS_MAX. */
uint32_t fxl_sphere_planes(const fxl_camera *camera, const fxl_view_frustum *frustum,
                           const fxl_point *centre, fxl_q16_16 radius);

#ifdef __cplusplus
}
#endif

#endif
