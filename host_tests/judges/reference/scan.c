/* SPDX-License-Identifier: MIT */
#include "reference/scan.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* Tells whether the edge from upper to lower (upper.y <= cy < lower.y) has its x at cy <= cx.
 * Computed from the upper end, whatever the direction of the edge, so two neighbours get the
 * same result.
 *
 * With integers of 16.16 the differences are exact and below 2^29 units, the products below
 * 2^58: exact in the 64 bits of a long double. In double each product errs by at most 2^-53 of
 * itself. The cheap result is used where the sum is well clear of that. */
static bool edge_is_left(const ref_screen_point *upper, const ref_screen_point *lower, double cx,
                         double cy)
{
    double down = (cx - upper->x) * (lower->y - upper->y);
    double across = (lower->x - upper->x) * (cy - upper->y);
    if (fabs(down - across) > (fabs(down) + fabs(across)) * 0x1p-50) {
        return across <= down;
    }
    long double exact_down = ((long double)cx - upper->x) * ((long double)lower->y - upper->y);
    long double exact_across = ((long double)lower->x - upper->x) * ((long double)cy - upper->y);
    return exact_across <= exact_down;
}

/* place fill-rule: definition: the reference */
bool ref_scan_covers(const ref_screen_polygon *polygon, double cx, double cy)
{
    int winding = 0;
    for (int i = 0; i < polygon->count; i++) {
        const ref_screen_point *a = &polygon->points[i];
        const ref_screen_point *b = &polygon->points[i + 1 < polygon->count ? i + 1 : 0];
        if (a->y <= cy && cy < b->y) {
            winding += edge_is_left(a, b, cx, cy);
        } else if (b->y <= cy && cy < a->y) {
            winding -= edge_is_left(b, a, cx, cy);
        }
    }
    return winding != 0;
}

/* Row by row, as SPEC.md defines it. */
ref_rows ref_scan_rows(const ref_screen_polygon *polygon, int height)
{
    double top = INFINITY, bottom = -INFINITY;
    for (int i = 0; i < polygon->count; i++) {
        top = fmin(top, polygon->points[i].y);
        bottom = fmax(bottom, polygon->points[i].y);
    }
    ref_rows rows = {0, 0};
    while (rows.first < height && rows.first + 0.5 < top) {
        rows.first++;
    }
    rows.end = rows.first;
    while (rows.end < height && rows.end + 0.5 < bottom) {
        rows.end++;
    }
    return rows;
}

static int clamp(double value, int low, int high)
{
    return (int)fmax(low, fmin(high, value));
}

void ref_scan_begin(const ref_screen_polygon *polygon, const ref_band *band, ref_scan *scan)
{
    double left = INFINITY, right = -INFINITY, top = INFINITY, bottom = -INFINITY;
    for (int i = 0; i < polygon->count; i++) {
        left = fmin(left, polygon->points[i].x);
        right = fmax(right, polygon->points[i].x);
        top = fmin(top, polygon->points[i].y);
        bottom = fmax(bottom, polygon->points[i].y);
    }
    int first = band->first_row, end = band->first_row + band->rows;
    *scan = (ref_scan){.polygon = polygon,
                       .x0 = clamp(floor(left) - 1, 0, band->width),
                       .x1 = clamp(ceil(right) + 1, 0, band->width),
                       .y = clamp(floor(top) - 1, first, end),
                       .y1 = clamp(ceil(bottom) + 1, first, end)};
    scan->x = scan->x0;
}

bool ref_scan_next(ref_scan *scan, ref_span *span)
{
    for (; scan->y < scan->y1; scan->y++, scan->x = scan->x0) {
        while (scan->x < scan->x1) {
            int start = scan->x;
            while (scan->x < scan->x1 &&
                   ref_scan_covers(scan->polygon, scan->x + 0.5, scan->y + 0.5)) {
                scan->x++;
            }
            if (scan->x > start) {
                *span = (ref_span){scan->y, start, scan->x};
                return true;
            }
            scan->x++;
        }
    }
    return false;
}

static ptrdiff_t place_of(const ref_band *band, int x, int y)
{
    return (ptrdiff_t)(y - band->first_row) * band->stride + x;
}

uint16_t ref_pixel(const ref_band *band, int x, int y)
{
    const ptrdiff_t place = place_of(band, x, y);
    return band->pixels ? band->pixels[place] : band->pixels_16[place];
}

void ref_fill_span(const ref_band *band, const ref_span *span, uint16_t colour)
{
    for (int x = span->x0; x < span->x1; x++) {
        const ptrdiff_t place = place_of(band, x, span->y);
        if (band->pixels) {
            band->pixels[place] = (uint8_t)colour;
        } else {
            band->pixels_16[place] = colour;
        }
    }
}

void ref_fill_band(const ref_band *band, uint16_t colour)
{
    for (int y = 0; y < band->rows; y++) {
        ref_span whole = {band->first_row + y, 0, band->width};
        ref_fill_span(band, &whole, colour);
    }
}

void ref_span_buffer_begin(ref_span_buffer *cover, bool *covered, const ref_band *band)
{
    *cover = (ref_span_buffer){covered, band->width, band->first_row, band->rows};
    memset(covered, 0, (size_t)band->width * (size_t)band->rows * sizeof *covered);
}

static bool *row_of(const ref_span_buffer *cover, int y)
{
    return cover->covered + (ptrdiff_t)(y - cover->first_row) * cover->width;
}

static long runs_of(const bool *row, int width)
{
    long runs = 0;
    for (int x = 0; x < width; x++) {
        runs += row[x] && (x == 0 || !row[x - 1]);
    }
    return runs;
}

long ref_span_buffer_intervals(const ref_span_buffer *cover)
{
    long runs = 0;
    for (int y = 0; y < cover->rows; y++) {
        runs += runs_of(row_of(cover, cover->first_row + y), cover->width);
    }
    return runs;
}

bool ref_span_buffer_draw(ref_span_buffer *cover, const ref_span *span, uint8_t colour,
                          const ref_band *band, long runs)
{
    bool *row = row_of(cover, span->y), with[REF_SCREEN_MAX];
    memcpy(with, row, (size_t)cover->width * sizeof *row);
    for (int x = span->x0; x < span->x1; x++) {
        with[x] = true;
    }
    if (ref_span_buffer_intervals(cover) - runs_of(row, cover->width) +
            runs_of(with, cover->width) >
        runs) {
        return false;
    }
    uint8_t *pixels = band->pixels + (ptrdiff_t)(span->y - band->first_row) * band->stride;
    for (int x = span->x0; x < span->x1; x++) {
        if (!row[x]) {
            pixels[x] = colour;
        }
        row[x] = true;
    }
    return true;
}
