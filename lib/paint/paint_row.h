/* SPDX-License-Identifier: MIT */
/* A row of a face, in segments of the screen's columns. The file that includes this has defined
 * before it what a pixel shows,
 *
 *   static inline void paint_pixel(const fxl_paint *paint, const fxl_paint_row *row, int32_t x,
 *                                  const int32_t values[FXL_ATTRIBUTES]);
 *
 * and defines after it how neighbouring pixels are painted, paint_linear. So there is one text for
 * all sizes of a pixel, and no call for each. Internal. */
#ifndef FXL_PAINT_ROW_H
#define FXL_PAINT_ROW_H

#include "segments.h"
#include "paint.h"

/* Neighbouring pixels whose attributes are linear: those of the first one, and the steps. */
typedef struct {
    uint32_t values[FXL_ATTRIBUTES], steps[FXL_ATTRIBUTES];
} linear_pixels;

/* The pixels x0 <= x < x1. */
static void paint_linear(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1,
                         const linear_pixels *of);

/* The same, pixel by pixel. */
static inline void paint_each_linear(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0,
                                     int32_t x1, const linear_pixels *of)
{
    int32_t values[FXL_ATTRIBUTES];
    for (int32_t x = x0; x < x1; x++) {
        for (uint32_t i = 0; i < paint->gradients->count; i++) {
            values[i] = (int32_t)(of->values[i] + (uint32_t)(x - x0) * of->steps[i]);
        }
        paint_pixel(paint, row, x, values);
    }
}

static void divide_each(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    int32_t values[FXL_ATTRIBUTES];
    for (int32_t x = x0; x < x1; x++) {
        fxl_divide_row_at(paint, row, x, values);
        paint_pixel(paint, row, x, values);
    }
}

/* --- segments ------------------------------------------------------------------------------- */

/* A column and its attributes: where one segment ends the next one begins. */
typedef struct {
    int32_t column; /* -1: none */
    int32_t values[FXL_ATTRIBUTES];
} divided_column;

/* The columns first..first + 2^log - 1, divided at both ends. A step is rounded down by less than a
 * unit, so the last pixel is off by less than 16 units of 1/65536. */
/* surfaces 2.2 */
static void paint_segment(const fxl_paint *paint, const fxl_paint_row *row, int32_t first,
                          unsigned log, int32_t x0, int32_t x1, divided_column *at)
{
    const fxl_gradients *gradients = paint->gradients;
    const int32_t last = first + (1 << log);
    const uint32_t skipped = (uint32_t)(x0 - first);
    int32_t ends[FXL_ATTRIBUTES];
    linear_pixels linear = {{0}, {0}};
    if (at->column != first) {
        fxl_divide_row_at(paint, row, first, at->values);
    }
    fxl_divide_row_at(paint, row, last, ends);
    at->column = last;
    for (uint32_t i = 0; i < FXL_ATTRIBUTES && i < gradients->count; i++) {
        const int32_t change = (int32_t)((uint32_t)ends[i] - (uint32_t)at->values[i]);
        linear.steps[i] = (uint32_t)(change >> log);
        linear.values[i] = (uint32_t)at->values[i] + skipped * linear.steps[i];
        at->values[i] = ends[i];
    }
    paint_linear(paint, row, x0, x1, &linear);
}

