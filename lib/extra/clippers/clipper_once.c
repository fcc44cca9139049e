/* SPDX-License-Identifier: MIT */
#include "fetch_normalised.h"

static fxl_once_workspace *workspace_of(const fxl_model_view *model_view)
{
    return model_view->view->clipper_workspace;
}

static fxl_cached_vertex *fetch(const fxl_model_view *model_view, uint32_t number)
{
    return fxl_fetch_normalised(model_view, number, &workspace_of(model_view)->frustum);
}

static fxl_status project(const fxl_model_view *model_view, const fxl_view_point *point,
                          fxl_screen_point *screen)
{
    /* bug: once-project */
    return fxl_normalised_project(&workspace_of(model_view)->frustum, point, screen);
}

static fxl_varying_polygon *input(const fxl_model_view *model_view)
{
    return &workspace_of(model_view)->in;
}

/* fxl_clip_once tests all planes itself. A plane that the instance lies inside of sets no bit in
 * the outcode of any vertex, so it needs no mask. */
static fxl_clip_result cut(const fxl_model_view *model_view, const fxl_varying_polygon *in,
                           unsigned any, const fxl_varying_polygon **result)
{
    fxl_once_workspace *workspace = workspace_of(model_view);
    (void)any;
    return fxl_clip_once(in, &workspace->frustum, &workspace->clip, result);
}

static fxl_clip_result clip(const fxl_model_view *model_view, const fxl_face *face,
                            fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    static const fxl_clip_steps steps = {fetch, project, input, cut};
    fxl_once_workspace *workspace = workspace_of(model_view);
    (void)work;
    fxl_normalised_set_up(model_view->view, &workspace->frame, &workspace->frustum);
    return fxl_clip_common_face(model_view, face, screen, &steps, FXL_PLANES_ALL);
}

const fxl_clipper fxl_clipper_once = {clip, NULL, sizeof(fxl_once_workspace), NULL};
