/* SPDX-License-Identifier: MIT */
/* What lies between the planes of the view and those of the world, and what clippers
 * round, is below 43 / 65536 unit (sphere.c); 2^-9 is 128 / 65536. */
#include "fixel/box.h"

#include "arith.h"
#include "fixel/plane.h"
#include "face_key.h"

#define SLACK ((fxl_q18_46)1 << 37) /* 2^-9 */

void fxl_box_of_object(const fxl_scene *scene, const fxl_object *object, fxl_box *box)
{
    const fxl_model *model = &scene->models[object->model];
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    box->least = box->most = vertices[0];
    for (uint32_t i = 1; i < model->vertex_count; i++) {
        fxl_widen(vertices[i].x, &box->least.x, &box->most.x);
        fxl_widen(vertices[i].y, &box->least.y, &box->most.y);
        fxl_widen(vertices[i].z, &box->least.z, &box->most.z);
    }
    /* A checked scene's vertices are in range where they stand. */
    box->least.x += object->centre.x;
    box->least.y += object->centre.y;
    box->least.z += object->centre.z;
    box->most.x += object->centre.x;
    box->most.y += object->centre.y;
    box->most.z += object->centre.z;
}

/* The corner that lies farthest along a direction. */
static fxl_point corner_along(const fxl_direction *way, const fxl_box *box)
{
    fxl_point corner;
    corner.x = way->x < 0 ? box->least.x : box->most.x;
    corner.y = way->y < 0 ? box->least.y : box->most.y; /* bug: box-corner */
    corner.z = way->z < 0 ? box->least.z : box->most.z;
    return corner;
}

uint32_t fxl_box_planes(const fxl_frustum *frustum, const fxl_box *box)
{
    const fxl_box turned = {box->most, box->least}; /* its corner along is the opposite one */
    uint32_t crossed = 0;
    for (uint32_t i = 0; i < FXL_PLANE_COUNT; i++) {
        const fxl_plane *plane = &frustum->planes[i];
        fxl_point corner = corner_along(&plane->normal, box);
        if (fxl_plane_distance(plane, &corner) < -SLACK) {
            return FXL_SPHERE_OUTSIDE;
        }
        corner = corner_along(&plane->normal, &turned);
        crossed |= (uint32_t)(fxl_plane_distance(plane, &corner) < SLACK) << i;
    }
    return crossed;
}
