/* SPDX-License-Identifier: MIT */
#include "fixel/scan.h"

#include "arith.h"

#define HALF_PIXEL 32768

/* The first row (or column) whose centre is at or past a coordinate. */
static int32_t first_centre_from(int64_t coordinate)
{
    return (int32_t)((coordinate - HALF_PIXEL + 65535) >> 16);
}

/* The edge's first pixel on the row `row`, whose centre is less than a pixel
 * below the top.
 *
 * The edge's x there is top.x + dx t / height, t the distance of the row's
 * centre from the top, and the first pixel is ceil(x - 1/2). With
 * top.x - 1/2 = 65536 whole + part (0 <= part < 65536) that is
 *   whole + ceil((part height + dx t) / (65536 height)),
 * and ceil(n / m) = floor((n - 1) / m) + 1, and a floor of a floor is the floor
 * of the whole quotient. height, |dx| < 2^29 and part, t < 2^16, so the sum is
 * below 2^46 and, without its low 16 bits, below 2^30. Exact. */
static void place_on_first_row(fxl_edge *edge, const fxl_screen_point *top, int32_t dx)
{
    int32_t start = top->x - HALF_PIXEL;
    int32_t whole = start >> 16;
    int32_t part = start & 65535;
    int32_t t = edge->row * 65536 + HALF_PIXEL - top->y;
    FXL_ASSERT(t >= 0 && t < 65536);
    int64_t sum = (int64_t)part * edge->height + (int64_t)dx * t;
    int32_t quotient = fxl_divide_floor((int32_t)((sum - 1) >> 16), edge->height, &edge->error);
    edge->x = whole + quotient + 1;
}

/* Walks an edge down by 0 < rows < 2^13 rows at once: the carries that single
 * steps would have made are floor((error + rows error_step) / height), found
 * by long division, as they are fewer than 2^13. The sum is below 2^43. */
static void skip_rows(fxl_edge *edge, int32_t rows)
{
    FXL_ASSERT(rows > 0 && rows < 8192);
    int64_t error = edge->error + (int64_t)rows * edge->error_step;
    int32_t carries = 0;
    for (int32_t bit = 4096; bit != 0; bit >>= 1) {
        int64_t part = (int64_t)edge->height * bit;
        if (error >= part) {
            error -= part;
            carries += bit;
        }
    }
    edge->x += rows * edge->step + carries;
    edge->error = (int32_t)error;
    edge->row = (int16_t)(edge->row + rows);
}

static void step_row(fxl_edge *edge)
{
    edge->x += edge->step;
    edge->error += edge->error_step;
    if (edge->error >= edge->height) {
        edge->error -= edge->height;
        edge->x += 1;
    }
    edge->row = (int16_t)(edge->row + 1);
}

/* Sets up the edge from a to b; false where it crosses no row of the band. The
 * edge is always walked from its top, so its owner does not matter. */
static bool set_up_edge(const fxl_screen_point *a, const fxl_screen_point *b, const fxl_band *band,
                        fxl_edge *edge)
{
    const fxl_screen_point *top = a->y < b->y ? a : b;
    const fxl_screen_point *bottom = top == a ? b : a;
    int32_t band_end = band->first_row + band->rows;
    int32_t first_row = first_centre_from(top->y);
    int32_t end_row = first_centre_from(bottom->y);
    if (first_row >= end_row || end_row <= band->first_row || first_row >= band_end) {
        return false;
    }
    int32_t dx = bottom->x - top->x;
    edge->height = bottom->y - top->y;
    edge->row = (int16_t)first_row;
    edge->end_row = (int16_t)(end_row < band_end ? end_row : band_end);
    edge->winding = top == a ? 1 : -1;
    edge->step = fxl_divide_floor(dx, edge->height, &edge->error_step);
    place_on_first_row(edge, top, dx);
    if (first_row < band->first_row) {
        skip_rows(edge, band->first_row - first_row);
    }
    return true;
}

/* Keeps the edges in the order of their first rows. */
static void insert_edge(fxl_scan *scan, const fxl_edge *edge)
{
    uint32_t place = scan->edge_count;
    while (place > 0 && scan->edges[place - 1].row > edge->row) {
        scan->edges[place] = scan->edges[place - 1];
        place -= 1;
    }
    scan->edges[place] = *edge;
    scan->edge_count += 1;
}

