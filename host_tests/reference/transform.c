/* SPDX-License-Identifier: MIT */
#include "reference/transform.h"

static long double along(const ref_point *axis, const ref_point *way)
{
    return (long double)axis->x * way->x + (long double)axis->y * way->y +
           (long double)axis->z * way->z;
}

ref_view_point ref_transform_point(const ref_camera *camera, const ref_point *point)
{
    ref_point way = {point->x - camera->position.x, point->y - camera->position.y,
                     point->z - camera->position.z};
    return (ref_view_point){along(&camera->right, &way), along(&camera->up, &way),
                            along(&camera->forward, &way)};
}

void ref_transform_polygon(const ref_camera *camera, const ref_polygon *polygon,
                           ref_view_polygon *view)
{
    view->colour = polygon->colour;
    view->count = polygon->count;
    for (int i = 0; i < polygon->count; i++) {
        view->vertices[i].position = ref_transform_point(camera, &polygon->vertices[i].position);
    }
}
