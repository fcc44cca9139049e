/* SPDX-License-Identifier: MIT */
#include "fixel/cull.h"
#include "fixel/project.h"
#include "fixel/transform.h"

#include "counted.h"
#include "family.h"
#include "rotate.h"

/* Planes of the world know vertices before the view does: an entry of the cache has
 * no codes here. */
static fxl_seen_vertex *see(const fxl_placed *placed, uint32_t number)
{
    bool is_new;
    fxl_seen_vertex *entry = fxl_family_entry(placed, number, &is_new);
    if (is_new) {
        fxl_point from_eye = fxl_placed_vertex(placed, number);
        fxl_rotate(&placed->view->camera, &from_eye, &entry->position);
        entry->state = FXL_SEEN_UNPROJECTED;
    }
    return entry;
}

static fxl_status project(const fxl_placed *placed, const fxl_view_point *point,
                          fxl_screen_point *screen)
{
    return fxl_project_seen(&placed->view->projection, point, screen);
}

/* A polygon that no plane cut is the face itself: then its vertices' kept places on the
 * screen are the result. */
fxl_clip_result fxl_clip_by_world(const fxl_placed *placed, const fxl_face *face,
                                  fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    static const fxl_way way = {.see = see, .project = project};
    fxl_view *view = placed->view;
    fxl_polygon *polygon = &work->by_world.polygons[0];
    const fxl_polygon *clipped = polygon;
    fxl_clip_result result = FXL_CLIP_INSIDE;
    if (placed->planes != 0) {
        fxl_face_to_polygon(placed, face, polygon);
        result = fxl_cut_world_by_planes(polygon, fxl_view_world_frustum(view), placed->planes,
                                         &work->by_world, view->room, &clipped);
    }
    if (result == FXL_CLIP_INSIDE) { /* bug: world-in-place */
        return fxl_family_take_whole(placed, face, screen, &way, 0);
    }
    if (clipped == NULL) {
        return result;
    }
    for (uint32_t i = 0; i < clipped->count; i++) {
        fxl_view_point seen;
        fxl_transform_point(&view->camera, &clipped->vertices[i].position, &seen);
        if (fxl_project_seen(&view->projection, &seen, &screen->points[i]) != FXL_OK) {
            return FXL_CLIP_RANGE;
        }
    }
    screen->colour = clipped->colour;
    screen->count = clipped->count;
    return FXL_CLIP_CUT;
}

const fxl_clipper fxl_clipper_world = {.clip = fxl_clip_by_world};
