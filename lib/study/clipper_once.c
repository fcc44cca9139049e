/* SPDX-License-Identifier: MIT */
#define FXL_NORMALISED_WORKSPACE fxl_once_workspace
#include "../clip/volume.h"
#include "fetch_normalised.h"

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
    (void)work;
    return clip_in_frustum(model_view, face, screen, &steps);
}

const fxl_clipper fxl_clipper_once = {
    .clip = clip, .workspace_size = sizeof(fxl_once_workspace), .by_points = &fxl_rounded_faces};
