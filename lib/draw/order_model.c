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

#if FXL_WALKS_FACES

/* SPEC 6.4 */
bool fxl_submit_walk(const fxl_traversal *traversal, const fxl_model_view *model_view,
                     const fxl_model *model, fxl_next_face *next)
{
    const bool reverse = traversal->near_first;
    const uint32_t first = traversal->resume->faces;
    const fxl_shader *shader = model_view->shader;
    fxl_face_walk walk;
    walk.next = next != NULL ? next : fxl_next_front_face;
    walk.left = model->face_count - first;
    walk.face = traversal->renderer->scene->faces;
    if (walk.left != 0) { /* a scene without faces may have no table */
        walk.face += model->first_face + (reverse ? walk.left - 1 : first);
    }
    walk.step = reverse ? -1 : 1;
    walk.outside = walk.submitted = 0;
    walk.drops =
        model->kind == FXL_MODEL_SORTED && fxl_drops_outside(traversal, model_view, model);
    if (shader->code->faces == NULL || !shader->code->faces(model_view, traversal, &walk)) {
        const fxl_face *face;
        while ((face = walk.next(model_view, &walk)) != NULL) {
            if (!fxl_submit_face(model_view, face, traversal)) {
                walk.left++;
                break;
            }
            walk.submitted++;
        }
    }
    const uint32_t number = model->face_count - walk.left;
    traversal->resume->faces = (uint16_t)number;
    traversal->counters->in += number - first;
    traversal->counters->backfacing += number - first - walk.outside - walk.submitted;
    traversal->counters->outside += walk.outside;
    return walk.left == 0;
}

#endif