static inline int32_t smaller(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

/* Light in segments of 2^log columns: paint_segment of what has no other attribute. `light` and
 * `weight`: of column `begin`, which is a multiple of 2^log. */
static inline void paint_light_segments(const fxl_paint *paint, const fxl_paint_row *row,
                                        int32_t begin, unsigned log, int64_t weight, int32_t x0,
                                        int32_t x1, divided_column *at)
{
    const fxl_gradient *gradient = &paint->gradients->attributes[0];
    const int64_t weight_step = paint->gradients->weight.along * (1 << log);
    const int64_t light_step = gradient->along * (1 << log);
    const int shift = paint->gradients->shifts[0];
    int64_t light = row->attributes[0] + gradient->along * begin;
    linear_pixels linear = {{0}, {0}};
    int32_t from = at->values[0];
    if (at->column != begin) {
        const fxl_reciprocal reciprocal = fxl_reciprocal_of(fxl_upper_weight(weight));
        from = fxl_attribute_of((int32_t)(light >> 32), &reciprocal, shift);
    }
    do {
        weight += weight_step;
        light += light_step;
        const fxl_reciprocal reciprocal = fxl_reciprocal_of(fxl_upper_weight(weight));
        const int32_t to = fxl_attribute_of((int32_t)(light >> 32), &reciprocal, shift);
        const int32_t next = begin + (1 << log), end = smaller(next, x1);
        linear.steps[0] = (uint32_t)((int32_t)((uint32_t)to - (uint32_t)from) >> log);
        linear.values[0] = (uint32_t)from + (uint32_t)(x0 - begin) * linear.steps[0];
        paint_linear(paint, row, x0, end, &linear);
        from = to;
        begin = next;
        x0 = end;
    } while (x0 < x1);
    at->column = begin;
    at->values[0] = from;
}

/* Columns within 16 of a row. least: of fxl_find_least_weights. */
static __attribute__((unused)) void paint_sixteen(const fxl_paint *paint, const fxl_paint_row *row,
                                                  const uint32_t least[3], int32_t x0, int32_t x1,
                                                  divided_column *at)
{
    const int32_t first = x0 & ~15;
    const int64_t along = paint->gradients->weight.along, weight = row->weight + along * first;
    const uint32_t log =
        fxl_segment_log(least, fxl_upper_weight(weight), fxl_upper_weight(weight + 16 * along));
    if (log == 0) {
        divide_each(paint, row, x0, x1);
        return;
    }
    const int32_t columns = 1 << log;
    if (!FXL_IS_SMALL && !FXL_IS_COMPACT && paint->has_light_rows) {
        const int32_t begin = x0 & -columns;
        paint_light_segments(paint, row, begin, log, weight + along * (begin - first), x0, x1, at);
        return;
    }
    while (x0 < x1) {
        const int32_t begin = x0 & -columns, end = smaller(begin + columns, x1);
        paint_segment(paint, row, begin, log, x0, end, at);
        x0 = end;
    }
}

/* --- lines of texels, which are shown without a call a segment ----------------------------------- */

/* Neighbouring texels. */
typedef struct {
    uint32_t u, v, u_step, v_step, count;
} texel_line;

/* The numbers of 64 bits of a column. A segment may end beyond what gradients are bounded for: then
 * they wrap. */
typedef struct {
    int64_t weight, u, v;
} column_numbers;

static inline int64_t sum_64(int64_t a, int64_t b)
{
    return fxl_signed_64(fxl_bits_64(a) + fxl_bits_64(b));
}

static inline int64_t shifted_left(int64_t value, uint32_t bits)
{
    return fxl_signed_64(fxl_bits_64(value) << bits);
}

/* Numbers so many columns on: below 2^16. */
static inline column_numbers after(const column_numbers *at, const column_numbers *step,
                                   uint32_t columns)
{
    const column_numbers next = {sum_64(at->weight, fxl_multiply_s64_u16(step->weight, columns)),
                                 sum_64(at->u, fxl_multiply_s64_u16(step->u, columns)),
                                 sum_64(at->v, fxl_multiply_s64_u16(step->v, columns))};
    return next;
}

/* The weight at a column: below 2^16. */
static inline uint32_t weight_after(const fxl_paint *paint, const fxl_paint_row *row,
                                    uint32_t column)
{
    return fxl_upper_weight(sum_64(
        row->weight, fxl_multiply_s64_u16(paint->gradients->weight.along, column)));
}

/* Whether all segments of the pixels x0 <= x < x1 have 16 columns. The weight is linear, so it
 * suffices to look at both ends. */
static inline bool has_sixteens(const fxl_paint *paint, const fxl_paint_row *row, uint32_t x0,
                                uint32_t x1)
{
    const uint32_t least = paint->gradients->weight_min[0];
    return paint->division == FXL_DIVIDE_16 && weight_after(paint, row, x0 & ~15u) >= least &&
           weight_after(paint, row, (x1 + 15u) & ~15u) >= least;
}

/* The log of the segments of the 16 columns that have x0. */
static inline uint32_t log_at(const fxl_paint *paint, const fxl_paint_row *row, uint32_t x0)
{
    uint32_t least[3];
    fxl_find_least_weights(paint->gradients, paint->division, least);
    return fxl_segment_log(least, weight_after(paint, row, x0 & ~15u),
                           weight_after(paint, row, (x0 & ~15u) + 16u));
}

static inline int32_t upper_32(int64_t number)
{
    return (int32_t)(number >> 32);
}

/* fxl_attribute_of of u and v. Most are drops of the products' upper words by less than 32. */
FXL_APART void divide(const fxl_gradients *gradients, const column_numbers *at, int32_t *u,
                      int32_t *v)
{
    const fxl_reciprocal reciprocal = fxl_reciprocal_of(fxl_upper_weight(at->weight));
    const int32_t upper_u = upper_32(at->u), upper_v = upper_32(at->v);
    const int32_t u_shift = gradients->shifts[FXL_ATTRIBUTE_U];
    const int32_t v_shift = gradients->shifts[FXL_ATTRIBUTE_V];
    const int32_t left = 30 - (int32_t)reciprocal.zeros;
    const int32_t u_drop = left - u_shift, v_drop = left - v_shift;
    if (fxl_bits_32(u_drop | v_drop) < 32u) {
        *u = upper_32(fxl_multiply_s32(upper_u, reciprocal.value)) >> u_drop;
        *v = upper_32(fxl_multiply_s32(upper_v, reciprocal.value)) >> v_drop;
    } else {
        *u = fxl_attribute_of(upper_u, &reciprocal, u_shift);
        *v = fxl_attribute_of(upper_v, &reciprocal, v_shift);
    }
}

/* What numbers change in 2^log columns. */
static inline void find_step(const column_numbers *along, uint32_t log, column_numbers *step)
{
    step->weight = shifted_left(along->weight, log);
    step->u = shifted_left(along->u, log);
    step->v = shifted_left(along->v, log);
}

/* The lines of texels of the pixels x0 <= x < x1, whose segments have 2^log columns: paint_segment's,
 * and a pixel that is divided by itself is one. Returns how many they are. */
/* surfaces 2.2 */
static inline __attribute__((always_inline)) uint32_t
find_lines(const fxl_paint *paint, const fxl_paint_row *row, uint32_t x0, uint32_t x1, uint32_t log,
           texel_line *lines)
{
    const fxl_gradients *gradients = paint->gradients;
    const fxl_gradient *attributes = gradients->attributes;
    const column_numbers first = {row->weight, row->attributes[FXL_ATTRIBUTE_U],
                                  row->attributes[FXL_ATTRIBUTE_V]};
    const column_numbers along = {gradients->weight.along, attributes[FXL_ATTRIBUTE_U].along,
                                  attributes[FXL_ATTRIBUTE_V].along};
    uint32_t column = (x0 >> log) << log, found = 0;
    column_numbers at = after(&first, &along, column), step;
    int32_t u0, v0, u1, v1;
    find_step(&along, log, &step);
    divide(gradients, &at, &u0, &v0);
    do {
        const uint32_t skipped = x0 - column;
        texel_line *line = &lines[found++];
        column += 1u << log;
        at.weight = sum_64(at.weight, step.weight);
        at.u = sum_64(at.u, step.u);
        at.v = sum_64(at.v, step.v);
        divide(gradients, &at, &u1, &v1);
        line->u_step = (uint32_t)((int32_t)((uint32_t)u1 - (uint32_t)u0) >> log);
        line->v_step = (uint32_t)((int32_t)((uint32_t)v1 - (uint32_t)v0) >> log);
        line->u = (uint32_t)u0 + skipped * line->u_step;
        line->v = (uint32_t)v0 + skipped * line->v_step;
        line->count = (column < x1 ? column : x1) - x0;
        x0 += line->count;
        u0 = u1;
        v0 = v1;
    } while (x0 != x1);
    return found;
}

#endif
