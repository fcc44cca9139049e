/* SPDX-License-Identifier: MIT */
/* Every face is assembled, cut by the planes that a vertex is outside of, mostly
 * none, and projected. One that is inside covers no centre where all its vertices have the
 * same first column of centres from them on; that it reaches no row is found as for any. */
#include "clip_flat.h"
#include "edge.h"
#include "fixel/clipper.h"
#include "project_any.h"

fxl_clip_result fxl_clip_by_view(const fxl_placed *placed, const fxl_face *face,
                                 fxl_clipper_work *work, fxl_screen_polygon *screen)
{
    const uint16_t *corners = placed->corners + face->first_corner;
    const fxl_view *view = placed->view;
    fxl_view_polygon *seen = &work->by_view.polygons[0];
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
        fxl_clip_view_flat(seen, &view->view_frustum, (fxl_planes)(of_any & FXL_PLANES_ALL),
                           &work->by_view, view->room, &clipped);
    if (clipped == NULL) {
        return result;
    }
    screen->colour = clipped->colour;
    screen->count = clipped->count;
    _Static_assert(FXL_CLIP_INSIDE == 0, "what is cut is not asked");
    int32_t columns = (int32_t)result; /* and bits in which any differs from the first */
    for (uint32_t i = 0; i < clipped->count; i++) {
        fxl_screen_point *point = &screen->points[i];
        if (fxl_project_any(&view->projection, &clipped->vertices[i].position, point) != FXL_OK) {
            return FXL_CLIP_RANGE;
        }
        columns |= fxl_first_centre_from(point->x) ^ fxl_first_centre_from(screen->points[0].x);
    }
    return columns == 0 ? FXL_CLIP_BETWEEN : result;
}
