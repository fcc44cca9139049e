/* SPDX-License-Identifier: MIT */
/* On each row every edge is tested, and one that crosses the row is divided anew. Outlines that are
 * scanned so have few edges, and nothing needs to be set up or kept from row to row. */
#include "active_edges.h"

#include "edge.h"

/* If the edge crosses the row, inserts its crossing in the order of x. The edge is always computed
 * from its top, so both polygons of an edge get the same bits. */
static void insert_crossing(fxl_active_edges *crossings, const fxl_screen_point *from,
                            const fxl_screen_point *to)
{
    const bool down = from->y < to->y;
    const fxl_screen_point *top = down ? from : to, *bottom = down ? to : from;
    int32_t rows = crossings->row - fxl_first_centre_from(top->y);
    if (rows < 0 || fxl_first_centre_from(bottom->y) <= crossings->row) {
        return;
    }
    int32_t dx = bottom->x - top->x, height = bottom->y - top->y, start = top->x - FXL_HALF_PIXEL;
    /* The dividend of fxl_slope_set is below 2^30. It grows by dx a row, for fewer than 2^13 rows,
     * so it is below 2^43. */
    int64_t dividend =
        fxl_edge_first_dividend(start, dx, height, top->y) + fxl_multiply_s32(dx, rows);
    int32_t x = (start >> 16) + 1 + fxl_divide_down(dividend, (uint32_t)height);
    fxl_crossing *place = &crossings->found[crossings->found_count++];
    for (; place > crossings->found && place[-1].x > x; place--) {
        *place = place[-1];
    }
    place->x = x;
    place->winding = down ? 1 : -1;
}

void fxl_active_edges_begin(fxl_active_edges *crossings, const fxl_screen_point *points,
                            uint32_t count, int32_t first_row, int32_t end_row,
                            const fxl_band *band)
{
    int32_t band_end = band->first_row + band->rows;
    crossings->points = points;
    crossings->count = (uint8_t)count;
    crossings->found_count = 0;
    crossings->next = 0;
    crossings->width = (int16_t)band->width;
    crossings->row = (int16_t)((first_row < band->first_row ? band->first_row : first_row) - 1);
    crossings->end_row = (int16_t)(end_row < band_end ? end_row : band_end);
}

/* Finds the crossings of the next row. Returns false if there is no next row. */
static bool next_row(fxl_active_edges *crossings)
{
    if (crossings->row + 1 >= crossings->end_row) {
        return false; /* an empty scan has no points */
    }
    const fxl_screen_point *points = crossings->points;
    const fxl_screen_point *previous = &points[crossings->count - 1];
    crossings->row = (int16_t)(crossings->row + 1);
    crossings->found_count = 0;
    crossings->next = 0;
    for (uint32_t left = crossings->count; left != 0; left--) {
        insert_crossing(crossings, previous, points);
        previous = points++;
    }
    return true;
}

/* Finds the row's next stretch of pixels with a winding number other than 0. Crossings at the same
 * x count together. The windings of a closed outline add up to 0 on every row. */
static void next_stretch(fxl_active_edges *crossings, int32_t *x0, int32_t *x1)
{
    const fxl_crossing *crossing = &crossings->found[crossings->next];
    int32_t winding = 0;
    *x0 = crossing->x;
    do {
        *x1 = crossing->x;
        winding += crossing->winding;
        crossing++;
        crossings->next += 1;
        /* bug: even-odd */
    } while (crossings->next < crossings->found_count && (winding != 0 || crossing->x == *x1));
    FXL_ASSERT(winding == 0);
}

bool fxl_active_edges_next(fxl_active_edges *crossings, fxl_span *span)
{
    do {
        while (crossings->next < crossings->found_count) {
            int32_t x0, x1;
            next_stretch(crossings, &x0, &x1);
            x0 = x0 < 0 ? 0 : x0;
            x1 = x1 > crossings->width ? crossings->width : x1;
            if (x0 < x1) {
                span->y = crossings->row;
                span->x0 = (int16_t)x0;
                span->x1 = (int16_t)x1;
                return true;
            }
        }
    } while (next_row(crossings));
    return false;
}
