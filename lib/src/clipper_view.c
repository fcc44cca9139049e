/* SPDX-License-Identifier: MIT */
#include "fixel/clipper.h"
#include "fixel/project.h"

/* A face of which some vertex is outside: assembled, cut by the planes that a
 * vertex is outside of, and projected. */
static fxl_clip_result cut(const fxl_placed *placed, const fxl_face *face, fxl_planes planes,
                           fxl_clip_view_work *work, fxl_screen_polygon *screen)
{
    const uint16_t *corners = placed->corners + face->first_corner;
    const fxl_view *view = placed->view;
    fxl_view_polygon *seen = &work->polygons[0];
    const fxl_view_polygon *clipped;
    seen->colour = face->colour;
    seen->count = face->count;
    seen->textured = false;
    for (uint32_t i = 0; i < face->count; i++) {
        seen->vertices[i].position = fxl_see(placed, corners[i])->position;
    }
    fxl_clip_result result =
        fxl_clip_view_to_planes(seen, &view->view_frustum, planes, work, &clipped);
    if (clipped == NULL) {
        return result;
    }
    return fxl_project_polygon(&view->lens, clipped, screen) == FXL_OK ? result : FXL_CLIP_RANGE;
}

/* Vertices are projected as they come while none is outside, which mostly stays
 * so: then that was all. */
fxl_clip_result fxl_clip_by_view(const fxl_placed *placed, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    const uint16_t *corners = placed->corners + face->first_corner;
    fxl_planes of_any = 0, of_all = placed->planes;
    for (uint32_t i = 0; i < face->count; i++) {
        fxl_seen_vertex *seen = fxl_see(placed, corners[i]);
        of_any |= seen->outside;
        of_all &= seen->outside;
        if (of_any != 0) {
            continue;
        }
        if (!seen->projected) {
            if (fxl_project_point(&placed->view->lens, &seen->position, &seen->screen) != FXL_OK) {
                return FXL_CLIP_RANGE;
            }
            seen->projected = true;
        }
        screen->points[i] = seen->screen;
    }
    if (of_all != 0) {
        return FXL_CLIP_OUTSIDE;
    }
    if (of_any != 0) {
        return cut(placed, face, of_any, &work->by_view, screen);
    }
    screen->colour = face->colour;
    screen->count = face->count;
    return FXL_CLIP_INSIDE;
}
