/* SPDX-License-Identifier: MIT */
#include "fixel/transform.h"

#include "arith.h"

void fxl_transform_point(const fxl_camera *camera, const fxl_point *point, fxl_view_point *view)
{
    FXL_ASSERT(fxl_point_in_range(point));
    /* Both within FXL_COORDINATE_MAX, so each difference is below 2^30. */
    int32_t dx = point->x - camera->position.x;
    int32_t dy = point->y - camera->position.y;
    int32_t dz = point->z - camera->position.z;
    view->x = fxl_dot(&camera->right, dx, dy, dz);
    view->y = fxl_dot(&camera->up, dx, dy, dz);
    view->z = fxl_dot(&camera->forward, dx, dy, dz);
}

void fxl_transform_polygon(const fxl_camera *camera, const fxl_polygon *polygon,
                           fxl_view_polygon *view)
{
    view->colour = polygon->colour;
    view->count = polygon->count;
    for (uint32_t i = 0; i < polygon->count; i++) {
        const fxl_vertex *vertex = &polygon->vertices[i];
        fxl_transform_point(camera, &vertex->position, &view->vertices[i].position);
        view->vertices[i].u = vertex->u;
        view->vertices[i].v = vertex->v;
    }
}
