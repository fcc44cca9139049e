/* SPDX-License-Identifier: MIT */
/* The rows of a polygon that has a surface. What paints a row is given by the caller, and is
 * inlined. Internal. */
#ifndef FXL_PAINT_POLYGON_H
#define FXL_PAINT_POLYGON_H

#include "../raster/fill.h"
#include "../raster/scan.h"
#include "depth_rows.h"
#include "plain_rows.h"

/* Paints some of the pixels x0 <= x < x1 of a row; with: the painter's own. */
typedef void fxl_row_painter(void *with, const fxl_paint *paint, const fxl_paint_row *row,
                             int32_t x0, int32_t x1);

static inline int64_t value_down(const fxl_gradient *gradient, int32_t y)
{
    return gradient->at + fxl_multiply_s64_u16(gradient->down, (uint32_t)y);
}

/* The row's gradients, y rows down: 0 <= y < 2^16. */
FXL_APART void fxl_begin_row(const fxl_gradients *gradients, int32_t y, fxl_paint_row *row)
{
    row->y = y;
    row->weight = value_down(&gradients->weight, y);
    for (uint32_t i = 0; i < gradients->count; i++) {
        row->attributes[i] = value_down(&gradients->attributes[i], y);
    }
}

/* The row below the last one may be beyond what is bounded: then a sum wraps. */
static inline void fxl_add_down(int64_t *value, int64_t down)
{
    *value = (int64_t)((uint64_t)*value + (uint64_t)down);
}

static inline void fxl_step_down(int64_t *value, const fxl_gradient *gradient)
{
    fxl_add_down(value, gradient->down);
}

static inline void fxl_next_row(const fxl_gradients *gradients, fxl_paint_row *row)
{
    row->y++;
    fxl_step_down(&row->weight, &gradients->weight);
    for (uint32_t i = 0; i < FXL_ATTRIBUTES && i < gradients->count; i++) {
        fxl_step_down(&row->attributes[i], &gradients->attributes[i]);
    }
}

#if FXL_HAS_DEPTH_ROWS

/* The next run of a list: its columns, and runs->row is its row. Returns whether it has pixels. is_full:
 * the face has all attributes, and runs->downs are all set. */
static inline __attribute__((always_inline)) bool fxl_take_run(const fxl_gradients *gradients,
                                                               fxl_plain_runs *runs, bool is_full,
                                                               int32_t *x0, int32_t *x1)
{
    const uint32_t run = *runs->next;
    fxl_paint_row *row = &runs->row;
    *x0 = (int32_t)(run & 0xFFFFu);
    *x1 = (int32_t)((run & ~FXL_RUN_BELOW) >> 16);
    if ((run & FXL_RUN_BELOW) == 0) {
        return *x0 < *x1;
    }
    row->pixels += runs->stride;
    if (is_full) {
        row->y++;
        fxl_add_down(&row->weight, runs->downs[0]);
        fxl_add_down(&row->attributes[0], runs->downs[1]);
        fxl_add_down(&row->attributes[1], runs->downs[2]);
        fxl_add_down(&row->attributes[2], runs->downs[3]);
    } else {
        fxl_next_row(gradients, row);
    }
    return *x0 < *x1;
}

#endif

/* A polygon of the screen in a band, whose pixels have so many bytes. segments: what the kernel of
 * segments needs; or null. */
