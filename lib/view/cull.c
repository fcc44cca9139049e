/* SPDX-License-Identifier: MIT */

#include "../math/arith.h"
#include "../scene/face_bounds.h"
#include "cull.h"
#include "model_view.h"

/* SPEC 4.5 */
bool fxl_face_is_front(const fxl_scene *scene, const fxl_instance *instance, const fxl_face *face,
                       const fxl_point *eye)
{
    uint32_t first_vertex = scene->models[instance->model].first_vertex;
    const fxl_point *vertex = &scene->vertices[first_vertex + scene->indices[face->first_index]];
    const fxl_point *centre = &instance->centre;
    /* The vertex in the world and the eye are within FXL_COORDINATE_MAX, so each
     * difference is below 2^30; so is eye - centre. */
    return fxl_dot(&face->normal, eye->x - centre->x - vertex->x, eye->y - centre->y - vertex->y,
                   eye->z - centre->z - vertex->z) > 0;
}

/* SPEC 4.5 */
bool fxl_bounded_face_is_front(const fxl_face *face, const fxl_face_bounds *bounds,
                               const fxl_point *eye)
{
    return fxl_dot(&face->normal, eye->x, eye->y, eye->z) > fxl_face_bounds_height(bounds);
}

bool fxl_exact_dot_is_negative(const fxl_direction *direction, int32_t x, int32_t y, int32_t z)
{
    return fxl_dot(direction, x, y, z) < 0;
}

void fxl_face_to_polygon(const fxl_model_view *model_view, const fxl_face *face,
                         fxl_polygon *polygon)
{
    const uint16_t *indices = model_view->indices + face->first_index;
    const fxl_point *eye = &model_view->view->camera.position;
    FXL_ASSERT(face->count >= 3 && face->count <= FXL_FACE_VERTICES_MAX);
    polygon->colour = face->material;
    polygon->count = face->count;
    polygon->textured = false;
    for (uint32_t i = 0; i < face->count; i++) {
        fxl_point from_eye = fxl_model_view_vertex(model_view, indices[i]);
        fxl_point *position = &polygon->vertices[i].position;
        position->x = from_eye.x + eye->x;
        position->y = from_eye.y + eye->y;
        position->z = from_eye.z + eye->z;
    }
}
