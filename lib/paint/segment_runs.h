/* SPDX-License-Identifier: MIT */
/* The kernels of segments in portable C: one text for both sizes of a pixel. The file that includes
 * this has defined before it how neighbouring pixels within 16 columns are painted,
 *
 *   static inline void paint_texels(const fxl_segment_face *face, const fxl_paint_row *row,
 *                                   const fxl_texel_run *run, int32_t x, uint32_t count);
 *
 * and, for the kernels of plain_run.h, which of them paints these pixels, TEXEL_CODE, and whether
 * the kernels take a face:
 *
 *   static inline bool has_kernel(const fxl_segment_face *face);
 *
 * and HAS_RAMPS, 1 or 0: whether a face may be lit.
 *
 * Internal. */
#ifndef FXL_SEGMENT_RUNS_H
#define FXL_SEGMENT_RUNS_H

#include "../math/family.h"
#include "plain_run.h"
#include "segment_lengths.h"

/* What a segment has at one end. */
typedef struct {
    int32_t u, v, light;
} segment_end;

FXL_ONCE int64_t shifted(int64_t product, int32_t left)
{
    return fxl_shifted_down(product, (unsigned)(left < 0 ? 0 : left > 63 ? 63 : left));
}

/* A product, shifted. The weight is large enough that it is not shifted to the left. */
FXL_ONCE int32_t divided(int32_t value, const fxl_reciprocal *reciprocal, int32_t drop)
{
    const int64_t product = fxl_multiply_s32(value, reciprocal->value);
    const int32_t left = drop - (int32_t)reciprocal->zeros;
    if (!FXL_IS_COMPACT && left >= 0) { /* the upper word has all of it */
        return (int32_t)(product >> 32) >> (left > 31 ? 31 : left);
    }
    return (int32_t)(uint32_t)shifted(product, 32 + left);
}

static inline int32_t difference(int32_t a, int32_t b)
{
    return (int32_t)((uint32_t)a - (uint32_t)b);
}

/* A coordinate some steps on. An end beyond the face may lie far away: then a sum wraps. */
static inline int32_t moved(int32_t value, int32_t step, uint32_t steps)
{
    return (int32_t)((uint32_t)value + (uint32_t)step * steps);
}

/* A 16th of a difference's part of 2^log, rounded to nearest. */
static inline int32_t step_of(int32_t from, int32_t to, uint32_t log)
{
    return (int32_t)((uint32_t)difference(to, from) + (8u << log)) >> (4u + log);
}

static inline uint32_t position_of(const segment_end *end)
{
    return (uint32_t)(end->u >> 4) << 16 | ((uint32_t)end->v >> 4 & 0xFFFFu);
}

/* SPEC 9.5 */
static inline void find_texels(const segment_end *from, const segment_end *to, uint32_t log,
                               fxl_texel_run *run)
{
    run->position = position_of(from);
    run->step = ((uint32_t)step_of(from->u, to->u, log) << 16) +
                (uint32_t)(int32_t)(int16_t)(uint16_t)step_of(from->v, to->v, log);
    run->light = (uint32_t)from->light;
    run->light_step = (uint32_t)(to->light >> log) - (uint32_t)(from->light >> log);
}

static inline int32_t held(int32_t coordinate)
{
    return coordinate < 0 ? 0 : coordinate > 0xFFFF ? 0xFFFF : coordinate;
}

/* --- rows of constant weight ---------------------------------------------------------------- */

/* A coordinate of 32 bits, and its changes in 16 columns and in one. */
typedef struct {
    uint32_t at, change, step;
} row_line;

/* The upper half of a step, rounded to nearest; its lower half is 0. */
static inline uint32_t upper_half(uint32_t step)
{
    return (step + 0x8000u) & 0xFFFF0000u;
}

/* The change's upper word is rounded: 2^-31 of the largest value on the screen, at most 64 times.
 * What a step loses is given back in the middle of 16 columns, and half a unit of the position,
 * which is cut off. */
static inline void find_line(int64_t value, int64_t change, const fxl_reciprocal *reciprocal,
                             int32_t drop, uint32_t segment, row_line *line)
{
    const int32_t left = 32 + drop - FXL_ROW_BITS - (int32_t)reciprocal->zeros;
    const int32_t upper = (int32_t)(((uint64_t)change + 0x80000000u) >> 32);
    const int64_t product = fxl_multiply_s32(upper, reciprocal->value);
    line->change = (uint32_t)shifted(product, left);
    line->step = (uint32_t)shifted(product, left + 4);
    line->at =
        (uint32_t)shifted(fxl_multiply_s32((int32_t)(value >> 32), reciprocal->value), left) +
        segment * line->change + 8u * (line->step - upper_half(line->step)) + 0x8000u;
}

