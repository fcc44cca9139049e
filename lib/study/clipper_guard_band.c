/* SPDX-License-Identifier: MIT */
/* The clippers that leave sides of the screen to the scan. They clip to near and far, to the
 * given sides at the border of the screen, and to the other sides at the guard band. */
#include "../clip/volume.h"
#include "../view/model_view.h"
#include "../view/outcode.h"
#include "../view/project.h"
#include "../view/view.h"
#include "clip_common.h"
#include "clip_polygon.h"

static fxl_volume_workspace *workspace_of(const fxl_model_view *model_view)
{
    return (fxl_volume_workspace *)model_view->clipper_workspace;
}

/* Fetches a vertex as the default clipper does. A vertex that is outside of a side which the
 * scan clips is tested against the guard band. The test uses the position of the vertex alone,
 * so all faces that share the vertex agree. */
/* clippers 4.4 */
static fxl_cached_vertex *fetch(const fxl_model_view *model_view, uint32_t number)
{
    fxl_cached_vertex *entry = &model_view->entries[number & model_view->mask];
    if (entry->tag != model_view->tag + number) {
        fxl_volume_workspace *workspace = workspace_of(model_view);
        fxl_transform_vertex(model_view, number, entry);
        if ((entry->clip_flags & FXL_PLANES_ALL & ~workspace->screen) != 0) {
            workspace->clip.stats.distances += FXL_PLANE_COUNT;
            if ((fxl_volume_code(&workspace->volume, &entry->position) & ~workspace->screen) != 0) {
                entry->clip_flags |= FXL_VERTEX_BEYOND_GUARD_BAND;
            }
        }
    }
    return entry;
}

static fxl_status project(const fxl_model_view *model_view, const fxl_view_point *point,
                          fxl_screen_point *to)
{
    return fxl_project_visible(&model_view->view->projection, point, to);
}

static fxl_varying_polygon *input(const fxl_model_view *model_view)
{
    return &workspace_of(model_view)->clip.polygons[0];
}

/* Where a vertex is beyond the guard band, the volume's own outcodes choose the sides that cut. */
static fxl_clip_result cut(const fxl_model_view *model_view, const fxl_varying_polygon *in,
                           unsigned any, const fxl_varying_polygon **result)
{
    fxl_volume_workspace *workspace = workspace_of(model_view);
    uint32_t by = any & workspace->screen;
    if ((any & FXL_VERTEX_BEYOND_GUARD_BAND) != 0) {
        workspace->clip.stats.distances += FXL_PLANE_COUNT * (uint32_t)in->count;
        for (uint32_t i = 0; i < in->count; i++) {
            by |= fxl_volume_code(&workspace->volume, &in->vertices[i].position);
        }
    }
    return fxl_clip_polygon_by_volume(in, by, &workspace->volume, &workspace->clip, result);
}

/* screen: the planes at the border of the screen, near and far among them. A workspace belongs to
 * one clipper, so they are the same in every call. */
/* clippers 4.4 */
static fxl_clip_result clip_with_guard_band(const fxl_model_view *model_view, const fxl_face *face,
                                            unsigned screen, fxl_screen_polygon *polygon)
{
    static const fxl_clip_steps steps = {fetch, project, input, cut};
    const fxl_view *view = model_view->view;
    fxl_volume_workspace *workspace = workspace_of(model_view);
    if (workspace->frame != view->frame) {
        fxl_volume_from_sides(&view->view_frustum, fxl_view_drawn_focal(view), screen,
                              &workspace->volume);
        workspace->screen = screen;
        workspace->frame = view->frame;
    }
    return fxl_clip_common_face(model_view, face, polygon, &steps,
                                screen | FXL_VERTEX_BEYOND_GUARD_BAND);
}

/* Near and far alone. The scan clips to the sides of the screen. */
static fxl_clip_result clip_near(const fxl_model_view *model_view, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    (void)work;
    return clip_with_guard_band(model_view, face, FXL_PLANES_DEPTH, screen);
}

/* place clipper: a new file beside it: the code and its record */
const fxl_clipper fxl_clipper_near = {.clip = clip_near,
                                      .workspace_size = sizeof(fxl_volume_workspace)};

/* Near, far and the left side of the screen, so no span begins left of it. The scan shortens spans
 * on the right and skips rows above and below. */
#define LEFT_AND_DEPTH (FXL_PLANES_DEPTH | 1u << FXL_PLANE_LEFT)

static fxl_clip_result clip_left(const fxl_model_view *model_view, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    (void)work;
    return clip_with_guard_band(model_view, face, LEFT_AND_DEPTH, screen);
}

const fxl_clipper fxl_clipper_left = {.clip = clip_left,
                                      .workspace_size = sizeof(fxl_volume_workspace)};
