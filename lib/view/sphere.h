/* SPDX-License-Identifier: MIT */
/* The sphere test: it rejects an instance outside the frustum before the instance is
 * sorted and its faces are read. Internal. */
#ifndef FXL_SPHERE_H
#define FXL_SPHERE_H

#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The result of fxl_sphere_planes for a sphere that lies outside one of the planes. */
#define FXL_SPHERE_OUTSIDE (1u << FXL_PLANE_COUNT)

/* The planes that a sphere may cross: bit 1u << FXL_PLANE_... for each; 0 if the
 * sphere lies inside all of them; FXL_SPHERE_OUTSIDE alone if it lies outside one.
 * The test takes the reach instead of the radius: the radius + 2^-9 world unit, to
 * within 2^-10 unit. The difference covers how far matrix and normals may be from unit
 * length, the differences of the planes of the view from those of the world, and the
 * rounding of every clipper. So the test is conservative. Take a model with that radius
 * about that centre. If the result is FXL_SPHERE_OUTSIDE, no clipper draws any of its
 * faces. If the bit of a plane is not set, every vertex is inside that plane.
 * Requires a camera and a frustum made by their functions, each coordinate of
 * the centre within FXL_COORDINATE_MAX, 0 <= radius <= FXL_RADIUS_MAX.
 * Error: 2^-10 unit in the reach. Source: A9. */
uint32_t fxl_sphere_planes(const fxl_camera *camera, const fxl_view_frustum *frustum,
                           const fxl_point *centre, fxl_q16_16 radius);

#ifdef __cplusplus
}
#endif

#endif