static inline void find_line_run(const fxl_segment_face *face, const fxl_paint_row *row,
                                 uint32_t segment, fxl_texel_run *run)
{
    const fxl_reciprocal reciprocal = fxl_reciprocal_of((uint32_t)(row->weight >> 32));
    row_line u, v;
    find_line(row->attributes[FXL_ATTRIBUTE_U], face->u_step, &reciprocal, face->u_drop, segment,
              &u);
    find_line(row->attributes[FXL_ATTRIBUTE_V], face->v_step, &reciprocal, face->v_drop, segment,
              &v);
    run->position = (u.at & 0xFFFF0000u) | v.at >> 16;
    run->step = upper_half(u.step) + (uint32_t)((int32_t)upper_half(v.step) >> 16);
    run->light = run->light_step = 0;
}

/* --- a row, one segment after the other ------------------------------------------------------ */

#if defined SEGMENT_PARTS_ALONE

/* small_row.h has a text of its own. */

#elif FXL_SEGMENTS_ONE_BY_ONE

/* The upper word of a value at a column. Steps are multiples of 16: exact. */
/* surfaces 2.2 */
static FXL_ONE_COPY int32_t upper_at(int64_t first, int64_t step, uint32_t column)
{
    return (int32_t)(sum(first, step >> 4, column) >> 32);
}

/* What a row has at column number `segment` of those that are multiples of 2^log. */
static FXL_ONE_COPY void find_end(const fxl_segment_face *face, const fxl_paint_row *row,
                                  uint32_t log, uint32_t segment, segment_end *end)
{
    const uint32_t column = segment << log;
    const int64_t *attributes = row->attributes;
    const fxl_reciprocal reciprocal =
        fxl_reciprocal_of((uint32_t)upper_at(row->weight, face->weight_step, column));
    end->u = divided(upper_at(attributes[FXL_ATTRIBUTE_U], face->u_step, column), &reciprocal,
                     face->u_drop);
    end->v = divided(upper_at(attributes[FXL_ATTRIBUTE_V], face->v_step, column), &reciprocal,
                     face->v_drop);
    end->light = 0;
    if (HAS_RAMPS && face->ramp != NULL) {
        const uint32_t light = (uint32_t)(attributes[FXL_SEGMENT_LIGHT] >> 32) +
                               segment * (uint32_t)(face->light_step >> (4u - log));
        end->light = divided((int32_t)light, &reciprocal, face->light_drop);
    }
}

/* Pixels of a texture that does not repeat. */
static inline void paint_clamped(const fxl_segment_face *face, const fxl_paint_row *row,
                                 const segment_end *from, const segment_end *to, uint32_t log,
                                 int32_t x0, int32_t x1)
{
    const int32_t u_step = step_of(from->u, to->u, log), v_step = step_of(from->v, to->v, log);
    const uint32_t skip = (uint32_t)x0 & ((1u << log) - 1u);
    int32_t u = moved(from->u >> 4, u_step, skip), v = moved(from->v >> 4, v_step, skip);
    fxl_texel_run run = {0, 0, 0, 0};
    for (; x0 < x1; x0++) {
        run.position = (uint32_t)held(u) << 16 | (uint32_t)held(v);
        paint_texels(face, row, &run, x0, 1);
        u = moved(u, u_step, 1);
        v = moved(v, v_step, 1);
    }
}

static inline void paint_row_segments(const fxl_segment_face *face, const fxl_paint_row *row,
                                      int32_t x0, int32_t x1)
{
    const bool is_line = face->is_constant && (!HAS_RAMPS || face->ramp == NULL);
    uint32_t last_log = 5; /* none */
    segment_end ends[2];
    while (x0 < x1) {
        const uint32_t log =
            is_line ? 4
                    : log_of(face, (uint64_t)sum(row->weight, face->weight_step, (uint32_t)x0 >> 4));
        const uint32_t segment = (uint32_t)x0 >> log, skip = (uint32_t)x0 - (segment << log);
        const int32_t next = (int32_t)((segment + 1u) << log), end = next < x1 ? next : x1;
        fxl_texel_run run;
        if (is_line) {
            find_line_run(face, row, segment, &run);
        } else {
            if (log == last_log) {
                ends[0] = ends[1];
            } else {
                find_end(face, row, log, segment, &ends[0]);
                last_log = log;
            }
            find_end(face, row, log, segment + 1u, &ends[1]);
            find_texels(&ends[0], &ends[1], log, &run);
        }
        if (face->kind == FXL_TEXELS_CLAMPED) {
            paint_clamped(face, row, &ends[0], &ends[1], log, x0, end);
        } else {
            run.position += run.step * skip;
            run.light += run.light_step * skip;
            paint_texels(face, row, &run, x0, (uint32_t)(end - x0));
        }
        x0 = end;
    }
}

