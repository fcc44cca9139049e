/* SPDX-License-Identifier: MIT */
/* The order of the faces of a sorted model: find those that face the eye -> take out those that lie
 * outside -> sort. */
#include "../view/order.h"
#include "submit.h"

bool fxl_drops_outside(const fxl_traversal *traversal, const fxl_model_view *model_view,
                       const fxl_model *model)
{
    return !FXL_IS_COMPACT && traversal->clipper->by_clip_flags && model_view->planes != 0 &&
           model_view->shader == NULL && model->vertex_count < 2 * model->face_count;
}

static void find_faces(const fxl_traversal *traversal, const fxl_model_view *model_view,
                       const fxl_model *model)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_scene *scene = traversal->renderer->scene;
    const fxl_point *offset = &model_view->offset;
    const fxl_point eye = {-offset->x, -offset->y, -offset->z};
    uint32_t count = fxl_list_front_faces(scene, model, &eye, workspace->face_list);
    workspace->front_count = (uint16_t)count;
    if (fxl_drops_outside(traversal, model_view, model)) {
        count = fxl_drop_outside(model_view, &scene->faces[model->first_face], workspace->face_list,
                                 count);
    }
    workspace->sorted_count = (uint16_t)count;
}

void fxl_list_model(const fxl_traversal *traversal, const fxl_model_view *model_view,
                    const fxl_model *model)
{
    fxl_workspace *workspace = traversal->workspace;
    if (workspace->sorted_instance == traversal->resume->instances) {
        return;
    }
    workspace->sorted_instance = traversal->resume->instances;
    if (model->first_cluster != 0) {
        traversal->renderer->scene->cluster_code->find_faces(traversal, model_view, model);
    } else {
        find_faces(traversal, model_view, model);
    }
    if (!FXL_IS_SMALL) {
        workspace->face_rows_known = false;
    }
    fxl_sort_faces(workspace->face_list, workspace->sorted_count, &workspace->work.sort);
}
