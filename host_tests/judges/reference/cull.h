/* SPDX-License-Identifier: MIT */
/* The facing test (SPEC.md, section 4.5), exact; and a face as a polygon of the world. */
#ifndef REF_CULL_H
#define REF_CULL_H

#include "reference/scene.h"

bool ref_face_is_front(const ref_scene *scene, const ref_instance *instance, const ref_face *face,
                       const ref_lattice_point *eye);

/* rounded: the points of a turned instance are rounded in the world. */
void ref_face_to_polygon(const ref_scene *scene, const ref_instance *instance, const ref_face *face,
                         bool rounded, ref_polygon *polygon);

#endif
