/* SPDX-License-Identifier: MIT */
#include "../raster/fill_row.h"
#include "paint.h"
#include "segments.h"

/* The row's gradients, y rows down. */
static void begin_row(const fxl_gradients *gradients, int32_t y, fxl_paint_row *row)
{
    row->y = y;
    row->weight = gradients->weight.at + gradients->weight.down * y;
    for (uint32_t i = 0; i < gradients->count; i++) {
        row->attributes[i] = gradients->attributes[i].at + gradients->attributes[i].down * y;
    }
}

/* The row below the last one may be beyond what is bounded: then a sum wraps. */
static inline void step(int64_t *value, const fxl_gradient *gradient)
{
    *value = (int64_t)((uint64_t)*value + (uint64_t)gradient->down);
}

static inline void next_row(const fxl_gradients *gradients, fxl_paint_row *row)
{
    row->y++;
    step(&row->weight, &gradients->weight);
    for (uint32_t i = 0; i < FXL_ATTRIBUTES && i < gradients->count; i++) {
        step(&row->attributes[i], &gradients->attributes[i]);
    }
}

/* A whole row mostly goes to the kernel without detours. */
static inline void paint_simply(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0,
                                int32_t x1)
{
    if (row->segments != NULL && fxl_segments_take(row->segments, row, x0, x1)) {
        fxl_paint_segments(row->segments, row, x0, x1);
    } else {
        fxl_paint_pixels(paint, row, x0, x1);
    }
}

static void paint_trapezoid(const fxl_paint *paint, const fxl_trapezoid *trapezoid,
                            const fxl_segment_face *segments, const fxl_band *band,
                            fxl_row_painter *paint_row, void *with)
{
    const fxl_gradients *gradients = paint->gradients;
    fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
    fxl_paint_row row;
    row.pixels = band->pixels + (size_t)(trapezoid->first_row - band->first_row) * band->stride;
    row.segments = segments;
    begin_row(gradients, trapezoid->first_row, &row);
    while (row.y < trapezoid->end_row) {
        const int32_t x0 = a.x <= b.x ? a.x : b.x, x1 = a.x <= b.x ? b.x : a.x;
        if (x0 < x1) {
            if (paint_row == NULL) {
                paint_simply(paint, &row, x0, x1);
            } else {
                paint_row(with, paint, &row, x0, x1);
            }
        }
        fxl_edge_step(&a);
        fxl_edge_step(&b);
        row.pixels += band->stride;
        next_row(gradients, &row);
    }
}

void fxl_paint_polygon(const fxl_paint *paint, const fxl_screen_point *points, uint32_t count,
                       const fxl_band *band, fxl_scan *scan, fxl_row_painter *paint_row, void *with)
{
    const fxl_trapezoid *trapezoid;
    fxl_segment_face face;
    const fxl_segment_face *segments = fxl_segments_find(paint, &face) ? &face : NULL;
    fxl_scan_outline(points, count, band, scan);
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        paint_trapezoid(paint, trapezoid, segments, band, paint_row, with);
    }
}
