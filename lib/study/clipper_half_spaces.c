/* SPDX-License-Identifier: MIT */
/* A clipper whose outcodes and cuts use six homogeneous half-spaces, which need not form a
 * frustum. */
#include "../clip/volume.h"
#include "../view/model_view.h"
#include "../view/outcode.h"
#include "../view/project.h"
#include "../view/view.h"
#include "clip_common.h"
#include "clip_polygon.h"

/* clippers 4.2 */
static fxl_volume_workspace *workspace_of(const fxl_model_view *model_view)
{
    return (fxl_volume_workspace *)model_view->clipper_workspace;
}

/* Transforms as fxl_transform_vertex does, to the same integers. */
static fxl_cached_vertex *fetch(const fxl_model_view *model_view, uint32_t number)
{
    bool is_new;
    fxl_cached_vertex *entry = fxl_clip_common_entry(model_view, number, &is_new);
    if (is_new) {
        fxl_volume_workspace *workspace = workspace_of(model_view);
        fxl_model_view_position(model_view, number, &entry->position);
        entry->clip_flags = FXL_VERTEX_UNPROJECTED;
        if (model_view->planes != 0) {
            workspace->clip.stats.distances += FXL_PLANE_COUNT;
            entry->clip_flags |= (uint8_t)(fxl_volume_code(&workspace->volume, &entry->position) &
                                           model_view->planes);
        }
    }
    return entry;
}

static fxl_status project(const fxl_model_view *model_view, const fxl_view_point *point,
                          fxl_screen_point *screen)
{
    return fxl_project_visible(&model_view->view->projection, point, screen);
}

static fxl_varying_polygon *input(const fxl_model_view *model_view)
{
    return &workspace_of(model_view)->clip.polygons[0];
}

/* clippers 4.2 */
static fxl_clip_result cut(const fxl_model_view *model_view, const fxl_varying_polygon *in,
                           unsigned any, const fxl_varying_polygon **result)
{
    fxl_volume_workspace *workspace = workspace_of(model_view);
    return fxl_clip_polygon_by_volume(in, any & FXL_PLANES_ALL, &workspace->volume,
                                      &workspace->clip, result);
}

static fxl_clip_result clip(const fxl_model_view *model_view, const fxl_face *face,
                            fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    static const fxl_clip_steps steps = {fetch, project, input, cut};
    const fxl_view *view = model_view->view;
    fxl_volume_workspace *workspace = workspace_of(model_view);
    (void)work;
    if (workspace->frame != view->frame) {
        fxl_volume_from_sides(&view->view_frustum, fxl_view_drawn_focal(view), FXL_PLANES_ALL,
                              &workspace->volume);
        workspace->frame = view->frame;
    }
    return fxl_clip_common_face(model_view, face, screen, &steps, FXL_PLANES_ALL);
}

/* place clipper: a new file beside it: the code and its record */
const fxl_clipper fxl_clipper_half_spaces = {
    .clip = clip, .workspace_size = sizeof(fxl_volume_workspace), .by_points = &fxl_rounded_faces};
