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

bool fxl_placed_face_is_front(const fxl_placed *placed, const fxl_face *face)
{
    fxl_point first = fxl_placed_vertex(placed, placed->corners[face->first_corner]);
    return fxl_dot(&face->normal, first.x, first.y, first.z) < 0;
}

void fxl_face_to_polygon(const fxl_placed *placed, const fxl_face *face, fxl_polygon *polygon)
{
    const uint16_t *corners = placed->corners + face->first_corner;
    const fxl_point *eye = &placed->view->camera.position;
    FXL_ASSERT(face->count >= 3 && face->count <= FXL_FACE_VERTICES_MAX);
    polygon->colour = face->colour;
    polygon->count = face->count;
    polygon->textured = false;
    for (uint32_t i = 0; i < face->count; i++) {
        fxl_point from_eye = fxl_placed_vertex(placed, corners[i]);
        fxl_point *position = &polygon->vertices[i].position;
        position->x = from_eye.x + eye->x;
        position->y = from_eye.y + eye->y;
        position->z = from_eye.z + eye->z;
    }
}
