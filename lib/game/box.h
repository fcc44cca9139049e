/* SPDX-License-Identifier: MIT */
/* Tests a bounding box against the frustum. A box is tighter than a sphere about a long or flat
 * instance, and costs more. The renderer itself tests spheres. Source: chapter 65 (A9). Internal.
 */
#ifndef FXL_BOX_H
#define FXL_BOX_H

#include "fixel/collide.h"
#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Finds the planes that a box may cross. Returns a bit for each such plane (1 << FXL_PLANE_...):
 * 0 where the box lies inside all planes, FXL_SPHERE_OUTSIDE alone where it lies outside one, as
 * fxl_sphere_planes does. The box is outside a plane if all eight corners are more than 2^-9
 * unit outside it. It is inside a plane if all eight corners are at least 2^-9 unit inside it.
 * Otherwise it may cross the plane. The test is exact on the integers of the world's planes. The
 * margin of 2^-9 unit covers the difference between the planes of the world and those of the
 * view, and the rounding of every clipper. The test is therefore conservative. If the result is
 * FXL_SPHERE_OUTSIDE, no clipper draws a face whose vertices all lie in the box. If a plane's
 * bit is not set, every vertex in the box is inside that plane.
 * Requires a frustum made by its function, and corners within FXL_COORDINATE_MAX. Costs at most
 * twelve sums of three 32 x 32 -> 64 bit products. */
uint32_t fxl_box_planes(const fxl_frustum *frustum, const fxl_box *box);

#ifdef __cplusplus
}
#endif

#endif
