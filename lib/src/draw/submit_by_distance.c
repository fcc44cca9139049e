/* SPDX-License-Identifier: MIT */
#include "../view/facing.h"
#include "submit.h"

fxl_face_sink fxl_instance_sink(const fxl_traversal *on, const fxl_instance *instance,
                                const fxl_model *model)
{
    const fxl_beam_light *light = on->renderer->beam_light;
    return light != NULL && light->reaches(light, &instance->centre, model->radius) ? light->face
                                                                                    : on->sink;
}

/* A convex object: its faces hide none of each other, so any order will do. Front
 * to back they come the other way round, that the first to cover a pixel is the one which
 * covers it last otherwise. */
static bool submit_convex(const fxl_traversal *on, const fxl_model_view *model_view,
                          const fxl_model *model, fxl_face_sink take)
{
    const fxl_face *faces = &on->renderer->scene->faces[model->first_face];
    const bool reverse = on->renderer->visibility->front_to_back; /* bug: reverse-rising */
    const uint32_t first = on->resume->faces, step = reverse ? UINT32_MAX : 1;
    uint32_t at = reverse ? model->face_count - 1 - first : first;
    uint32_t number, backfacing = 0;
    for (number = first; number < model->face_count; number++) {
        if (!fxl_model_view_face_is_front(model_view, &faces[at])) {
            backfacing++;
        } else if (!take(on, model_view, &faces[at])) {
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
                          const fxl_instance *instance, const fxl_model *model, fxl_face_sink take)
{
    const fxl_scene *scene = on->renderer->scene;
    fxl_renderer *renderer = on->renderer;
    fxl_order_entry *order = renderer->order + scene->instance_count;
    if (renderer->sorted_instance != on->resume->instances) {
        renderer->sorted_instance = on->resume->instances;
        renderer->front_count =
            (uint16_t)fxl_order_faces(scene, instance, &renderer->view.camera.position, order);
    }
    const fxl_face *faces = &scene->faces[model->first_face];
    const uint32_t first = on->resume->faces, front = renderer->front_count;
    const bool reverse = renderer->visibility->front_to_back;
    /* Where no face is left, the last object's entry is before the first face's. */
    const int32_t place = reverse ? (int32_t)front - 1 - (int32_t)first : (int32_t)first;
    const fxl_order_entry *at = order + place;
    uint32_t number = first;
    while (number < front && take(on, model_view, &faces[at->face])) {
        at += reverse ? -1 : 1;
        number++;
    }
    on->resume->faces = (uint16_t)number;
    on->counters->in += number - first;
    if (number < front) {
        return false;
    }
    on->counters->in += model->face_count - front;
    on->counters->backfacing += model->face_count - front;
    return true;
}

bool fxl_submit_instance(const fxl_traversal *on, const fxl_order_entry *entry)
{
    fxl_renderer *renderer = on->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_instance *instance = &scene->instances[entry->index];
    const fxl_model *model = &scene->models[instance->model];
    const fxl_face_sink take = fxl_instance_sink(on, instance, model);
    fxl_model_view model_view;
    fxl_model_view_of_instance(&model_view, scene, instance, entry->instance.planes,
                               &renderer->view, &renderer->cache);
    return model->kind == FXL_MODEL_SORTED ? submit_sorted(on, &model_view, instance, model, take)
                                           : submit_convex(on, &model_view, model, take);
}

bool fxl_submit_by_distance(const fxl_traversal *on)
{
    const fxl_renderer *renderer = on->renderer;
    const uint32_t count = renderer->visible_count;
    for (; on->resume->instances < count; on->resume->instances++) {
        const uint32_t number = on->resume->instances;
        const uint32_t at = renderer->visibility->front_to_back ? count - 1 - number : number;
        if (!fxl_submit_instance(on, &renderer->order[at])) {
            return false;
        }
        on->resume->faces = 0;
    }
    return true;
}
