/* SPDX-License-Identifier: MIT */
#include "../math/family.h"
#include "draw_outline.h"
#include "fill.h"
#include "scan.h"

#if !FXL_KERNELS_ARMV7M

bool fxl_draw_outline(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                      fxl_scan *scan)
{
    if (FXL_IS_SMALL) {
        return fxl_draw_by_active_edges(points, count, band, scan);
    }
    fxl_scan_outline(points, count, band, scan);
    const fxl_trapezoid *trapezoid = fxl_scan_next_trapezoid(scan);
    while (trapezoid != NULL) {
        fxl_fill_trapezoid(band, trapezoid, scan->colour);
        trapezoid = fxl_scan_is_over(scan) ? NULL : fxl_scan_next_trapezoid(scan);
    }
    return fxl_scan_reaches(scan, band);
}

#endif

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
