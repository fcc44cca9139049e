/* SPDX-License-Identifier: MIT */
/* Every edge is looked at on every row: short, and no slower for the few edges
 * that a polygon has. */
#include "scan_crossings.h"

#include "edge.h"

/* floor(numerator / height) and what is left, the quotient below 2^31. */
static int32_t divide_floor(int64_t numerator, uint32_t height, int32_t *rest)
{
    uint32_t left;
    /* Downward, that of -1 - n is -1 less that of n. */
    int64_t sign = numerator >> 63;
    int32_t quotient = (int32_t)fxl_divide_u64((uint64_t)(numerator ^ sign), height, &left);
    *rest = (int32_t)(sign == 0 ? left : height - 1u - left);
    return quotient ^ (int32_t)sign;
}

/* Sets up the edge from a to b; false where it crosses no row of the band. The
 * edge is always walked from its top, so its owner does not matter. */
static bool set_up_edge(const fxl_screen_point *a, const fxl_screen_point *b, const fxl_band *band,
                        fxl_crossing_edge *edge)
{
    edge->winding = 1;
    if (a->y >= b->y) {
        const fxl_screen_point *upper = b;
        b = a;
        a = upper;
        edge->winding = -1;
    }
    int32_t band_end = band->first_row + band->rows;
    int32_t top_row = fxl_first_centre_from(a->y), row = top_row;
    int32_t end_row = fxl_first_centre_from(b->y);
    row = row < band->first_row ? band->first_row : row;
    end_row = end_row < band_end ? end_row : band_end;
    if (row >= end_row) {
        return false;
    }
    int32_t dx = b->x - a->x, height = b->y - a->y, start = a->x - FXL_HALF_PIXEL;
    /* Below 2^30, and dx more a row: 2^13 rows, so below 2^43. */
    int64_t first =
        fxl_edge_first_dividend(start, dx, height, a->y) + fxl_multiply_s32(dx, row - top_row);
    edge->row = (int16_t)row;
    edge->end_row = (int16_t)end_row;
    edge->height = height;
    edge->x = (start >> 16) + 1 + divide_floor(first, (uint32_t)height, &edge->error);
    edge->step = divide_floor(dx, (uint32_t)height, &edge->error_step);
    return true;
}

void fxl_crossings_begin(fxl_crossings *crossings, const fxl_screen_point *points, uint32_t count,
                         const fxl_band *band)
{
    const fxl_screen_point *before = &points[count - 1];
    crossings->edge_count = 0;
    crossings->crossing_count = 0;
    crossings->next_crossing = 0;
    crossings->width = (int16_t)band->width;
    crossings->row = INT16_MAX;
    for (; count != 0; count--) {
        fxl_crossing_edge *edge = &crossings->edges[crossings->edge_count];
        if (set_up_edge(before, points, band, edge)) {
            crossings->edge_count += 1;
            crossings->row = edge->row < crossings->row ? edge->row : crossings->row;
        }
        before = points++;
    }
}

/* Down by one row. */
static void step_row(fxl_crossing_edge *edge)
{
    edge->x += edge->step;
    edge->error += edge->error_step;
    if (edge->error >= edge->height) {
        edge->error -= edge->height;
        edge->x += 1;
    }
    edge->row = (int16_t)(edge->row + 1);
}

static fxl_crossing_edge *crossing(fxl_crossings *crossings, uint32_t which)
{
    return &crossings->edges[crossings->crossings[which]];
}

/* Takes the edges that cross the row, by x, and walks on to the next; false
 * below the last. A row that no edge crosses has no crossings. */
static bool next_row(fxl_crossings *crossings)
{
    bool more = false;
    uint32_t count = 0;
    for (uint32_t i = 0; i < crossings->edge_count; i++) {
        fxl_crossing_edge *edge = &crossings->edges[i];
        if (edge->row < crossings->row && crossings->row < edge->end_row) {
            step_row(edge);
        }
        more |= edge->end_row > crossings->row;
        if (edge->row == crossings->row) {
            uint32_t place = count++;
            for (; place > 0 && crossing(crossings, place - 1)->x > edge->x; place--) {
                crossings->crossings[place] = crossings->crossings[place - 1];
            }
            crossings->crossings[place] = (uint8_t)i;
        }
    }
    crossings->crossing_count = (uint8_t)count;
    crossings->next_crossing = 0;
    crossings->row = (int16_t)(crossings->row + 1);
    return more;
}

/* The row's next stretch of pixels with a winding number other than 0. A
 * closed outline's windings add up to 0 on every row. */
static void next_stretch(fxl_crossings *crossings, int32_t *x0, int32_t *x1)
{
    int32_t winding = 0;
    uint32_t next = crossings->next_crossing;
    *x0 = crossing(crossings, next)->x;
    do {
        const fxl_crossing_edge *edge = crossing(crossings, next);
        *x1 = edge->x;
        winding += edge->winding;
        next += 1;
    } while (next < crossings->crossing_count &&
             (winding != 0 || crossing(crossings, next)->x == *x1));
    FXL_ASSERT(winding == 0);
    crossings->next_crossing = (uint8_t)next;
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
                span->y = (int16_t)(crossings->row - 1);
                span->x0 = (int16_t)x0;
                span->x1 = (int16_t)x1;
                return true;
            }
        }
    } while (next_row(crossings));
    return false;
}
