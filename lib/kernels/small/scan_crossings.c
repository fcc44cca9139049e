/* SPDX-License-Identifier: MIT */
/* On every row every edge is looked at, and divided anew where it crosses the row:
 * nothing is set up and nothing walked. */
#include "scan_crossings.h"

#include "chains.h"
#include "edge.h"

/* floor(numerator / height), the quotient below 2^31. Downward, that of -1 - n is -1 less
 * that of n. */
static int32_t divide_floor(int64_t numerator, uint32_t height)
{
    uint32_t rest;
    int64_t sign = numerator >> 63;
    return (int32_t)fxl_divide_u64((uint64_t)(numerator ^ sign), height, &rest) ^ (int32_t)sign;
}

/* What crosses the row goes among the crossings, by x. An edge is always taken from
 * its top, so its owner does not matter. */
static void take_edge(fxl_crossings *crossings, const fxl_screen_point *top,
                      const fxl_screen_point *bottom)
{
    int16_t winding = 1;
    if (top->y > bottom->y) {
        const fxl_screen_point *other = top;
        top = bottom;
        bottom = other;
        winding = -1;
    }
    int32_t rows = crossings->row - fxl_first_centre_from(top->y);
    if (rows < 0 || fxl_first_centre_from(bottom->y) <= crossings->row) {
        return;
    }
    int32_t dx = bottom->x - top->x, height = bottom->y - top->y, start = top->x - FXL_HALF_PIXEL;
    /* Below 2^30, and dx more a row: fewer than 2^13 rows, so below 2^43. */
    int64_t dividend =
        fxl_edge_first_dividend(start, dx, height, top->y) + fxl_multiply_s32(dx, rows);
    int32_t x = (start >> 16) + 1 + divide_floor(dividend, (uint32_t)height);
    fxl_crossing_edge *place = &crossings->edges[crossings->crossing_count++];
    for (; place > crossings->edges && place[-1].x > x; place--) {
        place->x = place[-1].x;
        place->winding = place[-1].winding;
    }
    place->x = x;
    place->winding = winding;
}

void fxl_crossings_begin(fxl_crossings *crossings, const fxl_screen_point *points, uint32_t count,
                         const fxl_band *band)
{
    int16_t first, end;
    fxl_outline_rows(points, count, &first, &end);
    int32_t band_end = band->first_row + band->rows;
    crossings->points = points;
    crossings->edge_count = (uint8_t)count;
    crossings->crossing_count = 0;
    crossings->next_crossing = 0;
    crossings->width = (int16_t)band->width;
    crossings->row = (int16_t)((first < band->first_row ? band->first_row : first) - 1);
    crossings->end_row = (int16_t)(end < band_end ? end : band_end);
}

/* Begins the next row; false below the last. */
static bool next_row(fxl_crossings *crossings)
{
    const fxl_screen_point *points = crossings->points;
    const fxl_screen_point *before = &points[crossings->edge_count - 1];
    if (crossings->row + 1 >= crossings->end_row) {
        return false;
    }
    crossings->row = (int16_t)(crossings->row + 1);
    crossings->crossing_count = 0;
    crossings->next_crossing = 0;
    for (uint32_t left = crossings->edge_count; left != 0; left--) {
        take_edge(crossings, before, points);
        before = points++;
    }
    return true;
}

/* The row's next stretch of pixels with a winding number other than 0. A
 * closed outline's windings add up to 0 on every row. */
static void next_stretch(fxl_crossings *crossings, int32_t *x0, int32_t *x1)
{
    const fxl_crossing_edge *edge = &crossings->edges[crossings->next_crossing];
    int32_t winding = 0;
    *x0 = edge->x;
    do {
        *x1 = edge->x;
        winding += edge->winding;
        edge++;
        crossings->next_crossing += 1;
    } while (crossings->next_crossing < crossings->crossing_count &&
             (winding != 0 || edge->x == *x1));
    FXL_ASSERT(winding == 0);
}

bool fxl_crossings_next(fxl_crossings *crossings, fxl_span *span)
{
    do {
        while (crossings->next_crossing < crossings->crossing_count) {
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
