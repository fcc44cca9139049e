/* SPDX-License-Identifier: MIT */
/* The sphere test against the frustum (SPEC.md, section 4.4). */
#ifndef REF_SPHERE_H
#define REF_SPHERE_H

#include "reference/clip_view.h"

/* By how much the reach exceeds the radius: the middle of the range that SPEC.md allows. */
#define REF_SPHERE_SLACK 0x1p-9

#define REF_SPHERE_OUTSIDE (1u << REF_PLANE_COUNT)

/* How far a sphere's centre lies inside each plane, in world units. */
typedef struct {
    ref_wide inside[REF_PLANE_COUNT];
} ref_sphere_distances;

ref_sphere_distances ref_sphere_measure(const ref_camera *camera, const ref_view_frustum *frustum,
                                        const ref_point *centre);

/* Returns a bit for each plane that a sphere of this radius may cross; REF_SPHERE_OUTSIDE alone
 * where it lies outside one. */
uint32_t ref_sphere_planes(const ref_sphere_distances *distances, double radius);

#endif
