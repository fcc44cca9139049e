/* SPDX-License-Identifier: MIT */
#include "scan_crossings.h"

#include "edge.h"

static void step_row(fxl_crossing_edge *edge)
{
    edge->x += edge->step;
    edge->error += edge->error_step;
    if (edge->error >= edge->height) {
        edge->error -= edge->height;
        edge->x += 1; /* bug: edge-no-carry */
    }
    edge->row = (int16_t)(edge->row + 1);
}

/* Sets up the edge from a to b; false where it crosses no row of the band. The
 * edge is always walked from its top, so its owner does not matter. */
static bool set_up_edge(const fxl_screen_point *a, const fxl_screen_point *b, const fxl_band *band,
                        fxl_crossing_edge *edge)
{
    const fxl_screen_point *top = a->y < b->y ? a : b;
    const fxl_screen_point *bottom = top == a ? b : a;
    int32_t band_end = band->first_row + band->rows;
    int32_t first_row = fxl_first_centre_from(top->y);
    int32_t end_row = fxl_first_centre_from(bottom->y);
    if (first_row >= end_row || end_row <= band->first_row || first_row >= band_end) {
        return false;
    }
    fxl_slope slope;
    fxl_slope_set(top, bottom, &slope);
    if (first_row < band->first_row) {
        fxl_slope_skip(&slope, band->first_row - first_row);
        first_row = band->first_row;
    }
    edge->x = slope.x;
    edge->step = slope.step;
    edge->error = (int32_t)slope.error;
    edge->error_step = (int32_t)slope.error_step;
    edge->height = (int32_t)slope.height;
    edge->row = (int16_t)first_row;
    edge->end_row = (int16_t)(end_row < band_end ? end_row : band_end);
    edge->winding = top == a ? 1 : -1;
    return true;
}

/* Keeps the edges in the order of their first rows. */
static void insert_edge(fxl_crossings *crossings, const fxl_crossing_edge *edge)
{
    uint32_t place = crossings->edge_count;
    while (place > 0 && crossings->edges[place - 1].row > edge->row) {
        crossings->edges[place] = crossings->edges[place - 1];
        place -= 1;
    }
    crossings->edges[place] = *edge;
    crossings->edge_count += 1;
}

void fxl_crossings_begin(fxl_crossings *crossings, const fxl_screen_point *points, uint32_t count,
                         const fxl_band *band)
{
    crossings->edge_count = 0;
    crossings->next_edge = 0;
    crossings->crossing_count = 0;
    crossings->next_crossing = 0;
    crossings->width = (int16_t)band->width;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t next = i + 1 == count ? 0 : i + 1;
        fxl_crossing_edge edge;
        if (set_up_edge(&points[i], &points[next], band, &edge)) {
            insert_edge(crossings, &edge);
        }
    }
    crossings->row = crossings->edge_count > 0 ? (int16_t)(crossings->edges[0].row - 1) : 0;
}

/* Walks the crossing edges down to the row, leaves out those that have ended,
 * and takes in those that begin. */
static void gather_crossings(fxl_crossings *crossings)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < crossings->crossing_count; i++) {
        fxl_crossing_edge *edge = &crossings->edges[crossings->crossings[i]];
        if (edge->end_row > crossings->row) {
            step_row(edge);
            crossings->crossings[kept++] = crossings->crossings[i];
        }
    }
    while (crossings->next_edge < crossings->edge_count &&
           crossings->edges[crossings->next_edge].row == crossings->row) {
        crossings->crossings[kept++] = crossings->next_edge++;
    }
    crossings->crossing_count = (uint8_t)kept;
    crossings->next_crossing = 0;
}

/* Insertion sort: from row to row the order hardly changes. */
static void sort_crossings(fxl_crossings *crossings)
{
    for (uint32_t i = 1; i < crossings->crossing_count; i++) {
        uint8_t moved = crossings->crossings[i];
        int32_t x = crossings->edges[moved].x;
        uint32_t place = i;
        while (place > 0 && crossings->edges[crossings->crossings[place - 1]].x > x) {
            crossings->crossings[place] = crossings->crossings[place - 1];
            place -= 1;
        }
        crossings->crossings[place] = moved;
    }
}

/* Begins the next row that an edge crosses; false below the last. */
static bool next_row(fxl_crossings *crossings)
{
    if (crossings->edge_count == 0) {
        return false;
    }
    crossings->row = (int16_t)(crossings->row + 1);
    gather_crossings(crossings);
    if (crossings->crossing_count == 0) {
        if (crossings->next_edge == crossings->edge_count) {
            crossings->edge_count = 0;
            return false;
        }
        crossings->row = crossings->edges[crossings->next_edge].row;
        gather_crossings(crossings);
    }
    sort_crossings(crossings);
    return true;
}

/* The sum of the windings of all crossings at the place of the next one. */
static int32_t take_winding(fxl_crossings *crossings, int32_t winding, int32_t *x)
{
    *x = crossings->edges[crossings->crossings[crossings->next_crossing]].x;
    while (crossings->next_crossing < crossings->crossing_count) {
        const fxl_crossing_edge *edge =
            &crossings->edges[crossings->crossings[crossings->next_crossing]];
        if (edge->x != *x) {
            break;
        }
        winding += edge->winding;
        crossings->next_crossing += 1;
    }
    return winding;
}

/* The row's next stretch of pixels with a winding number other than 0. A
 * closed outline's windings add up to 0 on every row. */
static bool next_stretch(fxl_crossings *crossings, int32_t *x0, int32_t *x1)
{
    while (crossings->next_crossing < crossings->crossing_count) {
        int32_t winding = take_winding(crossings, 0, x0);
        if (winding == 0) {
            continue;
        }
        while (winding != 0) { /* bug: even-odd */
            FXL_ASSERT(crossings->next_crossing < crossings->crossing_count);
            winding = take_winding(crossings, winding, x1);
        }
        return true;
    }
    return false;
}

bool fxl_crossings_next(fxl_crossings *crossings, fxl_span *span)
{
    do {
        int32_t x0, x1;
        while (next_stretch(crossings, &x0, &x1)) {
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
