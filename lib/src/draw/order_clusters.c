/* SPDX-License-Identifier: MIT */
/* The faces of a sorted model with clusters that are to be sorted. Only a scene with clusters names
 * this file's record. */
#include "../view/clusters.h"
#include "submit.h"

static void find_faces(const fxl_traversal *on, const fxl_model_view *model_view,
                       const fxl_model *model)
{
    fxl_workspace *workspace = on->workspace;
    uint32_t front;
    const uint32_t count =
        fxl_order_clusters(on->renderer->scene, model, model_view,
                           fxl_drops_outside(on, model_view, model), workspace->face_order, &front);
    workspace->front_count = (uint16_t)front;
    workspace->sorted_count = (uint16_t)count;
}

const fxl_cluster_code fxl_clusters = {find_faces};
