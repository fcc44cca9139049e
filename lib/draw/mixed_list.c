/* SPDX-License-Identifier: MIT */
/* The display list of a renderer whose polygons are not all flat. */
#include "../paint/billboard_paint.h"
#include "display_list.h"
#include "surface_polygon.h"

const void *fxl_find_shader(const fxl_renderer *renderer, uint32_t rank)
{
    return fxl_renderer_shader(renderer, rank);
}

bool fxl_mixed_draw_list(const fxl_traversal *traversal)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_band *band = traversal->band;
    const fxl_rows wanted = {band->first_row, (uint16_t)(band->first_row + band->rows)};
    const fxl_surfaces *surfaces = fxl_surfaces_of(renderer);
    const fxl_screen_polygon *record;
    uint32_t place = 0;
    while ((record = fxl_display_list_next(&renderer->frame.display_list, wanted, &place)) !=
           NULL) {
        if (record->kind == FXL_POLYGON_FLAT) {
            if (!renderer->target->flat(traversal->workspace, record, band)) {
                return false;
            }
        } else if (record->kind == FXL_POLYGON_SURFACE) {
            surfaces->painter->draw(surfaces, traversal->workspace, record, band);
            fxl_outline_polygon(traversal, record->points, fxl_surface_polygon_points(record));
        } else if (record->kind == FXL_POLYGON_DEPTH) {
            renderer->target->extras->flat(traversal->workspace, record, band);
        } else if (record->kind == FXL_POLYGON_LINE) {
            const fxl_overdraw *lines =
                (const fxl_overdraw *)fxl_find_shader(renderer, FXL_SHADER_LINES);
            lines->draw_record(traversal->workspace, record, band);
        } else {
            const fxl_billboards *billboards = renderer->billboards;
            billboards->painter->paint(renderer, traversal->workspace, record->points, band);
        }
    }
    return true;
}
