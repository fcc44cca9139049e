/* SPDX-License-Identifier: MIT */
#include "fixel/project.h"
#include "seen.h"

/* Mostly every vertex is inside: then their places on the screen are the result. */
fxl_clip_result fxl_clip_by_view(const fxl_placed *placed, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    if (FXL_IS_SMALL) {
        return fxl_clip_seen(placed, face, work, screen);
    }
    const uint16_t *corners = placed->corners + face->first_corner;
    fxl_screen_point *point = screen->points;
    uint32_t of_any = 0, of_all = UINT32_MAX;
    for (const uint16_t *end = corners + face->count; corners < end; corners++, point++) {
        fxl_seen_vertex *vertex = fxl_see(placed, *corners);
        uint32_t state = vertex->state;
        if ((state & FXL_SEEN_OUTSIDE) != 0) {
            if (state != FXL_SEEN_UNPROJECTED) {
                return fxl_clip_seen(placed, face, work, screen);
            }
            if (fxl_project_inside(&placed->view->projection, &vertex->position, &vertex->screen) !=
                FXL_OK) {
                return FXL_CLIP_RANGE;
            }
            state = fxl_seen_on_screen(&vertex->screen);
            vertex->state = state;
        }
        of_any |= state;
        of_all &= state; /* bug: between-two */
        *point = vertex->screen;
    }
    screen->colour = face->colour;
    screen->count = face->count;
    uint32_t differing = of_any ^ of_all;
    return (differing & FXL_SEEN_COLUMN) == 0 || (differing & FXL_SEEN_ROW) == 0 ? FXL_CLIP_BETWEEN
                                                                                 : FXL_CLIP_INSIDE;
}
