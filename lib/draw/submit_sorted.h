/* SPDX-License-Identifier: MIT */
/* The traversal of a sorted model. Internal. */
#ifndef FXL_SUBMIT_SORTED_H
#define FXL_SUBMIT_SORTED_H

#include "../view/order.h"
#include "display_list.h"
#include "submit.h"

static const fxl_rows fxl_no_rows = {UINT16_MAX, 0};

static inline void fxl_rows_add(fxl_rows *sum, fxl_rows rows)
{
    sum->first = rows.first < sum->first ? rows.first : sum->first;
    sum->end = rows.end > sum->end ? rows.end : sum->end;
}

static inline fxl_rows fxl_rows_of_band(const fxl_band *band)
{
    const fxl_rows rows = {band->first_row, (uint16_t)(band->first_row + band->rows)};
    return rows;
}

/* Submits a face, adds the rows that it reaches to *traversal->reached, and returns them. Requires
 * the mode FXL_SUBMIT_MEASURE, which always has room. */
static inline fxl_rows fxl_measure_face(const fxl_traversal *traversal,
                                        const fxl_model_view *model_view, const fxl_face *face)
{
    const fxl_rows before = *traversal->reached;
    *traversal->reached = fxl_no_rows;
    (void)fxl_submit_face(model_view, face, traversal);
    const fxl_rows rows = *traversal->reached;
    fxl_rows_add(traversal->reached, before);
    return rows;
}

/* fxl_list_model: sorts the faces of the instance that is next, unless they are. */
typedef void fxl_face_orderer(const fxl_traversal *traversal, const fxl_model_view *model_view,
                              const fxl_model *model);

/* Finds the faces of a model with clusters that are to be sorted: writes them to the workspace's
 * face_list, and sets front_count and sorted_count. */
typedef void fxl_cluster_finder(const fxl_traversal *traversal, const fxl_model_view *model_view,
                                const fxl_model *model);

/* Writes the faces of a model that face the eye. Returns how many. */
typedef uint32_t fxl_front_finder(const fxl_scene *scene, const fxl_model *model,
                                  const fxl_model_view *model_view, fxl_draw_entry *entries);

/* An orderer of faces. What finds them is constant where this is called. */
static inline void fxl_list_found_faces(const fxl_traversal *traversal,
                                        const fxl_model_view *model_view, const fxl_model *model,
                                        fxl_cluster_finder *find_clusters,
                                        fxl_front_finder *find_front)
{
    fxl_workspace *workspace = traversal->workspace;
    if (workspace->sorted_instance == traversal->resume->instances) {
        return;
    }
    workspace->sorted_instance = traversal->resume->instances;
    if (model->first_cluster != 0) {
        find_clusters(traversal, model_view, model);
    } else {
        const fxl_scene *scene = traversal->renderer->scene;
        uint32_t count = find_front(scene, model, model_view, workspace->face_list);
        workspace->front_count = (uint16_t)count;
        if (!FXL_IS_COMPACT && fxl_drops_outside(traversal, model_view, model)) {
            count = fxl_drop_outside(model_view, &scene->faces[model->first_face],
                                     workspace->face_list, count);
        }
        workspace->sorted_count = (uint16_t)count;
    }
    if (!FXL_IS_SMALL) {
        workspace->face_rows_known = false;
    }
    fxl_sort_work *work = &workspace->work.sort;
    if (traversal->renderer->by_number != FXL_FACES_SORTED) {
        work = NULL;
    }
    fxl_sort_faces(workspace->face_list, workspace->sorted_count, work);
}

/* Whether the faces of a model are put into a list before they are submitted. */
static inline bool fxl_lists_faces(const fxl_renderer *renderer, const fxl_model *model)
{
    FXL_STATIC_ASSERT(FXL_MODEL_SORTED == 1 && FXL_MODEL_CONVEX == 0, "compared with a bit");
    const uint32_t convex = FXL_IS_COMPACT ? 0 : renderer->by_number & FXL_FACES_AT_ONCE;
    return model->kind > convex;
}

/* The faces that face the eye, in their order; then the others are counted. by_rows is constant
 * where this is called: if the mode is FXL_SUBMIT_MEASURE, keep which rows each face reaches; if
 * that is known and a band is drawn, pass over the faces that do not reach it. */
static inline bool fxl_submit_sorted(const fxl_traversal *traversal,
                                     const fxl_model_view *model_view, const fxl_model *model,
                                     fxl_face_orderer *order_faces, bool by_rows)
{
    fxl_workspace *workspace = traversal->workspace;
    fxl_draw_entry *order = workspace->face_list;
    order_faces(traversal, model_view, model);
    const fxl_face *faces = &traversal->renderer->scene->faces[model->first_face];
    const uint32_t first = traversal->resume->faces, front = workspace->sorted_count;
    const bool reverse = traversal->near_first;
    const bool measures = by_rows && traversal->mode == FXL_SUBMIT_MEASURE;
    const bool passes_over = by_rows && !measures && workspace->face_rows_known;
    const fxl_rows wanted = passes_over ? fxl_rows_of_band(traversal->band) : fxl_no_rows;
    /* Where no face is left, the last instance's entry is before the first face's. */
    const int32_t place = reverse ? (int32_t)front - 1 - (int32_t)first : (int32_t)first;
    fxl_draw_entry *at = order + place;
    uint32_t number = first;
    for (; number < front; number++) {
        const fxl_face *face = &faces[at->face];
        if (passes_over && !fxl_rows_meet(at->rows, wanted)) {
            /* The face does not reach the band. */
        } else if (measures) {
            at->rows = fxl_measure_face(traversal, model_view, face);
        } else if (!fxl_submit_face(model_view, face, traversal)) {
            break;
        }
        at += reverse ? -1 : 1;
    }
    if (measures) {
        workspace->face_rows_known = true;
    }
    traversal->resume->faces = (uint16_t)number;
    traversal->counters->in += (number < front ? number : model->face_count) - first;
    if (number < front) {
        return false;
    }
    traversal->counters->backfacing += model->face_count - workspace->front_count;
    traversal->counters->outside += workspace->front_count - front;
    return true;
}

#endif
