/* SPDX-License-Identifier: MIT */
/* The planes of the view and those of the world differ, and clippers round: together by less
 * than 43 / 65536 unit (cull.c). The margin of 2^-9 is 128 / 65536 unit. */
#include "../math/arith.h"
#include "../math/plane.h"
#include "../scene/face_bounds.h"
#include "../scene/placement_code.h"
#include "../view/outcode.h"
#include "exact.h"

/* The sum of the radii is below 2^32, so its square is below 2^64. */
bool fxl_spheres_overlap(const fxl_sphere *a, const fxl_sphere *b)
{
    fxl_point between;
    const uint32_t reach = (uint32_t)a->radius + (uint32_t)b->radius;
    fxl_subtract(&a->centre, &b->centre, &between);
    return fxl_square_of(&between) <= fxl_multiply_u32(reach, reach);
}

bool fxl_boxes_overlap(const fxl_box *a, const fxl_box *b)
{
    return a->least.x <= b->most.x && b->least.x <= a->most.x && a->least.y <= b->most.y &&
           b->least.y <= a->most.y && a->least.z <= b->most.z && b->least.z <= a->most.z;
}

/* From the nearest number of least..most. */
static int32_t off(int32_t value, int32_t least, int32_t most)
{
    return value < least ? value - least : value > most ? value - most : 0;
}

bool fxl_sphere_meets_box(const fxl_sphere *sphere, const fxl_box *box)
{
    const fxl_point *centre = &sphere->centre, *least = &box->least, *most = &box->most;
    const fxl_point between = {off(centre->x, least->x, most->x), off(centre->y, least->y, most->y),
                               off(centre->z, least->z, most->z)};
    return fxl_square_of(&between) <= (uint64_t)fxl_multiply_s32(sphere->radius, sphere->radius);
}

#define SLACK ((fxl_q18_46)1 << 37) /* 2^-9 */

/* The rounded points of an instance that is turned, face by face. */
static void box_of_turned(const fxl_scene *scene, uint32_t number, const fxl_placement_code *turned,
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
    const fxl_placement_code *turned = fxl_placement_code_of(scene, number);
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
static fxl_point corner_along(const fxl_direction *direction, const fxl_box *box)
{
    fxl_point corner;
    corner.x = direction->x < 0 ? box->least.x : box->most.x;
    corner.y = direction->y < 0 ? box->least.y : box->most.y;
    corner.z = direction->z < 0 ? box->least.z : box->most.z;
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
