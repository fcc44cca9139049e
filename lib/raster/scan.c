/* SPDX-License-Identifier: MIT */
#include "../math/family.h"
#include "columns.h"
#include "draw_outline.h"
#include "edge.h"
#include "scan.h"

/* The result of one pass over the vertices of an outline. */
typedef struct {
    uint32_t top;    /* the highest vertex, or one of several */
    int32_t top_row; /* the first row whose centre is at or below it */
    int32_t end_row; /* the same of the lowest vertex: the edges cross no row from here on */
    bool by_chains;  /* whether it can be scanned between two chains: see survey */
} outline;

static fxl_status check(const fxl_screen_polygon *polygon, const fxl_band *band)
{
    if (polygon->count < 3) {
        return FXL_E_DEGENERATE;
    }
    if (polygon->count > FXL_POLYGON_CAPACITY) {
        return FXL_E_CAPACITY;
    }
    if (band->width < 1 || band->width > FXL_SCREEN_MAX || band->rows < 1 ||
        band->first_row + band->rows > FXL_SCREEN_MAX || fxl_band_end_column(band) > band->width) {
        return FXL_E_RANGE;
    }
    for (uint32_t i = 0; i < polygon->count; i++) {
        if (!fxl_within(polygon->points[i].x, FXL_SCREEN_COORDINATE_MAX) ||
            !fxl_within(polygon->points[i].y, FXL_SCREEN_COORDINATE_MAX)) {
            return FXL_E_RANGE;
        }
    }
    return FXL_OK;
}

/* place fill-rule: the winding number */
/* Looks at every vertex of an outline. The outline is scanned between two chains if
 * - the rows of its downward edges add up to its height, so it never goes down again
 *   after it went up. Then two edges cross each row between its top and its bottom, one
 *   of each chain, with opposite windings; the covered pixels lie between the two;
 * - every edge's x is within 0..width on every row. The first pixel of an edge,
 *   ceil(x - 1/2), lies between those of its ends. So it suffices that every vertex has
 *   -1/2 < x <= width + 1/2: these are the x for which x + 1/2 - 2^-16 is in
 *   0..width + 1 - 2^-16;
 * - no edge is higher than FXL_EDGE_HEIGHT_MAX. Rows that are 1022 apart have centres that
 *   are 1022 apart, and the vertices are farther apart by less than 2 pixels. */
static void survey(const fxl_screen_point *points, uint32_t count, int32_t width, outline *found)
{
    const uint32_t places = (uint32_t)(width + 1) << 16;
    int32_t top_row = INT16_MAX, end_row = INT16_MIN, down = 0;
    int32_t before = fxl_first_centre_from(points[count - 1].y);
    uint32_t farthest = 0;
    found->top = 0;
    uint32_t i = 0;
    do {
        FXL_ASSERT(fxl_within(points[i].x, FXL_SCREEN_COORDINATE_MAX) &&
                   fxl_within(points[i].y, FXL_SCREEN_COORDINATE_MAX));
        uint32_t place = fxl_bits_32(points[i].x + (FXL_HALF_PIXEL - 1));
        int32_t row = fxl_first_centre_from(points[i].y);
        farthest = place > farthest ? place : farthest;
        if (row < top_row) {
            top_row = row;
            found->top = i;
        }
        end_row = row > end_row ? row : end_row;
        if (row > before) {
            down += row - before;
        }
        before = row;
        i += 1;
    } while (i < count);
    found->top_row = top_row;
    found->end_row = end_row;
    found->by_chains = FXL_SCANS_BY_CHAINS && down == end_row - top_row && farthest < places &&
                       down < FXL_EDGE_HEIGHT_MAX >> 16;
}

static void begin_chains(fxl_scan *scan, const outline *found, const fxl_band *band)
{
    int32_t first_row = found->top_row > band->first_row ? found->top_row : band->first_row;
    int32_t end_row = band->first_row + band->rows;
    /* The outline of a front face goes clockwise. So its left chain goes from the top
     * backward through the vertices. */
    scan->chains[0].onward = (uint8_t)(scan->count - 1);
    scan->chains[1].onward = 1;
    for (int side = 0; side < 2; side++) {
        scan->chains[side].vertex = (uint8_t)found->top;
        scan->chains[side].end_row = (int16_t)first_row;
    }
    scan->trapezoid.first_row = (int16_t)first_row;
    scan->trapezoid.end_row = (int16_t)first_row;
    scan->row = (int16_t)first_row;
    scan->end_row = (int16_t)(found->end_row < end_row ? found->end_row : end_row);
}

/* Makes a scan without pixels. */
static void clear(fxl_scan *scan)
{
    scan->by_chains = false;
    scan->trapezoid.end_row = 0;
    scan->end_row = INT16_MIN;
    scan->active_edges.end_row = INT16_MIN;
    scan->active_edges.x = FXL_NO_CROSSING;
}