static inline __attribute__((always_inline)) void
fxl_paint_polygon(const fxl_paint *paint, const fxl_segment_face *segments,
                  const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                  uint32_t pixel_bytes, fxl_scan *scan, fxl_row_painter *paint_row, void *with)
{
    const size_t stride = (size_t)band->stride * pixel_bytes;
    const fxl_gradients *gradients = paint->gradients;
    const fxl_trapezoid *trapezoid;
    fxl_paint_row row;
    fxl_span span;
    row.segments = segments;
    if (!FXL_SCANS_BY_CHAINS) {
        (void)fxl_active_edges_outline(&scan->active_edges, points, count, band);
        while (fxl_active_edges_next(&scan->active_edges, &span)) {
            row.pixels = band->pixels + (size_t)(span.y - band->first_row) * stride;
            fxl_begin_row(gradients, span.y, &row);
            paint_row(with, paint, &row, span.x0, span.x1);
        }
        return;
    }
    fxl_scan_outline(points, count, band, scan);
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
        row.pixels = band->pixels + (size_t)(trapezoid->first_row - band->first_row) * stride;
        fxl_begin_row(gradients, trapezoid->first_row, &row);
        while (row.y < trapezoid->end_row) {
            const int32_t x0 = a.x <= b.x ? a.x : b.x, x1 = a.x <= b.x ? b.x : a.x;
            if (x0 < x1) {
                paint_row(with, paint, &row, x0, x1);
            }
            fxl_edge_step(&a);
            fxl_edge_step(&b);
            row.pixels += stride;
            fxl_next_row(gradients, &row);
        }
    }
}

/* What changes from row to row in a face that has a kernel for its rows, and no light. */
static inline void fxl_find_downs(const fxl_gradients *gradients, int64_t downs[3])
{
    downs[0] = gradients->weight.down;
    downs[1] = gradients->attributes[FXL_ATTRIBUTE_U].down;
    downs[2] = gradients->attributes[FXL_ATTRIBUTE_V].down;
}

/* The rows of such a face above end_row. */
static inline __attribute__((always_inline)) void fxl_paint_plain_trapezoid(
    const fxl_paint *paint, int32_t end_row, fxl_plain_rows *rows,
    bool (*paint_rows)(fxl_plain_rows *rows),
    void (*paint_pixels)(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1))
{
    int32_t x0, x1;
    rows->end_row = end_row;
    while (rows->row.y < rows->end_row && paint_rows(rows)) {
        fxl_plain_rows_columns(rows, &x0, &x1);
        paint_pixels(paint, &rows->row, x0, x1);
        fxl_plain_rows_next(rows);
    }
}

/* fxl_paint_polygon of such a face. A trapezoid right below the one before goes on with its row. */
static inline __attribute__((always_inline)) void fxl_paint_plain_polygon(
    const fxl_paint *paint, const fxl_segment_face *segments, const fxl_screen_point *points,
    uint32_t count, const fxl_band *band, uint32_t pixel_bytes, fxl_scan *scan,
    bool (*paint_rows)(fxl_plain_rows *rows),
    void (*paint_pixels)(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1))
{
    const fxl_trapezoid *trapezoid;
    fxl_plain_rows rows;
    rows.stride = band->stride * pixel_bytes;
    rows.row.segments = segments;
    rows.row.y = -1;
    fxl_find_downs(paint->gradients, rows.downs);
    fxl_scan_outline(points, count, band, scan);
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        if (trapezoid->first_row != rows.row.y) {
            rows.row.pixels =
                band->pixels + (size_t)(trapezoid->first_row - band->first_row) * rows.stride;
            fxl_begin_row(paint->gradients, trapezoid->first_row, &rows.row);
        }
        rows.edges[0] = trapezoid->edges[0];
        rows.edges[1] = trapezoid->edges[1];
        fxl_paint_plain_trapezoid(paint, trapezoid->end_row, &rows, paint_rows, paint_pixels);
    }
}

/* fxl_row_painter of bytes: a whole row mostly goes to the kernel without detours. */
static inline __attribute__((always_inline)) void fxl_paint_simply(void *with,
                                                                   const fxl_paint *paint,
                                                                   const fxl_paint_row *row,
                                                                   int32_t x0, int32_t x1)
{
    (void)with;
    if (row->segments != NULL && paint->in_beam == NULL &&
        fxl_segments_suffice(row->segments, row, x0, x1)) {
        fxl_paint_segments(row->segments, row, x0, x1);
    } else {
        fxl_paint_pixels(paint, row, x0, x1);
    }
}

#endif
