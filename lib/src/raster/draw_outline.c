/* SPDX-License-Identifier: MIT */
#include "draw_outline.h"

#include "../math/arith.h"
#include "active_edges.h"
#include "fixel/stage/fill.h"

bool fxl_draw_by_active_edges(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                              fxl_scan *scan)
{
    fxl_span span;
    fxl_scan_outline(points, count, band, scan);
    FXL_ASSERT(!scan->by_chains);
    while (fxl_active_edges_next(&scan->active_edges, &span)) {
        fxl_fill_span(band, &span, scan->colour);
    }
    return FXL_IS_SMALL || fxl_scan_reaches(scan, band);
}
