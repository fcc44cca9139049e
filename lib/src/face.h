/* SPDX-License-Identifier: MIT */
/* A corner of a face as a point of the world. Internal. */
#ifndef FXL_FACE_H
#define FXL_FACE_H

#include "fixel/scene.h"

/* Corner number `corner` of a face, moved to its object's centre. The scene
 * was checked, so the sums lie within FXL_COORDINATE_MAX: exact. */
static inline fxl_point fxl_face_vertex(const fxl_scene *scene, const fxl_object *object,
                                        const fxl_face *face, uint32_t corner)
{
    uint32_t first_vertex = scene->models[object->model].first_vertex;
    const fxl_point *vertex =
        &scene->vertices[first_vertex + scene->corners[face->first_corner + corner]];
    fxl_point moved;
    moved.x = vertex->x + object->centre.x;
    moved.y = vertex->y + object->centre.y;
    moved.z = vertex->z + object->centre.z;
    return moved;
}

#endif
