/* SPDX-License-Identifier: MIT */
/* The steps that the clippers in the normalised frustum share: its vertices come through the vertex
 * cache. Internal. A clipper whose workspace is no fxl_normalised_workspace, but has its members
 * frame and frustum too, defines FXL_NORMALISED_WORKSPACE before it includes this file. */
#ifndef FXL_FETCH_NORMALISED_H
#define FXL_FETCH_NORMALISED_H

#include "../view/model_view.h"
#include "../view/outcode.h"
#include "../view/view.h"
#include "clip_common.h"

#ifndef FXL_NORMALISED_WORKSPACE
#define FXL_NORMALISED_WORKSPACE fxl_normalised_workspace
#endif

static inline FXL_NORMALISED_WORKSPACE *workspace_of(const fxl_model_view *model_view)
{
    return (FXL_NORMALISED_WORKSPACE *)model_view->clipper_workspace;
}

static inline fxl_cached_vertex *fetch(const fxl_model_view *model_view, uint32_t number)
{
    const fxl_normalised *frustum = &workspace_of(model_view)->frustum;
    bool is_new;
    fxl_cached_vertex *entry = fxl_clip_common_entry(model_view, number, &is_new);
    if (is_new) {
        fxl_point from_eye = fxl_model_view_vertex(model_view, number);
        fxl_normalised_from_eye(frustum, &from_eye, &entry->position);
        entry->clip_flags =
            (uint8_t)((fxl_normalised_code(frustum, &entry->position) & model_view->planes) |
                      FXL_VERTEX_UNPROJECTED);
    }
    return entry;
}

static inline fxl_status project(const fxl_model_view *model_view, const fxl_view_point *point,
                                 fxl_screen_point *screen)
{
    return fxl_normalised_project(&workspace_of(model_view)->frustum, point, screen);
}

/* Makes the frustum of a frame, when the first face of the frame needs it; then clips the face. */
/* clippers 4.2 */
static inline fxl_clip_result clip_in_frustum(const fxl_model_view *model_view,
                                              const fxl_face *face, fxl_screen_polygon *screen,
                                              const fxl_clip_steps *steps)
{
    FXL_NORMALISED_WORKSPACE *workspace = workspace_of(model_view);
    const fxl_view *view = model_view->view;
    if (workspace->frame != view->frame) {
        const fxl_lens lens = fxl_view_drawn_lens(view);
        fxl_normalised_from_camera(&view->camera, &lens, &workspace->frustum);
        workspace->frame = view->frame;
    }
    return fxl_clip_common_face(model_view, face, screen, steps, FXL_PLANES_ALL);
}

#endif
