/* SPDX-License-Identifier: MIT */
#include "paint_divided.h"
#include "segments.h"

#include "../math/arith.h"
#include "../math/family.h"

/* place stipple: the pattern's bits of pixels that are each divided */
/* What a pixel does with its texel; returns false if it is more than one of the kinds. */
static bool find_kind(const fxl_paint *paint, fxl_divided_face *face)
{
    const fxl_texture_level *level = &paint->level;
    const uint32_t flags = level->flags;
    const bool is_stippled = paint->opacity < 16, has_4_bits = level->colours != NULL;
    if (flags == 0 && !is_stippled && !has_4_bits) {
        face->kind = level->log_width == 8 ? (uint8_t)FXL_DIVIDED_WIDE : (uint8_t)FXL_TEXELS_PLAIN;
        return true;
    }
    if ((flags & (flags - 1u)) != 0 || (flags != 0) + is_stippled + has_4_bits != 1 ||
        paint->has_beams) {
        return false;
    }
    if (has_4_bits) {
        face->kind = FXL_TEXELS_4;
        face->colours = level->colours;
    } else if (is_stippled) {
        face->kind = FXL_TEXELS_STIPPLED;
        face->stipple = fxl_stipple_of(paint->opacity);
    } else if (flags == FXL_TEXTURE_KEYED) {
        face->kind = FXL_TEXELS_KEYED;
        face->key = level->key;
    } else {
        face->kind = FXL_TEXELS_CLAMPED;
    }
    return true;
}

/* place sampling: pixels that are each divided: both coordinates in words of their own */
/* What leads from coordinates to a texel. u is U 2^shift / W in 16.16. */
static void find_place(const fxl_paint *paint, fxl_divided_face *face)
{
    const fxl_texture_level *level = &paint->level;
    const int8_t *shifts = paint->gradients->shifts;
    const int log_width = level->log_width, log_height = (int)fxl_bit_length(level->rows_less_1);
    int u_bits = FXL_DIVIDED_U_BITS, v_bits = FXL_DIVIDED_V_BITS;
    face->texels = level->texels;
    face->columns_mask = level->columns_less_1;
    face->rows_mask = level->rows_less_1 << log_width;
    if (face->kind == FXL_TEXELS_CLAMPED) {
        u_bits = FXL_DIVIDED_SIZE_BITS - log_width;
        v_bits = FXL_DIVIDED_SIZE_BITS - log_height - log_width;
        face->columns_mask = 16u - (uint32_t)log_width;
        face->v_drop = (uint8_t)(16 - log_height - log_width);
    } else {
        v_bits = log_width == 8 ? FXL_DIVIDED_V_BITS_WIDE : v_bits;
        face->v_drop = (uint8_t)v_bits;
    }
    face->u_shift = shifts[FXL_ATTRIBUTE_U] + u_bits - 16 - 28;
    face->v_shift = shifts[FXL_ATTRIBUTE_V] + v_bits - 16 - 28 + log_width;
}

bool fxl_divided_find(const fxl_paint *paint, fxl_divided_face *face)
{
    const fxl_texture_level *level = &paint->level;
    const fxl_gradients *gradients = paint->gradients;
    const fxl_gradient *u = &gradients->attributes[FXL_ATTRIBUTE_U];
    const fxl_gradient *v = &gradients->attributes[FXL_ATTRIBUTE_V];
    if (paint->division != FXL_DIVIDE_1 || level->texels == NULL ||
        level->log_width < FXL_DIVIDED_LOG_MIN || paint->ramp != NULL || paint->table != NULL ||
        paint->is_replaced || !find_kind(paint, face)) {
        return false;
    }
    face->weight_slope = gradients->weight.along;
    face->u_slope = u->along;
    face->v_slope = v->along;
    face->weight_step = gradients->weight.along * 16;
    face->u_step = u->along * 16;
    face->v_step = v->along * 16;
    find_place(paint, face);
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

static inline uint32_t held(int32_t coordinate)
{
    return coordinate < 0 ? 0 : coordinate > 0xFFFF ? 0xFFFFu : (uint32_t)coordinate;
}

/* The number of the texel at two coordinates. */
static inline uint32_t place_of(const fxl_divided_face *face, int32_t u, int32_t v)
{
    if (face->kind == FXL_TEXELS_CLAMPED) {
        return (held(v >> (FXL_DIVIDED_SIZE_BITS - 16)) >> face->v_drop & face->rows_mask) +
               (held(u >> (FXL_DIVIDED_SIZE_BITS - 16)) >> face->columns_mask);
    }
    return ((uint32_t)v >> face->v_drop & face->rows_mask) +
           ((uint32_t)u >> FXL_DIVIDED_U_BITS & face->columns_mask);
}

static inline void show(const fxl_divided_face *face, uint32_t place, uint32_t x, uint32_t y,
                        uint8_t *pixel)
{
    if (face->kind == FXL_TEXELS_4) {
        const uint32_t two = face->texels[place >> 1];
        *pixel = face->colours[two >> (4u * (place & 1u)) & 15u];
    } else if ((face->kind != FXL_TEXELS_KEYED || face->texels[place] != face->key) &&
               (face->kind != FXL_TEXELS_STIPPLED ||
                (face->stipple >> (4u * (y & 3u) + (x & 3u)) & 1u) != 0)) {
        *pixel = face->texels[place];
    }
}

static void paint_words(const fxl_divided_face *face, pixel_words at, const fxl_paint_row *row,
                        uint32_t x, uint32_t count)
{
    for (const uint32_t end = x + count; x != end; x++) {
        /* The weight is at least 2^30, so the estimate is below 2^16. */
        const uint32_t estimate = quotient((1u << 30) - 1u, at.weight >> 16);
        const uint32_t square = (uint32_t)(fxl_multiply_u32(estimate * estimate, at.weight) >> 32);
        const int32_t inverse = (int32_t)((estimate << 15) - square); /* at most 2^30 */
        const int64_t u = fxl_multiply_s32(inverse, (int32_t)at.u);   /* below 2^62 */
        const int64_t v = fxl_multiply_s32(inverse, (int32_t)at.v);
        show(face, place_of(face, (int32_t)(u >> 32), (int32_t)(v >> 32)), x, (uint32_t)row->y,
             row->pixels + x);
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
        paint_words(face, words, row, (uint32_t)x0, count);
        x0 += (int32_t)count;
        from = to;
    }
    return x0;
}

#endif
