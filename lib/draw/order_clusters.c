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

static void find_faces(const fxl_traversal *traversal, const fxl_model_view *model_view,
                       const fxl_model *model)
{
    uint32_t front;
    const uint32_t count = fxl_list_clusters(traversal->renderer->scene, model, model_view,
                                             fxl_drops_outside(traversal, model_view, model),
                                             traversal->workspace->face_list, &front);
    keep_counts(traversal->workspace, count, front);
}

static void find_faces_by(const fxl_traversal *traversal, const fxl_model_view *model_view,
                          const fxl_model *model, const fxl_cluster_tests *tests)
{
    uint32_t front;
    const uint32_t count = fxl_list_clusters_by(
        tests, traversal->renderer->scene, model, model_view,
        fxl_drops_outside(traversal, model_view, model), traversal->workspace->face_list, &front);
    keep_counts(traversal->workspace, count, front);
}

const fxl_cluster_code fxl_clusters = {
    find_faces, find_faces_by, fxl_cluster_is_surely_turned_away, fxl_still_cluster_planes};