void fxl_scan_outline(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                      fxl_scan *scan)
{
    FXL_ASSERT(count >= 3 && count <= FXL_POLYGON_CAPACITY);
    outline found;
    survey(points, count, band->width, &found);
    scan->points = points;
    scan->count = (uint8_t)count;
    scan->by_chains = found.by_chains && band->columns == 0; /* active edges end at any column */
    scan->outline_first = (int16_t)found.top_row;
    scan->outline_end = (int16_t)found.end_row;
    if (scan->by_chains) {
        begin_chains(scan, &found, band);
    } else {
        scan->end_row = INT16_MIN;
        fxl_active_edges_begin(&scan->active_edges, points, count, found.top_row, found.end_row,
                               band);
    }
}

fxl_status fxl_scan_begin(const fxl_screen_polygon *polygon, const fxl_band *band, fxl_scan *scan)
{
    if (scan == NULL) {
        return FXL_E_ARGUMENT;
    }
    fxl_status status = polygon == NULL || band == NULL ? FXL_E_ARGUMENT : check(polygon, band);
    if (status == FXL_OK) {
        fxl_scan_outline(polygon->points, polygon->count, band, scan);
    } else {
        clear(scan);
    }
    return status;
}

static uint16_t clamp_row(int32_t row, uint16_t height)
{
    return row < 0 ? 0 : row > height ? height : (uint16_t)row;
}

/* SPEC 7.1 */
fxl_rows fxl_rows_of_points(const fxl_screen_point *points, uint32_t count, uint16_t height)
{
    fxl_q16_16 top = points[0].y, bottom = top;
    for (uint32_t i = 1; i < count; i++) {
        fxl_q16_16 y = points[i].y;
        top = y < top ? y : top;
        bottom = y > bottom ? y : bottom;
    }
    fxl_rows rows = {clamp_row(fxl_first_centre_from(top), height),
                     clamp_row(fxl_first_centre_from(bottom), height)};
    return rows;
}

fxl_rows fxl_active_edges_outline(fxl_active_edges *edges, const fxl_screen_point *points,
                                  uint32_t count, const fxl_band *band)
{
    const fxl_rows rows =
        fxl_rows_of_points(points, count, (uint16_t)(band->first_row + band->rows));
    fxl_active_edges_begin(edges, points, count, rows.first, rows.end, band);
    return rows;
}

fxl_rows fxl_scan_rows(const fxl_screen_polygon *polygon, uint16_t height)
{
    return fxl_rows_of_points(polygon->points, polygon->count, height);
}

bool fxl_outline_has_rows(const fxl_screen_polygon *polygon, uint16_t height)
{
    const fxl_rows rows = fxl_scan_rows(polygon, height);
    return rows.first != rows.end;
}

const fxl_trapezoid *fxl_scan_next_of_active_edges(fxl_scan *scan)
{
    fxl_span span;
    if (!fxl_active_edges_next(&scan->active_edges, &span)) {
        return NULL;
    }
    scan->trapezoid.first_row = span.y;
    scan->trapezoid.end_row = (int16_t)(span.y + 1);
    const fxl_edge left = {span.x0, 0, 0, 0}, right = {span.x1, 0, 0, 0};
    scan->trapezoid.edges[0] = left;
    scan->trapezoid.edges[1] = right;
    return &scan->trapezoid;
}

/* Finds the next row that is not empty. Rows are removed from the trapezoid's top, so the
 * trapezoid always is the part that is still to come. */
static bool next_row_of_chains(fxl_scan *scan, fxl_span *span)
{
    fxl_trapezoid *trapezoid = &scan->trapezoid;
    for (;;) {
        if (scan->row < trapezoid->end_row) {
            fxl_edge_advance(&trapezoid->edges[0], 1);
            fxl_edge_advance(&trapezoid->edges[1], 1);
            trapezoid->first_row = scan->row;
        } else if (fxl_scan_next_trapezoid(scan) == NULL) {
            return false;
        }
        scan->row = (int16_t)(trapezoid->first_row + 1);
        int32_t a = trapezoid->edges[0].x, b = trapezoid->edges[1].x;
        if (a != b) {
            span->y = trapezoid->first_row;
            span->x0 = (int16_t)(a < b ? a : b);
            span->x1 = (int16_t)(a < b ? b : a);
            return true;
        }
    }
}

bool fxl_scan_next(fxl_scan *scan, fxl_span *span)
{
    return FXL_SCANS_BY_CHAINS && scan->by_chains
               ? next_row_of_chains(scan, span)
               : fxl_active_edges_next(&scan->active_edges, span);
}

/* --- between two chains ------------------------------------------------------------------------ */

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

#if FXL_KERNELS_ARMV6M

void fxl_scan_begin_any_edge(const fxl_scan *scan, fxl_chain *chain, int32_t row, fxl_edge *edge)
{
    begin_edge(scan, chain, row, edge);
}

#define BEGIN_EDGE fxl_scan_begin_edge
#else
#define BEGIN_EDGE begin_edge
#endif

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
            (void)BEGIN_EDGE(scan, chain, row, &trapezoid->edges[side]);
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
