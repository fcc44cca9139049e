/* SPDX-License-Identifier: MIT */
#include "chains.h"

#include "scan_crossings.h"

/* No outline is scanned by chains (scan.c): a span as a trapezoid of one row. */
const fxl_trapezoid *fxl_scan_next_trapezoid(fxl_scan *scan)
{
    fxl_span span;
    fxl_trapezoid *trapezoid = &scan->trapezoid;
    if (!fxl_crossings_next(&scan->crossings, &span)) {
        return NULL;
    }
    trapezoid->first_row = span.y;
    trapezoid->end_row = (int16_t)(span.y + 1);
    trapezoid->edges[0] = (fxl_edge){span.x0, 0, 0, 0};
    trapezoid->edges[1] = (fxl_edge){span.x1, 0, 0, 0};
    return trapezoid;
}
