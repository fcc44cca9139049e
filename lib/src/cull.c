/* SPDX-License-Identifier: MIT */
#include "fixel/cull.h"

#include "arith.h"
#include "face.h"

bool fxl_face_is_front(const fxl_scene *scene, const fxl_object *object, const fxl_face *face,
                       const fxl_point *eye)
{
    fxl_point first = fxl_face_vertex(scene, object, face, 0);
    /* Both within FXL_COORDINATE_MAX, so each difference is below 2^30. */
    return fxl_dot(&face->normal, eye->x - first.x, eye->y - first.y, eye->z - first.z) > 0;
}

void fxl_face_to_polygon(const fxl_scene *scene, const fxl_object *object, const fxl_face *face,
                         fxl_polygon *polygon)
{
    FXL_ASSERT(face->count >= 3 && face->count <= FXL_FACE_VERTICES_MAX);
    polygon->colour = face->colour;
    polygon->count = face->count;
    for (uint32_t i = 0; i < face->count; i++) {
        fxl_vertex *vertex = &polygon->vertices[i];
        vertex->position = fxl_face_vertex(scene, object, face, i);
        vertex->u = 0;
        vertex->v = 0;
    }
}
