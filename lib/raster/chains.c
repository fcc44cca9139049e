/* SPDX-License-Identifier: MIT */

#include "../math/family.h"
#include "edge.h"
#include "scan.h"

#if !FXL_KERNELS_ARMV7M

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
    if (FXL_IS_SMALL || row >= end_row) {
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
