/* SPDX-License-Identifier: MIT */
#include "fixel/stage/cull.h"
#include "fixel/stage/project.h"
#include "fixel/stage/transform.h"

#include "clip_world_by_planes.h"
#include "clip_common.h"
#include "../../src/view/rotate.h"

/* Planes of the world know vertices before the view does: an entry of the cache has
 * no codes here. */
static fxl_cached_vertex *see(const fxl_model_view *model_view, uint32_t number)
{
    bool is_new;
    fxl_cached_vertex *entry = fxl_clip_common_entry(model_view, number, &is_new);
    if (is_new) {
        fxl_point from_eye = fxl_model_view_vertex(model_view, number);
        fxl_rotate(&model_view->view->camera, &from_eye, &entry->position);
        entry->clip_flags = FXL_VERTEX_UNPROJECTED;
    }
    return entry;
}

static fxl_status project(const fxl_model_view *model_view, const fxl_view_point *point,
                          fxl_screen_point *screen)
{
    return fxl_project_visible(&model_view->view->projection, point, screen);
}

/* A polygon that no plane cut is the face itself: then its vertices' kept places on the
 * screen are the result. */
fxl_clip_result fxl_clip_by_world(const fxl_model_view *model_view, const fxl_face *face,
                                  fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    static const fxl_clip_steps way = {.see = see, .project = project};
    const fxl_view *view = model_view->view;
    fxl_polygon *polygon = &work->by_world.polygons[0];
    const fxl_polygon *clipped = polygon;
    fxl_clip_result result = FXL_CLIP_INSIDE;
    if (model_view->planes != 0) {
        fxl_face_to_polygon(model_view, face, polygon);
        result = fxl_clip_world_by_planes(polygon, &view->frustum, model_view->planes,
                                          &work->by_world, view->clipper_workspace, &clipped);
    }
    if (result == FXL_CLIP_INSIDE) { /* bug: world-in-place */
        return fxl_clip_common_whole(model_view, face, screen, &way, 0);
    }
    if (clipped == NULL) {
        return result;
    }
    for (uint32_t i = 0; i < clipped->count; i++) {
        fxl_view_point seen;
        fxl_transform_point(&view->camera, &clipped->vertices[i].position, &seen);
        if (fxl_project_visible(&view->projection, &seen, &screen->points[i]) != FXL_OK) {
            return FXL_CLIP_RANGE;
        }
    }
    screen->colour = clipped->colour;
    screen->count = clipped->count;
    return FXL_CLIP_CUT;
}

const fxl_clipper fxl_clipper_world = {.clip = fxl_clip_by_world,
                                       .begin = fxl_view_set_world_frustum};
