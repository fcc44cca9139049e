/* SPDX-License-Identifier: MIT */
/* The planes of the view and those of the world differ, and clippers round: together by less
 * than 43 / 65536 unit (sphere.c). The margin of 2^-9 is 128 / 65536 unit. */

#include "../math/arith.h"
#include "../math/plane.h"
#include "../scene/face_bounds.h"
#include "../scene/turn_code.h"
#include "../view/sphere.h"
#include "box.h"

#define SLACK ((fxl_q18_46)1 << 37) /* 2^-9 */

/* The rounded points of an instance that is turned, face by face. */
static void box_of_turned(const fxl_scene *scene, uint32_t number, const fxl_turn_code *turned,
                          fxl_box *box)
{
    const fxl_model *model = &scene->models[scene->instances[number].model];
    box->least.x = box->least.y = box->least.z = INT32_MAX;
    box->most.x = box->most.y = box->most.z = INT32_MIN;
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        fxl_point points[FXL_FACE_VERTICES_MAX];
        turned->place_face(scene, number, face, points);
        for (uint32_t k = 0; k < face->count; k++) {
            fxl_widen(points[k].x, &box->least.x, &box->most.x);
            fxl_widen(points[k].y, &box->least.y, &box->most.y);
            fxl_widen(points[k].z, &box->least.z, &box->most.z);
        }
    }
}

void fxl_box_of_instance(const fxl_scene *scene, const fxl_instance *instance, fxl_box *box)
{
    const fxl_model *model = &scene->models[instance->model];
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    const uint32_t number = fxl_instance_number(scene, instance);
    const fxl_turn_code *turned = fxl_turn_code_of(scene, number);
    if (turned != NULL) {
        box_of_turned(scene, number, turned, box);
        return;
    }
    box->least = box->most = vertices[0];
    for (uint32_t i = 1; i < model->vertex_count; i++) {
        fxl_widen(vertices[i].x, &box->least.x, &box->most.x);
        fxl_widen(vertices[i].y, &box->least.y, &box->most.y);
        fxl_widen(vertices[i].z, &box->least.z, &box->most.z);
    }
    /* The scene is checked, so every vertex is in range at the instance's place. */
    box->least.x += instance->centre.x;
    box->least.y += instance->centre.y;
    box->least.z += instance->centre.z;
    box->most.x += instance->centre.x;
    box->most.y += instance->centre.y;
    box->most.z += instance->centre.z;
}

/* Returns the corner that lies farthest along a direction. */
static fxl_point corner_along(const fxl_direction *way, const fxl_box *box)
{
    fxl_point corner;
    corner.x = way->x < 0 ? box->least.x : box->most.x;
    corner.y = way->y < 0 ? box->least.y : box->most.y;
    corner.z = way->z < 0 ? box->least.z : box->most.z;
    return corner;
}

uint32_t fxl_box_planes(const fxl_frustum *frustum, const fxl_box *box)
{
    const fxl_box reversed = {box->most,
                              box->least}; /* corner_along then returns the opposite corner */
    uint32_t crossed = 0;
    for (uint32_t i = 0; i < FXL_PLANE_COUNT; i++) {
        const fxl_plane *plane = &frustum->planes[i];
        fxl_point corner = corner_along(&plane->normal, box);
        if (fxl_plane_distance(plane, &corner) < -SLACK) {
            return FXL_SPHERE_OUTSIDE;
        }
        corner = corner_along(&plane->normal, &reversed);
        crossed |= (uint32_t)(fxl_plane_distance(plane, &corner) < SLACK) << i;
    }
    return crossed;
}