#else

/* --- a row, all segments of one length after the other ---------------------------------------- */

/* The weight, u and v at a column, their steps, and the light's upper word, and its step. */
typedef struct {
    int64_t values[3], steps[3];
    int32_t light, light_step;
} segment_values;

/* The values at column number `segment` of those that are multiples of 2^log. Steps are multiples
 * of 16: exact. */
/* surfaces 2.2 */
static inline void begin(const fxl_segment_face *face, const fxl_paint_row *row, uint32_t log,
                         uint32_t segment, segment_values *at)
{
    const int64_t *attributes = row->attributes;
    const int64_t first[3] = {row->weight, attributes[FXL_ATTRIBUTE_U],
                              attributes[FXL_ATTRIBUTE_V]};
    const int64_t steps[3] = {face->weight_step, face->u_step, face->v_step};
    FXL_EACH_OF_THREE
    for (uint32_t i = 0; i < 3; i++) {
        at->steps[i] = steps[i] >> (4u - log);
        at->values[i] = sum(first[i], at->steps[i], segment);
    }
    at->light = at->light_step = 0;
    if (face->ramp != NULL) {
        at->light_step = face->light_step >> (4u - log);
        at->light = (int32_t)((uint32_t)(attributes[FXL_SEGMENT_LIGHT] >> 32) +
                              segment * (uint32_t)at->light_step);
    }
}

static inline uint32_t weight_at(const segment_values *at)
{
    return (uint32_t)(at->values[0] >> 32);
}

static inline void advance(segment_values *at)
{
    FXL_EACH_OF_THREE
    for (uint32_t i = 0; i < 3; i++) {
        at->values[i] = (int64_t)((uint64_t)at->values[i] + (uint64_t)at->steps[i]);
    }
    at->light = (int32_t)((uint32_t)at->light + (uint32_t)at->light_step);
}

static inline void find_end(const fxl_segment_face *face, const segment_values *at,
                            const fxl_reciprocal *reciprocal, segment_end *end)
{
    end->u = divided((int32_t)(at->values[1] >> 32), reciprocal, face->u_drop);
    end->v = divided((int32_t)(at->values[2] >> 32), reciprocal, face->v_drop);
    end->light = 0;
    if (face->ramp != NULL) {
        end->light = divided(at->light, reciprocal, face->light_drop);
    }
}

/* The pixels of a segment of 2^log columns from x0 on, before x1; returns how many they are. */
static inline int32_t paint_part(const fxl_segment_face *face, const fxl_paint_row *row,
                                 const fxl_texel_run *run, uint32_t log, int32_t x0, int32_t x1)
{
    const uint32_t columns = 1u << log, skip = (uint32_t)x0 & (columns - 1u);
    const uint32_t left = (uint32_t)(x1 - x0);
    const uint32_t count = left < columns - skip ? left : columns - skip;
    fxl_texel_run part = *run;
    part.position += run->step * skip;
    part.light += run->light_step * skip;
    paint_texels(face, row, &part, x0, count);
    return (int32_t)count;
}

/* Whether a coordinate of the pixels from `first` to `last` is within the texture. If it is beyond
 * the same side at all of them, it is held there, and is within it, too. */
static inline bool hold_within(int32_t *first, int32_t last, int32_t *step)
{
    if ((*first & last) < 0 || (*first > 0xFFFF && last > 0xFFFF)) {
        *first = held(*first);
        *step = 0;
        return true;
    }
    return ((uint32_t)*first | (uint32_t)last) <= 0xFFFFu;
}

/* paint_part of a texture that does not repeat. */
static inline int32_t paint_clamped(const fxl_segment_face *face, const fxl_paint_row *row,
                                    const segment_end *from, const segment_end *to, uint32_t log,
                                    int32_t x0, int32_t x1)
{
    const uint32_t columns = 1u << log, skip = (uint32_t)x0 & (columns - 1u);
    const uint32_t left = (uint32_t)(x1 - x0);
    const uint32_t count = left < columns - skip ? left : columns - skip;
    int32_t u_step = step_of(from->u, to->u, log), v_step = step_of(from->v, to->v, log);
    int32_t u = moved(from->u >> 4, u_step, skip), v = moved(from->v >> 4, v_step, skip);
    const bool is_u_within = hold_within(&u, moved(u, u_step, count - 1u), &u_step);
    const bool is_v_within = hold_within(&v, moved(v, v_step, count - 1u), &v_step);
    fxl_texel_run run = {0, 0, 0, 0};
    if (is_u_within && is_v_within) {
        run.position = ((uint32_t)u << 16) + (uint32_t)v;
        run.step = ((uint32_t)u_step << 16) + (uint32_t)v_step;
        paint_texels(face, row, &run, x0, count);
        return (int32_t)count;
    }
    for (uint32_t i = 0; i < count; i++) {
        run.position = (uint32_t)held(u) << 16 | (uint32_t)held(v);
        paint_texels(face, row, &run, x0 + (int32_t)i, 1);
        u = moved(u, u_step, 1);
        v = moved(v, v_step, 1);
    }
    return (int32_t)count;
}

