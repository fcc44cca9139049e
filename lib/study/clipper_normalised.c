/* SPDX-License-Identifier: MIT */
#include "../clip/volume.h"
#include "../view/outcode.h"
#include "clip_polygon.h"
#include "fetch_normalised.h"

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
    (void)work;
    return clip_in_frustum(model_view, face, screen, &steps);
}

const fxl_clipper fxl_clipper_normalised = {.clip = clip,
                                            .workspace_size = sizeof(fxl_normalised_workspace),
                                            .by_points = &fxl_rounded_faces};
