/* SPDX-License-Identifier: MIT */
#include "../scene/placement_code.h"
#include "../view/cull.h"
#include "../view/model_view.h"
#include "submit_instance.h"

static inline const fxl_instance *view_instance(const fxl_traversal *traversal,
                                                const fxl_draw_entry *entry,
                                                fxl_model_view *model_view)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_instance *instance = &renderer->scene->instances[entry->index];
    fxl_model_view_of_instance(model_view, renderer->scene, instance, &renderer->frame.view,
                               &traversal->workspace->cache);
    model_view->planes = entry->instance.planes;
    if (renderer->shader != NULL) {
        model_view->shader = fxl_shader_reaching(renderer->shader, renderer->scene, instance);
        model_view->instance = instance;
    }
    return instance;
}

const fxl_instance *fxl_view_instance(const fxl_traversal *traversal, const fxl_draw_entry *entry,
                                      fxl_model_view *model_view)
{
    return view_instance(traversal, entry, model_view);
}

#if FXL_IS_COMPACT

bool fxl_submit_sorted_once(const fxl_traversal *traversal, const fxl_model_view *model_view,
                            const fxl_model *model, fxl_face_orderer *order_faces)
{
    return fxl_submit_sorted(traversal, model_view, model, order_faces, ONE_LOOP);
}

bool fxl_submit_all(const fxl_traversal *traversal, fxl_instance_submit *submit)
{
    return fxl_submit_all_by(traversal, submit);
}

#endif

bool fxl_submit_instance(const fxl_traversal *traversal, const fxl_draw_entry *entry)
{
    FXL_ALIGN_8 fxl_model_view model_view; /* its pairs of words are loaded at once */
    const fxl_instance *instance = view_instance(traversal, entry, &model_view);
    const fxl_model *model = &traversal->renderer->scene->models[instance->model];
    if (fxl_lists_faces(traversal->renderer, model)) {
        return fxl_submit_sorted_once(traversal, &model_view, model, fxl_list_model);
    }
#if FXL_WALKS_FACES
    if (fxl_walks_faces(traversal, &model_view, model)) {
        return fxl_walk_instance(traversal, &model_view, model, NULL);
    }
#endif
    return fxl_submit_convex(traversal, &model_view, model, fxl_model_view_face_is_front);
}

bool fxl_submit_by_distance(const fxl_traversal *traversal)
{
    const fxl_scene *scene = traversal->renderer->scene;
    if (scene->placements != NULL) {
        return scene->placement_code->submit(traversal);
    }
    return fxl_submit_all(traversal, fxl_submit_instance);
}

const fxl_order fxl_by_distance = {.submit = fxl_submit_by_distance};
