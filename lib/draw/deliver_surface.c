/* SPDX-License-Identifier: MIT */
/* Where the polygons of a face with a surface, or with a depth, go. */
#include "submit_sorted.h"
#include "../paint/billboard_paint.h"
#include "surface_polygon.h"

const fxl_surfaces *fxl_surfaces_of(const fxl_renderer *renderer)
{
    const fxl_shader *first = renderer->shader;
    return first != NULL && first->rank == FXL_SHADER_SURFACES
               ? (const fxl_surfaces *)(const void *)first
               : NULL;
}

void fxl_find_corner(const fxl_model_view *model_view, uint32_t number, const fxl_traversal *on,
                     fxl_view_point *corner)
{
    if (on->clipper->by_clip_flags) {
        *corner = fxl_fetch_vertex(model_view, number)->position;
    } else {
        fxl_cached_vertex vertex;
        fxl_transform_vertex(model_view, number, &vertex);
        *corner = vertex.position;
    }
}

static fxl_outcome deliver(const fxl_traversal *on, const fxl_surface_polygon *polygon)
{
    fxl_workspace *workspace = on->workspace;
    const fxl_screen_polygon *screen = &workspace->screen;
    const fxl_rows rows = fxl_scan_rows(screen, on->renderer->frame.view.lens.height);
    if (rows.first == rows.end) {
        return 0;
    }
    if (on->display_list != NULL) {
        return fxl_surface_polygon_append(on->display_list, screen, rows, polygon)
                   ? 0
                   : FXL_OUTCOME_FULL;
    }
    if (on->way == FXL_SUBMIT_MEASURE) {
        fxl_rows_add(on->reached, rows);
    } else {
        fxl_surface_backend_of(on->renderer)
            ->paint(on->renderer, workspace, polygon, screen->points, screen->count, on->band);
    }
    return FXL_OUTCOME_SPILLED;
}

fxl_outcome fxl_submit_surface_polygons(const fxl_model_view *model_view, const fxl_face *face,
                                        const fxl_traversal *on, fxl_surface_finder *find,
                                        const void *what)
{
    fxl_surface_polygon polygon;
    bool found = false;
    fxl_clip_result cut = fxl_first_polygon(model_view, face, on);
    fxl_outcome outcome = (fxl_outcome)1 << cut;
    while (cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_CUT) {
        if (!found) {
            find(what, model_view, face, on, &polygon);
            found = true;
        }
        outcome |= deliver(on, &polygon);
        if (on->clipper->next == NULL || outcome >= FXL_OUTCOME_FULL) {
            break;
        }
        cut = fxl_next_polygon(model_view, on);
        outcome |= (fxl_outcome)1 << cut;
    }
    return outcome;
}

bool fxl_surface_draw_list(const fxl_traversal *on)
{
    const fxl_renderer *renderer = on->renderer;
    const fxl_surface_backend *backend = fxl_surface_backend_of(renderer);
    const fxl_band *band = on->band;
    const fxl_rows wanted = {band->first_row, (uint16_t)(band->first_row + band->rows)};
    fxl_display_list_record record;
    uint32_t place = 0;
    while (fxl_display_list_next(&renderer->frame.display_list, wanted, &place, &record)) {
        if (record.kind == FXL_POLYGON_FLAT) {
            (void)backend->backend.draw_polygon(on->workspace, record.points, record.count,
                                                record.colour, band);
        } else if (record.kind == FXL_POLYGON_SURFACE) {
            fxl_surface_polygon polygon;
            const uint32_t count = fxl_surface_polygon_read(&record, &polygon);
            backend->paint(renderer, on->workspace, &polygon, record.points, count, band);
        } else {
            fxl_billboards_of(renderer)->of.painter->paint(renderer, on->workspace, record.points,
                                                           band);
        }
    }
    return true;
}
