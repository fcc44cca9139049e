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

/* The faces of an object by number, those that face the eye being found on the way; or
 * those alone, in their order, and the others are counted at the end. Front to back
 * they come the other way round. */
static bool walk_faces(const fxl_walk *on, const fxl_placed *placed, const fxl_model *model,
                       uint32_t count, const fxl_order_entry *order, fxl_face_taker take)
{
    const fxl_face *faces = &on->renderer->scene->faces[model->first_face];
    fxl_counters *counters = on->counters;
    for (; on->place->faces < count; on->place->faces++) {
        uint32_t at = on->place->faces;
        at = on->renderer->hidden->front_to_back ? count - 1 - at : at;
        const fxl_face *face = &faces[order != NULL ? order[at].face : at];
        if (order == NULL && !fxl_placed_face_is_front(placed, face)) {
            counters->backfacing += 1;
        } else if (!take(on, placed, face)) {
            return false;
        }
        counters->in += 1;
    }
    counters->in += model->face_count - count;
    counters->backfacing += model->face_count - count;
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
    const fxl_order_entry *order = NULL;
    uint32_t count = model->face_count;
    if (model->kind == FXL_MODEL_SORTED) {
        order = renderer->order + scene->object_count;
        if (renderer->sorted != on->place->objects) {
            renderer->sorted = on->place->objects;
            renderer->front =
                (uint16_t)fxl_order_faces(scene, object, &renderer->view.camera.position,
                                          renderer->order + scene->object_count);
        }
        count = renderer->front;
    }
    return walk_faces(on, &placed, model, count, order, take);
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
