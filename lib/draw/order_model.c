/* SPDX-License-Identifier: MIT */
/* The order of the faces of a sorted model: find those that face the eye -> take out those that lie
 * outside -> sort. */
#include "../view/order.h"
#include "submit_sorted.h"

/* Whether a face of an instance that lies outside comes to the clipper whole: no beam splits it,
 * and its points are not rounded. */
static bool is_clipped_whole(const fxl_traversal *traversal, const fxl_model_view *model_view)
{
    const fxl_renderer *renderer = traversal->renderer;
    return model_view->shader == NULL ||
           (fxl_renderer_shader(renderer, FXL_SHADER_BEAMS) == NULL &&
            model_view->shader ==
                fxl_shader_reaching(renderer->shader, renderer->scene, model_view->instance));
}

bool fxl_drops_outside(const fxl_traversal *traversal, const fxl_model_view *model_view,
                       const fxl_model *model)
{
    return !FXL_IS_COMPACT && traversal->clipper->by_clip_flags && model_view->planes != 0 &&
           model->vertex_count < 2 * model->face_count && is_clipped_whole(traversal, model_view);
}

static void find_clusters(const fxl_traversal *traversal, const fxl_model_view *model_view,
                          const fxl_model *model)
{
    traversal->renderer->scene->cluster_code->find_faces(traversal, model_view, model);
}

static uint32_t find_front(const fxl_scene *scene, const fxl_model *model,
                           const fxl_model_view *model_view, fxl_draw_entry *entries)
{
    const fxl_point *offset = &model_view->offset;
    const fxl_point eye = {-offset->x, -offset->y, -offset->z};
    return fxl_list_front_faces(scene, model, &eye, entries);
}

void fxl_list_model(const fxl_traversal *traversal, const fxl_model_view *model_view,
                    const fxl_model *model)
{
    fxl_list_found_faces(traversal, model_view, model, find_clusters, find_front);
}
