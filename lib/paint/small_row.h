/* SPDX-License-Identifier: MIT */
/* place pixel-format: opaque pixels with FXL_SMALL */
/* Opaque pixels of RGB565 with FXL_SMALL: one text for the segments of segments.h and for those of
 * paint_row.h, whose pixels it paints one by one. A part of paint_rgb565.c. Internal. */
#ifndef FXL_SMALL_ROW_H
#define FXL_SMALL_ROW_H

#include "lit_row.h"
#include "paint_row.h"

#define SEGMENT_PARTS_ALONE 1
#include "segment_runs.h"

/* A column and its attributes. face: they are coordinates of segments.h; null: they are in 16.16. */
typedef struct {
    const fxl_segment_face *face;
    int32_t column; /* -1: none */
    int32_t values[FXL_ATTRIBUTES];
} small_column;

/* Attributes at a column. Coordinates have log_width - 4 bits less, or log - 4. */
static void divide_small(const fxl_paint *paint, const fxl_paint_row *row,
                         const fxl_segment_face *face, int32_t x, int32_t values[FXL_ATTRIBUTES])
{
    const fxl_gradients *gradients = paint->gradients;
    const fxl_reciprocal reciprocal = fxl_reciprocal_of(fxl_row_weight_at(paint, row, x));
    for (uint32_t i = 0; i < gradients->count; i++) {
        const int less =
            face != NULL ? (i == 0 ? face->log_width : face->log) - (int)FXL_SEGMENT_LOG_MIN : 0;
        values[i] =
            fxl_attribute_of(fxl_row_value_at(row->attributes[i], &gradients->attributes[i], x),
                             &reciprocal, gradients->shifts[i] - less);
    }
}

/* The first pixel's attributes and their steps in the segment of 2^log columns from `first` on, in
 * 16.16. A position becomes the first of them, and its step. */
/* SPEC 9.5, surfaces 2.2 */
static inline void find_small(const fxl_paint *paint, const fxl_paint_row *row, int32_t first,
                              uint32_t log, small_column *at, linear_pixels *linear)
{
    const fxl_segment_face *face = at->face;
    const int32_t last = first + (1 << log);
    uint32_t *values = linear->values, *steps = linear->steps;
    int32_t ends[FXL_ATTRIBUTES];
    if (at->column != first) {
        divide_small(paint, row, face, first, at->values);
    }
    divide_small(paint, row, face, last, ends);
    at->column = last;
    for (uint32_t i = 0; i < paint->gradients->count; i++) {
        const int32_t from = at->values[i], change = difference(ends[i], from);
        values[i] = (uint32_t)from;
        steps[i] = (uint32_t)(change >> log);
        if (face != NULL) {
            const uint32_t scale =
                face->kind == FXL_TEXELS_CLAMPED ? (i == 0 ? face->log_width : face->log) : 0;
            values[i] = (uint32_t)(from >> 4) << scale;
            steps[i] = (uint32_t)step_of(from, ends[i], log) << scale;
        }
        at->values[i] = ends[i];
    }
    if (face != NULL && face->kind != FXL_TEXELS_CLAMPED) {
        values[0] = values[0] << 16 | (values[1] & 0xFFFFu);
        steps[0] = (steps[0] << 16) + fxl_bits_32((int16_t)fxl_low_16(steps[1]));
    }
}

/* Columns within 16 of a row. least: of fxl_find_least_weights. */
static void paint_small(const fxl_paint *paint, const fxl_paint_row *row, const uint32_t least[3],
                        int32_t x0, int32_t x1, small_column *at)
{
    const uint32_t weight_0 = fxl_row_weight_at(paint, row, x0 & ~15);
    const uint32_t weight_1 = fxl_row_weight_at(paint, row, (x0 & ~15) + 16);
    const fxl_segment_face *face = row->segments;
    const uint32_t weight = weight_0 < weight_1 ? weight_0 : weight_1;
    if (face != NULL && weight < face->least[3]) {
        face = NULL;
    }
    if (face != at->face) {
        at->face = face;
        at->column = -1;
    }
    const bool is_line = face != NULL && face->is_constant;
    const bool has_position = face != NULL && face->kind != FXL_TEXELS_CLAMPED;
    const uint32_t log =
        is_line ? 4 : fxl_segment_log(face != NULL ? face->least : least, weight, weight);
    while (x0 < x1) {
        const int32_t first = x0 >> log << log, end = smaller(first + (1 << log), x1);
        linear_pixels linear;
        if (is_line) {
            fxl_texel_run run;
            find_line_run(face, row, (uint32_t)x0 >> 4, &run);
            linear.values[0] = run.position;
            linear.steps[0] = run.step;
            linear.values[1] = linear.steps[1] = 0; /* v is in the position */
        } else {
            find_small(paint, row, first, log, at, &linear);
        }
        const bool has_lights = paint->has_light_rows && log != 0;
        if (has_lights) {
            const uint32_t step = linear.steps[0] << 8;
            const fxl_light_run run = {(linear.values[0] << 8) + (uint32_t)(x0 - first) * step,
                                       step};
            paint_lights(paint, row, x0, end, &run);
        }
        for (int32_t x = x0; x < end && !has_lights; x++) {
            int32_t values[FXL_ATTRIBUTES];
            for (uint32_t i = 0; i < paint->gradients->count; i++) {
                values[i] = (int32_t)(linear.values[i] + (uint32_t)(x - first) * linear.steps[i]);
            }
            if (has_position) {
                const uint32_t position = (uint32_t)values[0];
                values[FXL_ATTRIBUTE_U] = (int32_t)(position >> (16u - face->log_width));
                values[FXL_ATTRIBUTE_V] = (int32_t)(position << face->log);
            }
            paint_pixel(paint, row, x, values);
        }
        x0 = end;
    }
}

#endif
