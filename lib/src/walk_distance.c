/* SPDX-License-Identifier: MIT */
#include "face.h"
#include "walk.h"

fxl_face_taker fxl_walk_taker_of(const fxl_walk *on, const fxl_object *object,
                                 const fxl_model *model)
{
    const fxl_light *light = on->renderer->light;
    return light != NULL && light->reaches(light, &object->centre, model->radius) ? light->face
                                                                                  : on->take;
}

/* A convex object: its faces hide none of each other, so any order will do. Front
 * to back they come the other way round, that the first to cover a pixel is the one which
 * covers it last otherwise. */
static bool walk_convex(const fxl_walk *on, const fxl_placed *placed, const fxl_model *model,
                        fxl_face_taker take)
{
    const fxl_face *faces = &on->renderer->scene->faces[model->first_face];
    const bool reverse = on->renderer->hidden->front_to_back; /* bug: reverse-rising */
    const uint32_t first = on->place->faces, step = reverse ? UINT32_MAX : 1;
    uint32_t at = reverse ? model->face_count - 1 - first : first;
    uint32_t number, backfacing = 0;
    for (number = first; number < model->face_count; number++) {
        if (!fxl_placed_face_is_front(placed, &faces[at])) {
            backfacing++;
        } else if (!take(on, placed, &faces[at])) {
            break;
        }
        at += step;
    }
    on->place->faces = (uint16_t)number;
    on->counters->in += number - first;
    on->counters->backfacing += backfacing;
    return number == model->face_count;
}

/* The faces that face the eye, in their order; then the others are counted. */
static bool walk_sorted(const fxl_walk *on, const fxl_placed *placed, const fxl_object *object,
                        const fxl_model *model, fxl_face_taker take)
{
    const fxl_scene *scene = on->renderer->scene;
    fxl_renderer *renderer = on->renderer;
    fxl_order_entry *order = renderer->order + scene->object_count;
    if (renderer->sorted != on->place->objects) {
        renderer->sorted = on->place->objects;
        renderer->front =
            (uint16_t)fxl_order_faces(scene, object, &renderer->view.camera.position, order);
    }
    const fxl_face *faces = &scene->faces[model->first_face];
    const uint32_t first = on->place->faces, front = renderer->front;
    const bool reverse = renderer->hidden->front_to_back;
    /* Where no face is left, the last object's entry is before the first face's. */
    const int32_t place = reverse ? (int32_t)front - 1 - (int32_t)first : (int32_t)first;
    const fxl_order_entry *at = order + place;
    uint32_t number = first;
    while (number < front && take(on, placed, &faces[at->face])) {
        at += reverse ? -1 : 1;
        number++;
    }
    on->place->faces = (uint16_t)number;
    on->counters->in += number - first;
    if (number < front) {
        return false;
    }
    on->counters->in += model->face_count - front;
    on->counters->backfacing += model->face_count - front;
    return true;
}

bool fxl_walk_object(const fxl_walk *on, const fxl_order_entry *entry)
{
    fxl_renderer *renderer = on->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_object *object = &scene->objects[entry->index];
    const fxl_model *model = &scene->models[object->model];
    const fxl_face_taker take = fxl_walk_taker_of(on, object, model);
    fxl_placed placed;
    fxl_place_object(&placed, scene, object, entry->planes, &renderer->view, &renderer->cache);
    return model->kind == FXL_MODEL_SORTED ? walk_sorted(on, &placed, object, model, take)
                                           : walk_convex(on, &placed, model, take);
}

bool fxl_walk_by_distance(const fxl_walk *on)
{
    const fxl_renderer *renderer = on->renderer;
    const uint32_t count = renderer->in_sight;
    for (; on->place->objects < count; on->place->objects++) {
        const uint32_t number = on->place->objects;
        const uint32_t at = renderer->hidden->front_to_back ? count - 1 - number : number;
        if (!fxl_walk_object(on, &renderer->order[at])) {
            return false;
        }
        on->place->faces = 0;
    }
    return true;
}
