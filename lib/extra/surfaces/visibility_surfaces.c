/* SPDX-License-Identifier: MIT */
#include "../../src/draw/draw_band.h"
#include "surface_polygon.h"

static bool draw_list(const fxl_traversal *on)
{
    const fxl_renderer *renderer = on->renderer;
    const fxl_surfaces *surfaces = fxl_surfaces_of(renderer);
    const fxl_band *band = on->band;
    const fxl_rows wanted = {band->first_row, (uint16_t)(band->first_row + band->rows)};
    fxl_display_list_record record;
    uint32_t place = 0;
    while (fxl_display_list_next(&renderer->frame.display_list, wanted, &place, &record)) {
        fxl_scan *scan = &on->workspace->work.scan;
        if (record.kind == FXL_POLYGON_SURFACE) {
            fxl_surface_polygon polygon;
            const uint32_t count = fxl_surface_polygon_read(&record, &polygon);
            fxl_surface_polygon_paint(surfaces, &polygon, record.points, count, band, scan);
        } else {
            fxl_draw_over(on->workspace, record.points, record.count, record.colour, band);
        }
    }
    return true;
}

static void draw_band(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band)
{
    (void)fxl_draw_band_by(renderer, workspace, band, draw_list);
}

bool fxl_draws_surfaces(const fxl_renderer *renderer)
{
    return renderer->visibility->backend->draw_band == draw_band;
}

const fxl_raster_backend fxl_raster_surfaces = {
    .draw_band = draw_band, .draw_polygon = fxl_draw_over, .draws_over = true};

const fxl_visibility fxl_visibility_surfaces = {.submit = fxl_submit_by_distance,
                                                .backend = &fxl_raster_surfaces};
