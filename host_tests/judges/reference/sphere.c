/* SPDX-License-Identifier: MIT */
#include "reference/sphere.h"

#include "reference/transform.h"

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
