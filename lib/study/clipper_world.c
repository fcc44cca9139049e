/* SPDX-License-Identifier: MIT */

#include "../view/cull.h"
#include "../view/model_view.h"
#include "../view/outcode.h"
#include "../view/project.h"
#include "../view/view.h"
#include "clip_common.h"
#include "clip_world.h"
#include "clippers.h"

/* The planes of the world clip vertices before they are transformed. So entries of the vertex
 * cache have no outcodes here. */
static fxl_cached_vertex *fetch(const fxl_model_view *model_view, uint32_t number)
{
    bool is_new;
    fxl_cached_vertex *entry = fxl_clip_common_entry(model_view, number, &is_new);
    if (is_new) {
        fxl_model_view_position(model_view, number, &entry->position);
        entry->clip_flags = FXL_VERTEX_UNPROJECTED;
    }
    return entry;
}

static fxl_status project(const fxl_model_view *model_view, const fxl_view_point *point,
                          fxl_screen_point *screen)
{
    return fxl_project_visible(&model_view->view->projection, point, screen);
}

/* A polygon that no plane cut is the face itself. Then the projected vertices in the vertex
 * cache are the result. */
/* clippers 4.4 */
fxl_clip_result fxl_clip_by_world(const fxl_model_view *model_view, const fxl_face *face,
                                  fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    static const fxl_clip_steps steps = {.fetch = fetch, .project = project};
    const fxl_view *view = model_view->view;
    fxl_polygon *polygon = &work->by_world.polygons[0];
    const fxl_polygon *clipped = polygon;
    fxl_clip_result result = FXL_CLIP_INSIDE;
    if (model_view->planes != 0) {
        fxl_face_to_polygon(model_view, face, polygon);
        result = fxl_clip_world_by_planes(
            polygon, &view->frustum, model_view->planes, FXL_PLANES_ALL, &work->by_world,
            (fxl_clip_stats *)model_view->clipper_workspace, &clipped);
    }
    if (result == FXL_CLIP_INSIDE) {
        return fxl_clip_common_whole(model_view, face, screen, &steps, 0);
    }
    if (clipped == NULL) {
        return result;
    }
    for (uint32_t i = 0; i < clipped->count; i++) {
        fxl_view_point view_point;
        fxl_transform_point(&view->camera, &clipped->vertices[i].position, &view_point);
        if (fxl_project_visible(&view->projection, &view_point, &screen->points[i]) != FXL_OK) {
            return FXL_CLIP_RANGE;
        }
    }
    screen->colour = clipped->colour;
    screen->count = clipped->count;
    return FXL_CLIP_CUT;
}

const fxl_clipper fxl_clipper_world = {.clip = fxl_clip_by_world,
                                       .begin = fxl_view_set_world_frustum,
                                       .by_points = &fxl_rounded_faces};
