/* SPDX-License-Identifier: MIT */
#include "../math/family.h"
#include "edge.h"
#include "scan.h"

#if !FXL_KERNELS_ARMV7M || !FXL_SCANS_BY_CHAINS

/* place fill-rule: outlines of two chains, which need no winding number */
/* Goes down a chain to the edge that crosses a row, and sets the edge on that row. */
static void begin_edge(const fxl_scan *scan, fxl_chain *chain, int32_t row, fxl_edge *edge)
{
    const fxl_screen_point *points = scan->points;
    uint32_t vertex, next = chain->vertex, count = scan->count;
    int32_t end_row;
    do {
        vertex = next;
        next += chain->onward;
        next -= next >= count ? count : 0u;
        end_row = fxl_first_centre_from(points[next].y);
    } while (end_row <= row);
    int32_t rows = fxl_edge_set(&points[vertex], &points[next], row, end_row - row, edge);
    chain->end_row = (int16_t)(row + rows);
    chain->vertex = (uint8_t)(row + rows == end_row ? next : vertex);
}

const fxl_trapezoid *fxl_scan_next_trapezoid(fxl_scan *scan)
{
    fxl_trapezoid *trapezoid = &scan->trapezoid;
    int32_t row = trapezoid->end_row;
    int32_t end_row = scan->end_row;
    if (!FXL_SCANS_BY_CHAINS || row >= end_row) {
        return scan->by_chains ? NULL : fxl_scan_next_of_active_edges(scan);
    }
    for (int side = 0; side < 2; side++) {
        fxl_chain *chain = &scan->chains[side];
        if (chain->end_row > row) {
            fxl_edge_advance(&trapezoid->edges[side], (uint32_t)(row - trapezoid->first_row));
        } else {
            begin_edge(scan, chain, row, &trapezoid->edges[side]);
        }
        end_row = chain->end_row < end_row ? chain->end_row : end_row;
    }
    trapezoid->first_row = (int16_t)row;
    trapezoid->end_row = (int16_t)end_row;
    return trapezoid;
}

#endif

/* The edge starts from the exact remainder on the row, so the rows for which it holds count from
 * there. */
/* SPEC 5.3 */
int32_t fxl_edge_set_far(const fxl_screen_point *top, const fxl_screen_point *bottom, int32_t row,
                         int32_t rows, fxl_edge *edge)
{
    fxl_slope slope;
    fxl_slope_set(top, bottom, fxl_centre_of(row), &slope);
    fxl_edge_divider divider = fxl_edge_divider_of(slope.height);
    int32_t unused;
    fxl_edge_divide(&divider, (int32_t)slope.error, &unused, &edge->fraction);
    fxl_edge_divide(&divider, (int32_t)slope.error_step, &unused, &edge->step_fraction);
    edge->x = slope.x;
    edge->step = slope.step;
    uint32_t good = 1u << fxl_edge_divider_shift(&divider);
    return good < (uint32_t)rows ? (int32_t)good : rows;
}
