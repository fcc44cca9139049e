/* SPDX-License-Identifier: MIT */
#include "reference/transform.h"

static long double along(const ref_point *axis, const ref_point *from_eye)
{
    return (long double)axis->x * from_eye->x + (long double)axis->y * from_eye->y +
           (long double)axis->z * from_eye->z;
}

ref_view_point ref_transform_point(const ref_camera *camera, const ref_point *point)
{
    ref_point from_eye = {point->x - camera->position.x, point->y - camera->position.y,
                          point->z - camera->position.z};
    return (ref_view_point){along(&camera->right, &from_eye), along(&camera->up, &from_eye),
                            along(&camera->forward, &from_eye)};
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
