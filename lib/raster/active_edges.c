/* SPDX-License-Identifier: MIT */
/* On a row where an edge begins or ends, the edges that cross the row are found and divided. On the
 * rows from there to the next such row they are the same edges, and each takes a step. */
#include "scan.h"

#include "../math/memory.h"
#include "columns.h"
#include "edge.h"

/* place fill-rule: the winding number */
/* Finds the edges that cross the row, and the first crossing. An edge is always divided from its
 * top, so both polygons of an edge get the same bits. */
static void find_edges(fxl_active_edges *edges)
{
    const fxl_screen_point *from = &edges->points[edges->count - 1], *to = edges->points;
    const fxl_q16_16 centre = fxl_centre_of(edges->row);
    fxl_active_edge *found = edges->found;
    edges->found_count = 0;
    for (uint32_t left = edges->count; left != 0; left--) {
        const bool down = from->y <= centre;
        /* The signs differ if one end is below the row's centre. */
        if (((centre - from->y) ^ (centre - to->y)) < 0) {
            const fxl_screen_point *top = down ? from : to, *bottom = down ? to : from;
            fxl_slope_set(top, bottom, centre, &found->slope);
            found->winding = down ? 1 : -1;
            edges->x = found->slope.x < edges->x ? found->slope.x : edges->x;
            edges->found_count++;
            found++;
        }
        from = to++;
    }
}

/* The next row on which an edge begins or ends. */
static int32_t next_vertex_row(const fxl_active_edges *edges)
{
    int32_t next = edges->end_row;
    for (uint32_t i = 0; i < edges->count; i++) {
        int32_t row = fxl_first_centre_from(edges->points[i].y);
        if (row > edges->row && row < next) {
            next = row;
        }
    }
    return next;
}

/* Moves an edge down by a row. Returns its x there. */
/* SPEC 5.3 */
static int32_t step(fxl_slope *slope)
    FXL_REQUIRES(FXL_OBJECT(slope) && FXL_SLOPE(slope) && FXL_BELOW(slope->x, 1 << 30))
    FXL_ASSIGNS(slope->x, slope->error) FXL_ENSURES(slope->error < slope->height)
{
    int32_t x = slope->x + slope->step;
    uint32_t error = slope->error + slope->error_step;
    if (error >= slope->height) {
        error -= slope->height;
        x += 1;
    }
    slope->x = x;
    slope->error = error;
    return x;
}

/* Moves the active edges down by a row, and finds the first crossing. */
static void step_edges(fxl_active_edges *edges)
{
    int32_t first = edges->x;
    fxl_active_edge *edge = edges->found;
    uint32_t left = edges->found_count;
    do { /* edges cross every row of an outline */
        const int32_t x = step(&edge->slope);
        first = x < first ? x : first;
        edge++;
    } while (--left != 0);
    edges->x = first;
}

void fxl_active_edges_begin(fxl_active_edges *edges, const fxl_screen_point *points, uint32_t count,
                            int32_t first_row, int32_t end_row, const fxl_band *band)
{
    int32_t band_end = band->first_row + band->rows;
    edges->points = points;
    edges->count = (uint8_t)count;
    edges->x = FXL_NO_CROSSING;
    edges->left = (int16_t)band->first_column;
    edges->right = (int16_t)fxl_band_end_column(band);
    edges->steady_end = INT16_MIN;
    edges->row = (int16_t)((first_row < band->first_row ? band->first_row : first_row) - 1);
    edges->end_row = (int16_t)(end_row < band_end ? end_row : band_end);
}

/* Goes to the next row. Returns false if there is none. */
static bool next_row(fxl_active_edges *edges)
{
    if (edges->row + 1 >= edges->end_row) {
        return false; /* an empty scan has no points */
    }
    edges->row = (int16_t)(edges->row + 1);
    if (edges->row < edges->steady_end) {
        step_edges(edges);
    } else {
        find_edges(edges);
        edges->steady_end = (int16_t)next_vertex_row(edges);
    }
    return true;
}

/* The winding number to the right of x, on a row that edges cross. *next becomes the place of the
 * next crossing. There are nearly always two crossings, so they are not sorted. */
/* SPEC 5.1 */
static int32_t winding_after(const fxl_active_edges *edges, int32_t x, int32_t *next)
{
    int32_t winding = 0;
    *next = FXL_NO_CROSSING;
    const fxl_active_edge *edge = edges->found;
    uint32_t left = edges->found_count;
    do {
        if (edge->slope.x <= x) {
            winding += edge->winding;
        } else if (edge->slope.x < *next) {
            *next = edge->slope.x;
        }
        edge++;
    } while (--left != 0);
    return winding;
}

/* The end of the stretch that begins at edges->x, where two edges cross the row: their windings are
 * opposite, so it is all that the row has. */
static int32_t end_of_two(fxl_active_edges *edges)
{
    const int32_t end = edges->found[0].slope.x + edges->found[1].slope.x - edges->x;
    edges->x = FXL_NO_CROSSING;
    return end;
}

/* The end of the stretch that begins at edges->x, which becomes the place of the next. */
/* SPEC 5.1 */
static int32_t end_of_stretch(fxl_active_edges *edges)
{
    int32_t end = edges->x, next;
    while (winding_after(edges, end, &next) != 0) {
        FXL_ASSERT(next != FXL_NO_CROSSING);
        end = next;
    }
    edges->x = next;
    return end;
}

/* Until a row's end, edges->x is where the next stretch may begin. A stretch of pixels with a
 * winding number other than 0 begins and ends at a crossing. The windings of a closed outline add
 * up to 0 on every row. */
bool fxl_active_edges_next(fxl_active_edges *edges, fxl_span *span)
{
    while (edges->x != FXL_NO_CROSSING || next_row(edges)) {
        int32_t x0 = edges->x;
        int32_t x1 = edges->found_count == 2 ? end_of_two(edges) : end_of_stretch(edges);
        x0 = x0 < edges->left ? edges->left : x0;
        x1 = x1 > edges->right ? edges->right : x1;
        if (x0 < x1) {
            span->y = edges->row;
            span->x0 = (int16_t)x0;
            span->x1 = (int16_t)x1;
            return true;
        }
    }
    return false;
}

void fxl_active_edges_fill(fxl_active_edges *edges, const fxl_span *span, const fxl_band *band,
                           uint8_t colour)
{
    uint8_t *row = band->pixels + (size_t)(span->y - band->first_row) * band->stride;
    int32_t x0 = span->x0, x1 = span->x1;
    int32_t below = edges->found_count == 2 ? edges->steady_end - 1 - span->y : 0;
    edges->row = (int16_t)(edges->row + below);
    for (;; below--) {
        if (x0 < x1) {
            memset(row + x0, colour, (size_t)(x1 - x0));
        }
        if (below == 0) {
            return;
        }
        row += band->stride;
        const int32_t a = step(&edges->found[0].slope), b = step(&edges->found[1].slope);
        x0 = a < b ? a : b;
        x1 = a < b ? b : a;
        x0 = x0 < edges->left ? edges->left : x0;
        x1 = x1 > edges->right ? edges->right : x1;
    }
}
