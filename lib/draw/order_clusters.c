/* SPDX-License-Identifier: MIT */
/* The faces of a sorted model with clusters that are to be sorted. Only a scene with clusters names
 * this file's record. */
#include "../view/clusters.h"
#include "submit.h"

static void keep_counts(fxl_workspace *workspace, uint32_t count, uint32_t front)
{
    workspace->front_count = (uint16_t)front;
    workspace->sorted_count = (uint16_t)count;
}

static void find_faces(const fxl_traversal *on, const fxl_model_view *model_view,
                       const fxl_model *model)
{
    uint32_t front;
    const uint32_t count = fxl_order_clusters(on->renderer->scene, model, model_view,
                                              fxl_drops_outside(on, model_view, model),
                                              on->workspace->face_order, &front);
    keep_counts(on->workspace, count, front);
}

static void find_faces_by(const fxl_traversal *on, const fxl_model_view *model_view,
                          const fxl_model *model, const fxl_cluster_tests *tests)
{
    uint32_t front;
    const uint32_t count = fxl_order_clusters_by(tests, on->renderer->scene, model, model_view,
                                                 fxl_drops_outside(on, model_view, model),
                                                 on->workspace->face_order, &front);
    keep_counts(on->workspace, count, front);
}

const fxl_cluster_code fxl_clusters = {find_faces, find_faces_by,
                                       fxl_cluster_is_surely_turned_away};
