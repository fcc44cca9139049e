/* SPDX-License-Identifier: MIT */
/* Instances that turn and scale (SPEC.md, section 8): signs, orders and rounded points exactly in
 * 128 bits, points of the world in double. */
#ifndef REF_PLACEMENT_H
#define REF_PLACEMENT_H

#include "reference/order.h"
#include "reference/scene.h"

/* The placement of an instance; null: it has none. */
const ref_placement *ref_placement_of(const ref_scene *scene, const ref_instance *instance);

/* What is added to the radius of a sphere that is turned, in units of 1/65536. */
#define REF_PLACEMENT_SLACK 32

/* The radius of a sphere about points of the model, in 16.16, once it is turned. */
int64_t ref_placement_radius(const ref_placement *placement, int32_t radius);

/* The radius of an instance in 16.16, turned or not. */
int32_t ref_instance_radius(const ref_scene *scene, const ref_instance *instance);

/* A vertex of the model in the world: exactly but for the last bits of a double, or rounded once to
 * 16.16. */
ref_point ref_placement_point(const ref_placement *placement, const ref_lattice_point *centre,
                              const ref_lattice_point *vertex);
ref_lattice_point ref_placement_rounded(const ref_placement *placement,
                                        const ref_lattice_point *centre,
                                        const ref_lattice_point *vertex);

/* A normal in the world, each component rounded once to 2.30. */
/* A direction of the world, in 2.30, in the model of an instance. */
void ref_direction_in_model(const ref_scene *scene, const ref_instance *instance,
                            const int32_t direction[3], int32_t in_model[3]);

void ref_placement_normal(const ref_placement *placement, const int32_t normal[3],
                          int32_t turned[3]);

/* Whether the plane of a face, through a vertex of the model, shows its front to the eye. */
bool ref_placement_is_front(const ref_placement *placement, const ref_lattice_point *centre,
                            const ref_lattice_point *eye, const int32_t normal[3],
                            const ref_lattice_point *vertex);

/* By how much more than that of an instance that is not turned (reference/depth.h) the depth of a
 * point may be off: by the matrix, rounded to 2^(shift - 31) an entry, and because the centre and
 * the point from the centre take an error of the camera each. In world units. */
double ref_placement_depth_bound(const ref_scene *scene, const ref_instance *instance);

/* The eye in the space of the model, in units of 2^shift / 65536; returns the shift. */
int ref_placement_eye(const ref_placement *placement, const ref_lattice_point *centre,
                      const ref_lattice_point *eye, int32_t radius, ref_lattice_point *in_model);

#endif
