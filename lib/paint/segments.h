/* SPDX-License-Identifier: MIT */
/* The pixels of most textured faces, painted by the kernels fxl_paint_segments, for pixels of 8
 * bits, and fxl_paint_segments_565, for pixels of 16 bits: texels that repeat, none of them
 * blended. Internal.
 *
 * A segment is n = 16, 8 or 4 columns of the screen, from a multiple of n on; gradients.h says
 * which n, or that each pixel is divided: then the kernel shows what fxl_paint_pixels would, and
 * leaves a lit face to that. The coordinates of a segment are found at both ends, at its first
 * column and n columns on:
 *
 *   U = u 2^(20 - log_width),  V = v 2^(20 - log),  log = the larger of log_width and log_height.
 *
 * Its position p is one word: U / 16 in the upper half, V / 16 in the lower one. The upper bits of
 * each half are the texel's column and row, and the others its fraction. So a column repeats by
 * itself. A pixel adds a step to p,
 *
 *   step = 2^16 round((U1 - U0) / 16n) + round((V1 - V0) / 16n) modulo 2^16, from -2^15 on.
 *
 * Error beyond that of the line between both ends, in units of 2^-(16 - log): less than 1 of p and
 * 1/2 of each of at most 15 steps. Where v repeats, a carry of the lower half adds 1 to u, or takes
 * it away. For 64 x 64 texels a unit is 1/1024 texel.
 *
 * Where the weight is the same in all columns and there is no light, a row is one line. Its
 * coordinates have 32 bits, FXL_ROW_BITS more than U and V: at column 16 k they are those of column
 * 0 and k times their change in 16 columns, modulo 2^32. p is their upper halves there, and the
 * step is a 16th of the change, rounded to the upper half; 8 times what that loses, and half a unit
 * of p, are added to the coordinates, so that the middle of 16 columns is right. So p begins anew
 * every 16 columns.
 *
 * Light is in 1/256 level. With L0 and L1 at both ends, a step is floor(L1 / n) - floor(L0 / n). So
 * the last pixel has floor(L0 / n) + L0 % n + (n - 1) floor(L1 / n): a level again if L0 and L1
 * are, and less than 1/16 level off. Where they are not, outside of the face, each pixel's light is
 * limited to the levels. What is divided at the end of segment k is light's upper word in column 0,
 * and k times the upper word of the step, which for less than 16 columns is shifted to the right.
 */
#ifndef FXL_SEGMENTS_H
#define FXL_SEGMENTS_H

#include "paint.h"

#include "../math/arith.h"

