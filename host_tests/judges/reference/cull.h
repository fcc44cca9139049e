/* SPDX-License-Identifier: MIT */
/* Which faces, spheres and boxes are not drawn: by the side that they show, or by where they lie.
 */
#ifndef REF_CULL_H
#define REF_CULL_H

#include "reference/scene.h"
#include "reference/clip.h"

/* The facing test (SPEC.md, section 4.5), exact; and a face as a polygon of the world. */

bool ref_face_is_front(const ref_scene *scene, const ref_instance *instance, const ref_face *face,
                       const ref_lattice_point *eye);

/* The same for a camera that may have no eye. */
bool ref_face_shows_front(const ref_scene *scene, const ref_instance *instance,
                          const ref_face *face, const ref_lattice_point *eye,
                          const ref_camera *camera);

/* rounded: the points of a turned instance are rounded in the world. */
void ref_face_to_polygon(const ref_scene *scene, const ref_instance *instance, const ref_face *face,
                         bool rounded, ref_polygon *polygon);

/* Boxes against the frustum (docs/extras/clippers.md, section 8). */

/* Returns a bit for each plane that a box may cross: one for which the eight corners are neither
 * all outside by more than 2^-9 nor all inside by at least 2^-9. Returns 1 << REF_PLANE_COUNT
 * alone where all corners are outside one plane by more than 2^-9. */
uint32_t ref_box_planes(const ref_frustum *frustum, const ref_point *least, const ref_point *most);

/* The sphere test against the frustum (SPEC.md, section 4.4). */

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
