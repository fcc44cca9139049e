/* SPDX-License-Identifier: MIT */
#include "../view/facing.h"
#include "submit.h"

static inline const fxl_instance *
view_instance(const fxl_traversal *on, const fxl_order_entry *entry, fxl_model_view *model_view)
{
    const fxl_renderer *renderer = on->renderer;
    const fxl_instance *instance = &renderer->scene->instances[entry->index];
    fxl_model_view_of_instance(model_view, renderer->scene, instance, &renderer->frame.view,
                               &on->workspace->cache);
    model_view->planes = entry->instance.planes;
    if (renderer->shader != NULL) {
        model_view->shader = fxl_shader_reaching(renderer->shader, renderer->scene, instance);
        model_view->instance = instance;
    }
    return instance;
}

const fxl_instance *fxl_view_instance(const fxl_traversal *on, const fxl_order_entry *entry,
                                      fxl_model_view *model_view)
{
    return view_instance(on, entry, model_view);
}

/* A convex instance: none of its faces hides another, so any order will do. Front to back
 * they come in reverse, so that the first face to cover a pixel is the one that would cover it
 * last back to front. */
static bool submit_convex(const fxl_traversal *on, const fxl_model_view *model_view,
                          const fxl_model *model)
{
    const fxl_face *faces = &on->renderer->scene->faces[model->first_face];
    const bool reverse = on->renderer->visibility->front_to_back; /* bug: reverse-rising */
    const uint32_t first = on->resume->faces, step = reverse ? UINT32_MAX : 1;
    uint32_t at = reverse ? model->face_count - 1 - first : first;
    uint32_t number, backfacing = 0;
    for (number = first; number < model->face_count; number++) {
        if (!fxl_model_view_face_is_front(model_view, &faces[at])) {
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
static bool submit_sorted(const fxl_traversal *on, const fxl_model_view *model_view,
                          const fxl_model *model)
{
    const fxl_scene *scene = on->renderer->scene;
    fxl_workspace *workspace = on->workspace;
    fxl_order_entry *order = workspace->face_order;
    if (workspace->sorted_instance != on->resume->instances) {
        workspace->sorted_instance = on->resume->instances;
        fxl_order_model(on, model_view, model);
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

bool fxl_submit_instance(const fxl_traversal *on, const fxl_order_entry *entry)
{
    FXL_ALIGN_8 fxl_model_view model_view; /* its pairs of words are loaded at once */
    const fxl_instance *instance = view_instance(on, entry, &model_view);
    const fxl_model *model = &on->renderer->scene->models[instance->model];
    return model->kind == FXL_MODEL_SORTED ? submit_sorted(on, &model_view, model)
                                           : submit_convex(on, &model_view, model);
}

bool fxl_submit_by_distance(const fxl_traversal *on)
{
    const fxl_order_entry *order = on->renderer->frame.order;
    const uint32_t count = on->renderer->frame.visible_count;
    const bool reverse = on->renderer->visibility->front_to_back;
    for (; on->resume->instances < count; on->resume->instances++) {
        const uint32_t number = on->resume->instances;
        if (!fxl_submit_instance(on, &order[reverse ? count - 1 - number : number])) {
            return false;
        }
        on->resume->faces = 0;
    }
    return true;
}
