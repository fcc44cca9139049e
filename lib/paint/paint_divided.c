/* SPDX-License-Identifier: MIT */
#include "paint_divided.h"

#include "../math/arith.h"
#include "../math/family.h"

bool fxl_divided_find(const fxl_paint *paint, fxl_divided_face *face)
{
    const fxl_texture_level *level = &paint->level;
    const fxl_gradients *gradients = paint->gradients;
    const fxl_gradient *u = &gradients->attributes[FXL_ATTRIBUTE_U];
    const fxl_gradient *v = &gradients->attributes[FXL_ATTRIBUTE_V];
    if (paint->division != FXL_DIVIDE_1 || level->texels == NULL || level->colours != NULL ||
        level->flags != 0 || level->log_width < FXL_DIVIDED_LOG_MIN || paint->opacity != 16 ||
        paint->ramp != NULL || paint->table != NULL || paint->is_replaced) {
        return false;
    }
    face->weight_slope = gradients->weight.along;
    face->u_slope = u->along;
    face->v_slope = v->along;
    face->weight_step = gradients->weight.along * 16;
    face->u_step = u->along * 16;
    face->v_step = v->along * 16;
    face->texels = level->texels;
    face->columns_mask = level->columns_less_1;
    face->rows_mask = level->rows_less_1 << level->log_width;
    /* u is U 2^shift / W in 16.16. */
    face->u_shift = gradients->shifts[FXL_ATTRIBUTE_U] + FXL_DIVIDED_U_BITS - 16 - 28;
    face->v_shift =
        gradients->shifts[FXL_ATTRIBUTE_V] + FXL_DIVIDED_V_BITS - 16 - 28 + level->log_width;
    return true;
}

#if !FXL_TEXELS_IN_ASSEMBLY

/* A number of 64 bits, shifted to the left by at most 31. Its upper word is what counts. */
FXL_ONCE int32_t shifted(int64_t value, int shift)
{
    return shift >= 0 ? (int32_t)(uint32_t)((uint64_t)value << shift >> 32)
                      : (int32_t)(value >> 32) >> (shift < -31 ? 31 : -shift);
}

/* The same, rounded to nearest where it is shifted to the left. */
static inline int32_t rounded(int64_t value, int shift)
{
    return shift >= 0 ? (int32_t)(uint32_t)((((uint64_t)value << shift) + 0x80000000u) >> 32)
                      : shifted(value, shift);
}

/* Whether the upper words of two numbers keep their values when they are shifted. */
static inline bool both_fit(int64_t a, int64_t b, int shift)
{
    const uint32_t bits = (uint32_t)((a ^ a >> 63) >> 32) | (uint32_t)((b ^ b >> 63) >> 32);
    return shift < 0 || (bits == 0 ? 32 : (int)fxl_leading_zeros(bits)) > shift;
}

/* Segments may end beyond what the gradients are bounded for: then their sums wrap. */
static inline int64_t sum(int64_t value, int64_t step)
{
    return (int64_t)((uint64_t)value + (uint64_t)step);
}

/* Three numbers that are linear along a row, or their steps. */
typedef struct {
    int64_t weight, u, v;
} row_values;

/* The first pixel's words, and what a pixel adds to them. */
typedef struct {
    uint32_t weight, u, v, weight_step, u_step, v_step;
} pixel_words;

/* The words of a segment between two ends. Returns false if it is not for the kernel. */
static bool find_words(const fxl_divided_face *face, const row_values *from, const row_values *to,
                       pixel_words *words)
{
    const int32_t weights[2] = {(int32_t)(from->weight >> 32), (int32_t)(to->weight >> 32)};
    const int32_t larger = weights[0] > weights[1] ? weights[0] : weights[1];
    const int32_t smaller = weights[0] > weights[1] ? weights[1] : weights[0];
    if (smaller <= 0) {
        return false;
    }
    const int zeros = (int)fxl_leading_zeros((uint32_t)larger);
    const int u_shift = face->u_shift + zeros, v_shift = face->v_shift + zeros;
    if ((uint32_t)smaller << zeros < FXL_DIVIDED_LEAST || !both_fit(from->u, to->u, u_shift) ||
        !both_fit(from->v, to->v, v_shift)) {
        return false;
    }
    words->weight = (uint32_t)shifted(from->weight, zeros);
    words->u = (uint32_t)shifted(from->u, u_shift);
    words->v = (uint32_t)shifted(from->v, v_shift);
    words->weight_step = (uint32_t)shifted(face->weight_slope, zeros);
    words->u_step = (uint32_t)rounded(face->u_slope, u_shift);
    words->v_step = (uint32_t)rounded(face->v_slope, v_shift);
    return true;
}

/* floor(numerator / denominator) for 2^14 <= denominator < 2^16 and a numerator below 2^30. */
static inline uint32_t quotient(uint32_t numerator, uint32_t denominator)
{
    const unsigned more = denominator < 1u << 15;
    return fxl_divide_half(numerator << more, denominator << more);
}

static void paint_words(const fxl_divided_face *face, pixel_words at, uint8_t *pixels,
                        uint32_t count)
{
    for (const uint8_t *end = pixels + count; pixels != end; pixels++) {
        /* The weight is at least 2^30, so the estimate is below 2^16. */
        const uint32_t estimate = quotient((1u << 30) - 1u, at.weight >> 16);
        const uint32_t square = (uint32_t)(fxl_multiply_u32(estimate * estimate, at.weight) >> 32);
        const int32_t inverse = (int32_t)((estimate << 15) - square); /* at most 2^30 */
        const int64_t u = fxl_multiply_s32(inverse, (int32_t)at.u);   /* below 2^62 */
        const int64_t v = fxl_multiply_s32(inverse, (int32_t)at.v);
        const uint32_t column = (uint32_t)(u >> 32) >> FXL_DIVIDED_U_BITS & face->columns_mask;
        const uint32_t start = (uint32_t)(v >> 32) >> FXL_DIVIDED_V_BITS & face->rows_mask;
        *pixels = face->texels[start + column];
        at.weight += at.weight_step;
        at.u += at.u_step;
        at.v += at.v_step;
    }
}

int32_t fxl_paint_divided(const fxl_divided_face *face, const fxl_paint_row *row, int32_t x0,
                          int32_t x1)
{
    const uint32_t segment = (uint32_t)x0 >> 4;
    row_values from = {
        sum(row->weight, fxl_multiply_s64(face->weight_step, segment)),
        sum(row->attributes[FXL_ATTRIBUTE_U], fxl_multiply_s64(face->u_step, segment)),
        sum(row->attributes[FXL_ATTRIBUTE_V], fxl_multiply_s64(face->v_step, segment))};
    while (x0 < x1) {
        const row_values to = {sum(from.weight, face->weight_step), sum(from.u, face->u_step),
                               sum(from.v, face->v_step)};
        const uint32_t skip = (uint32_t)x0 & 15u, left = (uint32_t)(x1 - x0);
        const uint32_t count = left < 16u - skip ? left : 16u - skip;
        pixel_words words;
        if (!find_words(face, &from, &to, &words)) {
            break;
        }
        words.weight += skip * words.weight_step;
        words.u += skip * words.u_step;
        words.v += skip * words.v_step;
        paint_words(face, words, row->pixels + x0, count);
        x0 += (int32_t)count;
        from = to;
    }
    return x0;
}

#endif
