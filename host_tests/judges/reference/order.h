/* SPDX-License-Identifier: MIT */
/* The order of drawing (SPEC.md, section 6), exact in 128 bits. */
#ifndef REF_ORDER_H
#define REF_ORDER_H

#include "reference/scene.h"
#include "reference/sphere.h"

__extension__ typedef unsigned __int128 ref_square;

typedef struct {
    ref_square distance;
    uint32_t index, layer;
} ref_order_entry;

ref_square ref_distance_squared(const ref_lattice_point *eye, const ref_lattice_point *point);
ref_square ref_face_distance_squared(const ref_lattice_point *eye, const ref_scene *scene,
                                     const ref_instance *instance, const ref_face *face);

/* Sorts entries: ascending layer, descending distance, ascending index. */
void ref_order_sort(ref_order_entry *entries, uint32_t count);

/* Write the entries of the instances that the sphere test does not reject, and of the faces of
 * an instance that face the eye and lie in no cluster that the sphere test rejects. entries must
 * have room for all of them. Both return how many they wrote. *left_out becomes the number of faces
 * in rejected clusters. */
uint32_t ref_order_instances(const ref_scene *scene, const ref_lattice_point *eye,
                             const ref_camera *camera, const ref_view_frustum *frustum,
                             ref_order_entry *entries);
uint32_t ref_order_faces(const ref_scene *scene, const ref_instance *instance,
                         const ref_lattice_point *eye, const ref_camera *camera,
                         const ref_view_frustum *frustum, ref_order_entry *entries,
                         uint32_t *left_out);

#endif
