/* SPDX-License-Identifier: MIT */
/* How the faces of instances are submitted, whether these are turned or not: the callers differ in
 * the functions that they give. The functions are inlined. Internal. */
#ifndef FXL_SUBMIT_INSTANCE_H
#define FXL_SUBMIT_INSTANCE_H

#include "submit.h"

/* Whether a face is turned towards the eye. */
typedef bool fxl_facing_test(const fxl_model_view *model_view, const fxl_face *face);

/* fxl_order_model. */
typedef void fxl_face_orderer(const fxl_traversal *on, const fxl_model_view *model_view,
                              const fxl_model *model);

/* fxl_submit_instance. */
typedef bool fxl_instance_submit(const fxl_traversal *on, const fxl_order_entry *entry);

/* A convex instance: none of its faces hides another, so any order will do. Front to back
 * they come in reverse, so that the first face to cover a pixel is the one that would cover it
 * last back to front. */
static inline bool fxl_submit_convex(const fxl_traversal *on, const fxl_model_view *model_view,
                                     const fxl_model *model, fxl_facing_test *is_front)
{
    const fxl_face *faces = &on->renderer->scene->faces[model->first_face];
    const bool reverse = on->renderer->visibility->front_to_back; /* bug: reverse-rising */
    const uint32_t first = on->resume->faces, step = reverse ? UINT32_MAX : 1;
    uint32_t at = reverse ? model->face_count - 1 - first : first;
    uint32_t number, backfacing = 0;
    for (number = first; number < model->face_count; number++) {
        if (!is_front(model_view, &faces[at])) {
            backfacing++;
        } else if (!fxl_submit_face(model_view, &faces[at], on)) {
            break;
        }
        at += step;
    }
    on->resume->faces = (uint16_t)number;
    on->counters->in += number - first;
    on->counters->backfacing += backfacing;
    return number == model->face_count;
}

/* The faces that face the eye, in their order; then the others are counted. */
static inline bool fxl_submit_sorted(const fxl_traversal *on, const fxl_model_view *model_view,
                                     const fxl_model *model, fxl_face_orderer *order_faces)
{
    const fxl_scene *scene = on->renderer->scene;
    fxl_workspace *workspace = on->workspace;
    fxl_order_entry *order = workspace->face_order;
    if (workspace->sorted_instance != on->resume->instances) {
        workspace->sorted_instance = on->resume->instances;
        order_faces(on, model_view, model);
    }
    const fxl_face *faces = &scene->faces[model->first_face];
    const uint32_t first = on->resume->faces, front = workspace->sorted_count;
    const bool reverse = on->renderer->visibility->front_to_back;
    /* Where no face is left, the last instance's entry is before the first face's. */
    const int32_t place = reverse ? (int32_t)front - 1 - (int32_t)first : (int32_t)first;
    const fxl_order_entry *at = order + place;
    uint32_t number = first;
    while (number < front && fxl_submit_face(model_view, &faces[at->face], on)) {
        at += reverse ? -1 : 1;
        number++;
    }
    on->resume->faces = (uint16_t)number;
    on->counters->in += (number < front ? number : model->face_count) - first;
    if (number < front) {
        return false;
    }
    on->counters->backfacing += model->face_count - workspace->front_count;
    on->counters->outside += workspace->front_count - front;
    return true;
}

/* All instances in sight that are left, in the order of drawing. */
static inline bool fxl_submit_all(const fxl_traversal *on, fxl_instance_submit *submit)
{
    const fxl_order_entry *order = on->renderer->frame.order;
    const uint32_t count = on->renderer->frame.visible_count;
    const bool reverse = on->renderer->visibility->front_to_back;
    for (; on->resume->instances < count; on->resume->instances++) {
        const uint32_t number = on->resume->instances;
        if (!submit(on, &order[reverse ? count - 1 - number : number])) {
            return false;
        }
        on->resume->faces = 0;
    }
    return true;
}

#endif
