/* SPDX-License-Identifier: MIT */
/* The text of fxl_draw_outline and fxl_draw_by_active_edges, for pixels of any size. The file that
 * includes this one defines:
 *
 *   FXL_DRAW_OUTLINE, FXL_DRAW_BY_ACTIVE_EDGES  the names of both
 *   FXL_FILL_TRAPEZOID  the function that fills between two chains
 *   FXL_COLOUR          the type of a colour
 *   fill_span           a function that fills a span that active edges found, or more rows
 *
 * Internal. */
#ifndef FXL_DRAW_OUTLINE_TEXT_H
#define FXL_DRAW_OUTLINE_TEXT_H

#include "../math/family.h"
#include "draw_outline.h"
#include "fill.h"
#include "scan.h"

#if !FXL_KERNELS_ARMV7M

bool FXL_DRAW_OUTLINE(fxl_scan *scan, const fxl_screen_polygon *polygon, const fxl_band *band,
                      uint32_t colour)
{
    if (FXL_IS_SMALL) {
        return FXL_DRAW_BY_ACTIVE_EDGES(scan, polygon, band, colour);
    }
    fxl_scan_outline(polygon->points, polygon->count, band, scan);
    const fxl_trapezoid *trapezoid = fxl_scan_next_trapezoid(scan);
    while (trapezoid != NULL) {
        FXL_FILL_TRAPEZOID(band, trapezoid, (FXL_COLOUR)colour);
        trapezoid = fxl_scan_is_over(scan) ? NULL : fxl_scan_next_trapezoid(scan);
    }
    return fxl_scan_reaches(scan, band);
}

#endif

bool FXL_DRAW_BY_ACTIVE_EDGES(fxl_scan *scan, const fxl_screen_polygon *polygon,
                              const fxl_band *band, uint32_t colour)
{
    fxl_active_edges *edges = &scan->active_edges;
    fxl_span span;
#if FXL_IS_COMPACT
    const fxl_rows rows =
        fxl_active_edges_outline(edges, polygon->points, polygon->count, band);
#else
    const fxl_rows rows = fxl_rows_of_points(polygon->points, polygon->count,
                                             (uint16_t)(band->first_row + band->rows));
    fxl_active_edges_begin(edges, polygon->points, polygon->count, rows.first, rows.end, band);
#endif
    while (fxl_active_edges_next(edges, &span)) {
        fill_span(edges, &span, band, (FXL_COLOUR)colour);
    }
    return FXL_IS_SMALL || (rows.first < rows.end && rows.end > band->first_row);
}

#endif
