/* SPDX-License-Identifier: MIT */
#include "reference/cull.h"

#include "reference/camera.h"
#include "reference/placement.h"

__extension__ typedef __int128 wide;

bool ref_face_is_front(const ref_scene *scene, const ref_instance *instance, const ref_face *face,
                       const ref_lattice_point *eye)
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    if (placement) {
        const ref_lattice_point corner = ref_face_corner(scene, instance, face, 0);
        return ref_placement_is_front(placement, &instance->centre, eye, face->normal, &corner);
    }
    ref_lattice_point first = ref_face_vertex(scene, instance, face, 0);
    wide sum = (wide)face->normal[0] * ((int64_t)eye->x - first.x) +
               (wide)face->normal[1] * ((int64_t)eye->y - first.y) +
               (wide)face->normal[2] * ((int64_t)eye->z - first.z);
    return sum > 0;
}

void ref_face_to_polygon(const ref_scene *scene, const ref_instance *instance, const ref_face *face,
                         bool rounded, ref_polygon *polygon)
{
    const ref_placement *placement = rounded ? NULL : ref_placement_of(scene, instance);
    polygon->colour = face->material;
    polygon->count = face->count;
    for (int i = 0; i < face->count; i++) {
        if (placement) {
            const ref_lattice_point corner = ref_face_corner(scene, instance, face, i);
            polygon->vertices[i] = (ref_vertex){
                .position = ref_placement_point(placement, &instance->centre, &corner)};
        } else {
            const ref_lattice_point vertex = ref_face_vertex(scene, instance, face, i);
            polygon->vertices[i] = (ref_vertex){.position = ref_point_from_lattice(&vertex)};
        }
    }
}
