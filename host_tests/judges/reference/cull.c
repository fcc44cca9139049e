/* SPDX-License-Identifier: MIT */
#include "reference/cull.h"

#include "reference/placement.h"

bool ref_face_is_front(const ref_scene *scene, const ref_instance *instance, const ref_face *face,
                       const ref_lattice_point *eye)
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    if (placement) {
        const ref_lattice_point corner = ref_face_corner(scene, instance, face, 0);
        return ref_placement_is_front(placement, &instance->centre, eye, face->normal, &corner);
    }
    ref_lattice_point first = ref_face_vertex(scene, instance, face, 0);
    ref_exact sum = (ref_exact)face->normal[0] * ((int64_t)eye->x - first.x) +
                    (ref_exact)face->normal[1] * ((int64_t)eye->y - first.y) +
                    (ref_exact)face->normal[2] * ((int64_t)eye->z - first.z);
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

uint32_t ref_box_planes(const ref_frustum *frustum, const ref_point *least, const ref_point *most)
{
    uint32_t crossed = 0;
    for (int i = 0; i < REF_PLANE_COUNT; i++) {
        int outside = 0, inside = 0;
        for (int corner = 0; corner < 8; corner++) {
            ref_point at = {corner & 1 ? most->x : least->x, corner & 2 ? most->y : least->y,
                            corner & 4 ? most->z : least->z};
            long double distance = ref_plane_distance(&frustum->planes[i], &at);
            outside += distance < -0x1p-9L;
            inside += distance >= 0x1p-9L;
        }
        if (outside == 8) {
            return 1u << REF_PLANE_COUNT;
        }
        crossed |= inside == 8 ? 0 : 1u << i;
    }
    return crossed;
}

ref_sphere_distances ref_sphere_measure(const ref_camera *camera, const ref_view_frustum *frustum,
                                        const ref_point *centre)
{
    ref_sphere_distances distances;
    ref_view_point view_point = ref_transform_point(camera, centre);
    for (int plane = 0; plane < REF_PLANE_COUNT; plane++) {
        distances.inside[plane] = ref_view_distance(&frustum->planes[plane], &view_point);
    }
    return distances;
}

uint32_t ref_sphere_planes(const ref_sphere_distances *distances, double radius)
{
    double reach = radius + REF_SPHERE_SLACK;
    uint32_t crossed = 0;
    for (int plane = 0; plane < REF_PLANE_COUNT; plane++) {
        if (distances->inside[plane] < -reach) {
            return REF_SPHERE_OUTSIDE;
        }
        crossed |= distances->inside[plane] < reach ? 1u << plane : 0;
    }
    return crossed;
}
