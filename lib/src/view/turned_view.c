/* SPDX-License-Identifier: MIT */
#include "fixel/stage/order.h"
#include "../scene/face_bounds.h"
#include "../scene/turn_code.h"
#include "front_faces.h"
#include "turned_view.h"

/* Moves the vertex to translation + 2^shift (matrix . vertex). Exact: the difference is matrix .
 * vertex, and the instance lies within FXL_COORDINATE_MAX, so the product is below 2^60. */
static fxl_q18_46 scaled_from(fxl_q18_46 translation, fxl_q18_46 position, unsigned shift)
{
    return translation + (fxl_q18_46)((uint64_t)(position - translation) << shift);
}

static uint32_t scale_vertex(const fxl_model_view *model_view, fxl_cached_vertex *entry)
{
    const fxl_view_point *from = &model_view->translation;
    const fxl_planes planes = model_view->planes & FXL_PLANES_ALL;
    fxl_view_point *at = &entry->position;
    at->x = scaled_from(from->x, at->x, model_view->shift);
    at->y = scaled_from(from->y, at->y, model_view->shift);
    at->z = scaled_from(from->z, at->z, model_view->shift);
    entry->clip_flags =
        FXL_VERTEX_UNPROJECTED |
        (planes != 0 ? (uint32_t)fxl_outcode(&model_view->view->view_frustum, planes, at) : 0u);
    return entry->clip_flags;
}

const fxl_model *fxl_turned_view_of_instance(fxl_turned_view *turned, const fxl_scene *scene,
                                             uint32_t number, const fxl_view *view,
                                             fxl_vertex_cache *cache, uint32_t planes)
{
    fxl_model_view *model_view = &turned->model_view;
    const fxl_instance *instance = &scene->instances[number];
    const fxl_model *model = &scene->models[instance->model];
    const fxl_turn *turn = fxl_turn_of(scene, number);
    fxl_point eye;
    turned->turn = turn;
    fxl_model_view_of_instance(model_view, scene, instance, view, cache);
    turned->from_eye = model_view->offset;
    turned->eye_shift = fxl_turn_eye(turn, &turned->from_eye, model->radius, &eye);
    model_view->offset.x = -eye.x;
    model_view->offset.y = -eye.y;
    model_view->offset.z = -eye.z;
    model_view->axes = &turned->matrix;
    model_view->planes = (fxl_planes)planes;
    const unsigned shift = fxl_turn_matrix(turn, &view->camera.axes, &turned->matrix);
    if (shift != 0) {
        model_view->shift = (uint8_t)shift;
        model_view->planes |= FXL_MODEL_VIEW_SCALED;
        model_view->scale_vertex = scale_vertex;
    }
    return model;
}

bool fxl_turned_view_is_front(const fxl_turned_view *turned, const fxl_face *face)
{
    const fxl_model_view *model_view = &turned->model_view;
    const fxl_q18_46 height =
        fxl_face_height(model_view->vertices, model_view->indices + face->first_index, face);
    return fxl_turn_is_front(turned->turn, &turned->from_eye, &face->normal, height);
}

/* The squared distance of the box from the eye, both in units of 2^shift / 65536; the box is
 * rounded down. With the limit of fxl_turn_eye each difference is at most 2^31, and the square of
 * one that wraps to -2^31 is the same. */
static uint64_t box_distance(const fxl_point *box, const fxl_point *eye, unsigned shift)
{
    /* bug: turn-order-shift */
    return fxl_box_distance(box->x >> shift, box->y >> shift, box->z >> shift, eye);
}

uint32_t fxl_order_turned_faces(const fxl_turned_view *turned, const fxl_scene *scene,
                                const fxl_model *model, fxl_order_entry *entries)
{
    const fxl_model_view *model_view = &turned->model_view;
    const fxl_point *offset = &model_view->offset;
    const fxl_point eye = {-offset->x, -offset->y, -offset->z};
    const fxl_face_bounds *known =
        scene->face_bounds != NULL ? &scene->face_bounds[model->first_face_bounds] : NULL;
    uint32_t count = 0;
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        const uint16_t *indices = model_view->indices + face->first_index;
        const fxl_q18_46 height = known != NULL
                                      ? fxl_face_bounds_height(&known[i])
                                      : fxl_face_height(model_view->vertices, indices, face);
        const int side = fxl_estimated_side((height >> turned->eye_shift) -
                                            fxl_dot(&face->normal, eye.x, eye.y, eye.z));
        if (side < 0 || (side == 0 && fxl_turned_view_is_front(turned, face))) {
            fxl_point box;
            if (known != NULL) {
                box.x = known[i].box_x;
                box.y = known[i].box_y;
                box.z = known[i].box_z;
            } else {
                box = fxl_face_box(model_view->vertices, indices, face->count);
            }
            entries[count++] =
                fxl_order_entry_of(box_distance(&box, &eye, turned->eye_shift), (uint16_t)i, 0);
        }
    }
    return count;
}
