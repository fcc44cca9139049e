/* SPDX-License-Identifier: MIT */
#include "draw_outline.h"
#include "fill.h"

#include "active_edges.h"

bool fxl_draw_by_active_edges(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                              fxl_scan *scan)
{
    fxl_span span;
    const fxl_rows rows =
        fxl_rows_of_points(points, count, (uint16_t)(band->first_row + band->rows));
    fxl_active_edges_begin(&scan->active_edges, points, count, rows.first, rows.end, band);
    while (fxl_active_edges_next(&scan->active_edges, &span)) {
        if (FXL_IS_SMALL) {
            fxl_active_edges_fill(&scan->active_edges, &span, band, scan->colour);
        } else {
            fxl_fill_span(band, &span, scan->colour);
        }
    }
    return FXL_IS_SMALL || (rows.first < rows.end && rows.end > band->first_row);
}