static fxl_status check(const fxl_screen_polygon *polygon, const fxl_band *band)
{
    if (polygon->count < 3) {
        return FXL_E_DEGENERATE;
    }
    if (polygon->count > FXL_POLYGON_CAPACITY) {
        return FXL_E_CAPACITY;
    }
    if (band->width < 1 || band->width > FXL_SCREEN_MAX || band->rows < 1 ||
        band->first_row + band->rows > FXL_SCREEN_MAX) {
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

/* No edges: no spans. */
static void clear(fxl_scan *scan)
{
    scan->edge_count = 0;
    scan->next_edge = 0;
    scan->crossing_count = 0;
    scan->next_crossing = 0;
}

void fxl_scan_outline(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                      fxl_scan *scan)
{
    FXL_ASSERT(count >= 3 && count <= FXL_POLYGON_CAPACITY);
    clear(scan);
    scan->width = (int16_t)band->width;
    for (uint32_t i = 0; i < count; i++) {
        uint32_t next = i + 1 == count ? 0 : i + 1;
        fxl_edge edge;
        FXL_ASSERT(fxl_within(points[i].x, FXL_SCREEN_COORDINATE_MAX) &&
                   fxl_within(points[i].y, FXL_SCREEN_COORDINATE_MAX));
        if (set_up_edge(&points[i], &points[next], band, &edge)) {
            insert_edge(scan, &edge);
        }
    }
    scan->row = scan->edge_count > 0 ? (int16_t)(scan->edges[0].row - 1) : 0;
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

static uint16_t row_held(int32_t row, uint16_t height)
{
    return row < 0 ? 0 : row > height ? height : (uint16_t)row;
}

fxl_rows fxl_scan_rows(const fxl_screen_polygon *polygon, uint16_t height)
{
    fxl_q16_16 top = polygon->points[0].y, bottom = top;
    for (uint32_t i = 1; i < polygon->count; i++) {
        fxl_q16_16 y = polygon->points[i].y;
        top = y < top ? y : top;
        bottom = y > bottom ? y : bottom;
    }
    fxl_rows rows = {row_held(first_centre_from(top), height),
                     row_held(first_centre_from(bottom), height)};
    return rows;
}

/* Walks the crossing edges down to the row, leaves out those that have ended,
 * and takes in those that begin. */
static void gather_crossings(fxl_scan *scan)
{
    uint32_t kept = 0;
    for (uint32_t i = 0; i < scan->crossing_count; i++) {
        fxl_edge *edge = &scan->edges[scan->crossings[i]];
        if (edge->end_row > scan->row) {
            step_row(edge);
            scan->crossings[kept++] = scan->crossings[i];
        }
    }
    while (scan->next_edge < scan->edge_count && scan->edges[scan->next_edge].row == scan->row) {
        scan->crossings[kept++] = scan->next_edge++;
    }
    scan->crossing_count = (uint8_t)kept;
    scan->next_crossing = 0;
}

/* Insertion sort: from row to row the order hardly changes. */
static void sort_crossings(fxl_scan *scan)
{
    for (uint32_t i = 1; i < scan->crossing_count; i++) {
        uint8_t moved = scan->crossings[i];
        int32_t x = scan->edges[moved].x;
        uint32_t place = i;
        while (place > 0 && scan->edges[scan->crossings[place - 1]].x > x) {
            scan->crossings[place] = scan->crossings[place - 1];
            place -= 1;
        }
        scan->crossings[place] = moved;
    }
}

/* Begins the next row that an edge crosses; false below the last. */
static bool next_row(fxl_scan *scan)
{
    if (scan->edge_count == 0) {
        return false;
    }
    scan->row = (int16_t)(scan->row + 1);
    gather_crossings(scan);
    if (scan->crossing_count == 0) {
        if (scan->next_edge == scan->edge_count) {
            scan->edge_count = 0;
            return false;
        }
        scan->row = scan->edges[scan->next_edge].row;
        gather_crossings(scan);
    }
    sort_crossings(scan);
    return true;
}

/* The sum of the windings of all crossings at the place of the next one. */
static int32_t take_winding(fxl_scan *scan, int32_t winding, int32_t *x)
{
    *x = scan->edges[scan->crossings[scan->next_crossing]].x;
    while (scan->next_crossing < scan->crossing_count) {
        const fxl_edge *edge = &scan->edges[scan->crossings[scan->next_crossing]];
        if (edge->x != *x) {
            break;
        }
        winding += edge->winding;
        scan->next_crossing += 1;
    }
    return winding;
}

/* The row's next stretch of pixels with a winding number other than 0. A
 * closed outline's windings add up to 0 on every row. */
static bool next_stretch(fxl_scan *scan, int32_t *x0, int32_t *x1)
{
    while (scan->next_crossing < scan->crossing_count) {
        int32_t winding = take_winding(scan, 0, x0);
        if (winding == 0) {
            continue;
        }
        while (winding != 0) {
            FXL_ASSERT(scan->next_crossing < scan->crossing_count);
            winding = take_winding(scan, winding, x1);
        }
        return true;
    }
    return false;
}

bool fxl_scan_next(fxl_scan *scan, fxl_span *span)
{
    do {
        int32_t x0, x1;
        while (next_stretch(scan, &x0, &x1)) {
            x0 = x0 < 0 ? 0 : x0;
            x1 = x1 > scan->width ? scan->width : x1;
            if (x0 < x1) {
                span->y = scan->row;
                span->x0 = (int16_t)x0;
                span->x1 = (int16_t)x1;
                return true;
            }
        }
    } while (next_row(scan));
    return false;
}