/* Segments of 2^log columns. */
FXL_APART void paint_run(const fxl_segment_face *face, const fxl_paint_row *row, uint32_t log,
                         int32_t x0, int32_t x1)
{
    segment_values at;
    segment_end ends[2];
    fxl_texel_run run;
    begin(face, row, log, (uint32_t)x0 >> log, &at);
    fxl_reciprocal reciprocal = fxl_reciprocal_of(weight_at(&at));
    find_end(face, &at, &reciprocal, &ends[0]);
    while (x0 < x1) {
        advance(&at);
        if (!face->is_constant) {
            reciprocal = fxl_reciprocal_of(weight_at(&at));
        }
        find_end(face, &at, &reciprocal, &ends[1]);
        if (face->kind == FXL_TEXELS_CLAMPED) {
            x0 += paint_clamped(face, row, &ends[0], &ends[1], log, x0, x1);
        } else {
            find_texels(&ends[0], &ends[1], log, &run);
            x0 += paint_part(face, row, &run, log, x0, x1);
        }
        ends[0] = ends[1];
    }
}

/* Each pixel divided. */
FXL_APART void paint_each(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                          int32_t x1)
{
    segment_values at;
    segment_end end;
    fxl_texel_run run = {0, 0, 0, 0};
    begin(face, row, 0, (uint32_t)x0, &at);
    for (; x0 < x1; x0++) {
        const fxl_reciprocal reciprocal = fxl_reciprocal_of(weight_at(&at));
        find_end(face, &at, &reciprocal, &end);
        if (face->kind == FXL_TEXELS_CLAMPED) {
            (void)paint_clamped(face, row, &end, &end, 0, x0, x0 + 1);
        } else {
            run.position = position_of(&end);
            paint_texels(face, row, &run, x0, 1);
        }
        advance(&at);
    }
}

FXL_APART void paint_line(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                          int32_t x1)
{
    const fxl_reciprocal reciprocal = fxl_reciprocal_of((uint32_t)(row->weight >> 32));
    const uint32_t segment = (uint32_t)x0 >> 4;
    row_line u, v;
    fxl_texel_run run = {0, 0, 0, 0};
    find_line(row->attributes[FXL_ATTRIBUTE_U], face->u_step, &reciprocal, face->u_drop, segment,
              &u);
    find_line(row->attributes[FXL_ATTRIBUTE_V], face->v_step, &reciprocal, face->v_drop, segment,
              &v);
    run.step = upper_half(u.step) + (uint32_t)((int32_t)upper_half(v.step) >> 16);
    if (FXL_KERNELS_ARMV6M && has_kernel(face)) {
        const fxl_line_run line = {x0, x1, TEXEL_CODE, u.at, v.at, u.change, v.change, run.step};
        fxl_paint_line(face, row, &line);
        return;
    }
    while (x0 < x1) {
        run.position = (u.at & 0xFFFF0000u) | v.at >> 16;
        x0 += paint_part(face, row, &run, 4, x0, x1);
        u.at += u.change;
        v.at += v.change;
    }
}

/* --- a row ---------------------------------------------------------------------------------- */

/* Segments of 2^log columns, or pixels that are each divided. */
static inline void paint_equal(const fxl_segment_face *face, const fxl_paint_row *row, uint32_t log,
                               int32_t x0, int32_t x1)
{
    if (FXL_KERNELS_ARMV6M && has_kernel(face)) {
        const fxl_run run = {x0, x1, TEXEL_CODE, log};
        fxl_paint_run(face, row, &run);
    } else if (FXL_KERNELS_ARMV6M || FXL_IS_COMPACT ||
               log != 0) { /* no pixel of a lit face is divided here */
        paint_run(face, row, log, x0, x1);
    } else {
        paint_each(face, row, x0, x1);
    }
}

static inline void paint_row_segments(const fxl_segment_face *face, const fxl_paint_row *row,
                                      int32_t x0, int32_t x1)
{
    if (face->is_constant && face->ramp == NULL) {
        paint_line(face, row, x0, x1);
        return;
    }
    uint64_t weight = (uint64_t)sum(row->weight, face->weight_step, (uint32_t)x0 >> 4);
    while (x0 < x1) {
        uint32_t log;
        const int32_t end = next_length(face, x0, x1, &weight, &log);
        paint_equal(face, row, log, x0, end);
        x0 = end;
    }
}

#endif

#endif