#ifdef __cplusplus
extern "C" {
#endif

/* With a texture, light follows u and v. */
#define FXL_SEGMENT_LIGHT 2u

/* The least log_width that the kernel takes: (U1 - U0) fits 32 bits. */
#define FXL_SEGMENT_LOG_MIN 4u

/* The columns between two positions that are found anew in a row of constant weight, and the bits
 * of its coordinates beyond those of U and V. */
#define FXL_ROW_BITS 12

/* What a pixel does with its texel. All but plain ones have no ramp; keyed and stippled ones of 16
 * bits have texels of RGB565. */
enum {
    FXL_TEXELS_PLAIN = 0,
    FXL_TEXELS_KEYED = 1,    /* one texel is not drawn */
    FXL_TEXELS_STIPPLED = 2, /* an opacity below 16 */
    FXL_TEXELS_4 = 3,        /* texels of 4 bits */
    FXL_TEXELS_CLAMPED = 4   /* opaque ones, of as many rows as columns, at least 32, which do not
                              * repeat; is_constant is false */
};

/* Whether a texel itself is more than one of 8 or 16 bits that is drawn. */
#define FXL_TEXELS_ARE_SPECIAL(kind) ((kind) != FXL_TEXELS_PLAIN && (kind) != FXL_TEXELS_CLAMPED)

/* Whether the pixels of a kind may be left out. */
#define FXL_TEXELS_HAVE_HOLES(kind) ((kind) == FXL_TEXELS_KEYED || (kind) == FXL_TEXELS_STIPPLED)

/* place sampling: positions in a segment, and their texels: keys, patterns, 4 bits too */
/* What the kernel needs of a face. The steps are those of 16 columns; of light, the upper word. A
 * value's upper word times the reciprocal of the weight is a product of 64 bits, whose upper word,
 * shifted to the right by the drop less the leading zeros of the weight, is U, V or the light. */
struct fxl_segment_face {
    int64_t weight_step, u_step, v_step;
    int32_t u_drop, v_drop;
    const uint8_t *texels;
    uint32_t rows_mask; /* (2^log_height - 1) 2^log_width */
    int32_t light_step, light_drop;
    const uint8_t *ramp; /* null: unlit */
    union {
        int32_t light_max; /* of the ramp, in 1/256 level */
        uint32_t key;      /* FXL_TEXELS_KEYED: the texel that is not drawn */
        uint32_t stipple;  /* FXL_TEXELS_STIPPLED: bit 4 (y mod 4) + x mod 4: a pixel is drawn */
    };
    int32_t drop_min;  /* of light, U and V */
    uint32_t least[4]; /* weights at both ends of 16 columns: for segments of 16, 8 and 4, and for
                          pixels that are divided; from 2 on; INT32_MAX: none */
    uint8_t log_width;
    uint8_t row_drop;        /* 16 - log_width - log: how far p is shifted to the mask */
    uint8_t is_constant;     /* the weight is the same in all columns of a row */
    uint8_t form;            /* log_width - 4 if it is above 0 and log_width = log; else 0 */
    const uint16_t *palette; /* fxl_paint_segments_565: of the texels' colours; null: the texels are
                              * colours themselves */
    union {
        const uint8_t *in_beam; /* the same: what a beam makes of a texel before that; null: none */
        const uint8_t *colours; /* FXL_TEXELS_4: of the level */
    };
    const uint8_t *table; /* fxl_paint_segments: as of fxl_paint */
    uint8_t kind;         /* FXL_TEXELS_PLAIN and so on; others than that have form 0 */
    uint8_t log; /* of small_row.h alone */
};

/* Of fxl_paint_segments_565: whether the texels are the colours of pixels, and no entries. */
static inline bool fxl_texels_are_colours(const fxl_segment_face *face)
{
    return face->palette == NULL;
}

/* place stipple: the order of the pattern's bits, which the kernels read */
/* The pixels that an opacity draws, as bits: `stipple`. */
uint32_t fxl_stipple_of(uint32_t opacity);

/* Prepares *face. Returns false if the kernel cannot paint this: *face is undefined then. */
bool fxl_segments_find(const fxl_paint *paint, fxl_segment_face *face);

/* The same for pixels of 16 bits, and fxl_paint_segments_565. */
bool fxl_segments_find_565(const fxl_paint *paint, fxl_segment_face *face);

/* The weight at the beginning of a segment of a row. */
static inline int32_t fxl_segment_weight(const fxl_segment_face *face, const fxl_paint_row *row,
                                         uint32_t segment)
{
    return (int32_t)(((uint64_t)row->weight +
                      (uint64_t)fxl_multiply_s64_u16(face->weight_step, segment)) >>
                     32);
}

/* The least weight, at both ends of each 16 columns, that the kernel takes. */
static inline int32_t fxl_segments_least(const fxl_segment_face *face)
{
    return (int32_t)face->least[3];
}

/* Whether the weight is large enough at both ends of all 16 columns of a part of a row. It is
 * linear, so it suffices to look at the first end and the last. */
/* surfaces 2.1 */
static inline bool fxl_segments_suffice(const fxl_segment_face *face, const fxl_paint_row *row,
                                        int32_t x0, int32_t x1)
{
    return fxl_segment_weight(face, row, (uint32_t)x0 >> 4) >= fxl_segments_least(face) &&
           fxl_segment_weight(face, row, ((uint32_t)x1 + 15u) >> 4) >= fxl_segments_least(face);
}

/* The column before which the kernel may paint from x0 on: x0, the end of 16 columns, or
 * x1. */
FXL_APART int32_t fxl_segments_end(const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    const fxl_segment_face *face = row->segments;
    if (face == NULL ||
        fxl_segment_weight(face, row, (uint32_t)x0 >> 4) < fxl_segments_least(face)) {
        return x0;
    }
    if (fxl_segments_suffice(face, row, x0, x1)) {
        return x1;
    }
    uint32_t segment = (uint32_t)x0 >> 4;
    while (fxl_segment_weight(face, row, segment + 1u) >= fxl_segments_least(face)) {
        segment++; /* less than the last one of the row, where the weight is too small */
    }
    return (int32_t)(16u * segment) > x0 ? (int32_t)(16u * segment) : x0;
}

/* Paints the pixels x0 <= x < x1 of a row. Requires 0 <= x0 < x1, and weights of at least
 * fxl_segments_least at both ends of each 16 columns. Safe for any other number: no texel or entry
 * of the ramp is read that is not of the table. */
void fxl_paint_segments(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                        int32_t x1);
void fxl_paint_segments_565(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                            int32_t x1);

/* The same of a lit face with least weights of its own, and in segments of 2^log columns, log from
 * 2 on, whatever its weights: Armv7-M. */
void fxl_paint_lit_segments(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                            int32_t x1);
void fxl_paint_lit_run(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                       int32_t x1, uint32_t log);

/* --- the texels of a part of a segment: what fxl_paint_segments calls, where it is in C ---------
 */

/* At a run's first pixel, and the steps a pixel. */
typedef struct {
    uint32_t position, step;
    uint32_t light, light_step; /* 1/256 level */
} fxl_texel_run;

/* Paints count pixels. Requires 1 <= count <= 16, and light that is a level. */
void fxl_paint_texels(const fxl_segment_face *face, const fxl_texel_run *run, uint8_t *pixels,
                      uint32_t count);

/* --- the exact division of attributes by the weight ---------------------------------------- */

/* A weight's reciprocal: value 2^62 / (weight 2^zeros), from 2^30 to 2^31. */
typedef struct {
    int32_t value;
    unsigned zeros;
} fxl_reciprocal;

/* Requires 1 <= weight < 2^31. The lowest bit of the weight counts as set, so no reciprocal of a
 * weight from 2 on is 2^31. The first estimate divides by the 16 upper bits: it is within 2^-15,
 * relatively. Newton's step squares that: at most 2^-30 too small. Its product is rounded down:
 * less than a unit too large. So the error is below 2^-29. */
static inline fxl_reciprocal fxl_reciprocal_in_place(uint32_t weight)
{
    fxl_reciprocal reciprocal;
    reciprocal.zeros = fxl_leading_zeros(weight);
    const uint32_t scaled = (weight | 1u) << reciprocal.zeros;
    const uint32_t estimate = fxl_divide_half((uint32_t)INT32_MAX, scaled >> 16); /* below 2^16 */
    const uint32_t value =
        (estimate << 16) - (uint32_t)(fxl_multiply_u32(estimate * estimate, scaled) >> 32);
    reciprocal.value = (int32_t)(value - (value >> 31));
    return reciprocal;
}

/* The same; a library for size has it once, and one for Armv6-M, whose text is long. */
#define FXL_RECIPROCAL_IS_APART (FXL_IS_COMPACT || FXL_CORE_ARMV6M)
#if FXL_RECIPROCAL_IS_APART
fxl_reciprocal fxl_reciprocal_of(uint32_t weight);
#else
static inline fxl_reciprocal fxl_reciprocal_of(uint32_t weight)
{
    return fxl_reciprocal_in_place(weight);
}
#endif

/* value * 2^shift / weight, modulo 2^32, rounded down. Requires |value| < 2^31. */
static inline int32_t fxl_attribute_of(int32_t value, const fxl_reciprocal *reciprocal, int shift)
{
    const int drop = 62 - (int)reciprocal->zeros - shift;
    const int64_t product = fxl_multiply_s32(value, reciprocal->value); /* below 2^62 */
    const unsigned bits = drop < 0 ? 0 : drop > 63 ? 63 : (unsigned)drop;
    return fxl_signed_32(
        fxl_low_32(fxl_bits_64(FXL_IS_SMALL ? fxl_shifted_down(product, bits) : product >> bits)));
}

#ifdef __cplusplus
}
#endif

#endif
