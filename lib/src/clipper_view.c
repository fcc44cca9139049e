/* SPDX-License-Identifier: MIT */
#include "fixel/clipper.h"
#include "fixel/project.h"

#include "counted.h"

_Static_assert((FXL_PLANES_ALL & FXL_SEEN_UNPROJECTED) == 0, "both share a byte");

/* A face with a vertex that is outside: assembled, cut by the planes that a
 * vertex is outside of, and projected. */
static fxl_clip_result cut(const fxl_placed *placed, const fxl_face *face, fxl_clip_view_work *work,
                           fxl_screen_polygon *screen)
{
    const uint16_t *corners = placed->corners + face->first_corner;
    const fxl_view *view = placed->view;
    fxl_view_polygon *seen = &work->polygons[0];
    const fxl_view_polygon *clipped;
    unsigned of_any = 0, of_all = FXL_PLANES_ALL;
    for (uint32_t i = 0; i < face->count; i++) {
        const fxl_seen_vertex *vertex = fxl_see(placed, corners[i]);
        of_any |= vertex->state;
        of_all &= vertex->state;
        seen->vertices[i].position = vertex->position;
    }
    if (of_all != 0) {
        return FXL_CLIP_OUTSIDE;
    }
    seen->colour = face->colour;
    seen->count = face->count;
    seen->textured = false;
    fxl_clip_result result =
        fxl_cut_view_by_planes(seen, &view->view_frustum, (fxl_planes)(of_any & FXL_PLANES_ALL),
                               work, view->room, &clipped);
    if (clipped == NULL) {
        return result;
    }
    screen->colour = clipped->colour;
    screen->count = clipped->count;
    for (uint32_t i = 0; i < clipped->count; i++) {
        if (fxl_project_seen(&view->projection, &clipped->vertices[i].position,
                             &screen->points[i]) != FXL_OK) {
            return FXL_CLIP_RANGE;
        }
    }
    return result;
}

/* Mostly every vertex is inside: then their places on the screen are the result. */
fxl_clip_result fxl_clip_by_view(const fxl_placed *placed, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    const uint16_t *corners = placed->corners + face->first_corner;
    fxl_screen_point *point = screen->points;
    for (const uint16_t *end = corners + face->count; corners < end; corners++, point++) {
        fxl_seen_vertex *vertex = fxl_see(placed, *corners);
        if (vertex->state != 0) {
            if (vertex->state != FXL_SEEN_UNPROJECTED) {
                return cut(placed, face, &work->by_view, screen);
            }
            if (fxl_project_seen(&placed->view->projection, &vertex->position, &vertex->screen) !=
                FXL_OK) {
                return FXL_CLIP_RANGE;
            }
            vertex->state = 0;
        }
        *point = vertex->screen;
    }
    screen->colour = face->colour;
    screen->count = face->count;
    return FXL_CLIP_INSIDE;
}

const fxl_clipper fxl_clipper_view = {.clip = fxl_clip_by_view};
