/* SPDX-License-Identifier: MIT */
#include "intersection.h"
#include "fetch_normalised.h"

static fxl_normalised_workspace *workspace_of(const fxl_model_view *model_view)
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
    return fxl_normalised_project(&workspace_of(model_view)->frustum, point, screen);
}

static fxl_varying_polygon *input(const fxl_model_view *model_view)
{
    return &workspace_of(model_view)->clip.polygons[0];
}

static fxl_clip_result cut(const fxl_model_view *model_view, const fxl_varying_polygon *in,
                           unsigned any, const fxl_varying_polygon **result)
{
    fxl_normalised_workspace *workspace = workspace_of(model_view);
    return fxl_clip_polygon_by_normalised(in, any & FXL_PLANES_ALL, &workspace->frustum,
                                          &workspace->clip, result);
}

static fxl_clip_result clip(const fxl_model_view *model_view, const fxl_face *face,
                            fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    static const fxl_clip_steps steps = {fetch, project, input, cut};
    fxl_normalised_workspace *workspace = workspace_of(model_view);
    (void)work;
    fxl_normalised_set_up(model_view->view, &workspace->frame, &workspace->frustum);
    return fxl_clip_common_face(model_view, face, screen, &steps, FXL_PLANES_ALL);
}

const fxl_clipper fxl_clipper_normalised = {clip, NULL, sizeof(fxl_normalised_workspace), NULL};
