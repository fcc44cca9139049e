/* SPDX-License-Identifier: MIT */
/* The pixels of most textured faces, painted by the kernel fxl_paint_segments: 8 bits a texel,
 * repeated, opaque, and divided every 16 columns. Internal.
 *
 * A segment is the 16 columns of the screen from a multiple of 16 on. Its coordinates are found at
 * both ends, at its first column and 16 columns on:
 *
 *   U = u 2^(20 - log_width),  V = v 2^(20 - log),  log = the larger of log_width and log_height.
 *
 * Its position p is one word: U / 16 in the upper half, V / 16 in the lower one. The upper bits of
 * each half are the texel's column and row, and the others its fraction. So a column repeats by
 * itself. A pixel adds a step to p,
 *
 *   step = 2^16 round((U1 - U0) / 256) + round((V1 - V0) / 256) modulo 2^16, from -2^15 on.
 *
 * Error beyond that of the line between both ends, in units of 2^-(16 - log): less than 1 of p and
 * 1/2 of each of at most 15 steps. Where v repeats, a carry of the lower half adds 1 to u, or takes
 * it away. For 64 x 64 texels a unit is 1/1024 texel.
 *
 * Light is in 1/256 level. At both ends, L0 and L1, it is limited to the levels, and a step is
 * floor(L1 / 16) - floor(L0 / 16). So the last pixel has floor(L0 / 16) + L0 % 16 +
 * 15 floor(L1 / 16): a level again, and less than 1/16 level off. What is divided at the end of
 * segment k is light's upper word in column 0, and k times the upper word of the step. */
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
    int32_t light_max;   /* of the ramp, in 1/256 level */
    int32_t drop_min;    /* of light, U and V */
    int32_t weight_min;  /* at both ends of a segment; at least 2 */
    uint8_t log_width;
    uint8_t row_drop;    /* 16 - log_width - log: how far p is shifted to the mask */
    uint8_t is_constant; /* the weight is the same in all columns of a row */
    uint8_t form;        /* log_width - 4 if it is above 0 and log_width = log; else 0 */
    uint32_t light_scale, light_limit; /* a light is surely a level of the ramp where its upper word
                                        * light_scale < weight * light_limit; 0, 0: nowhere */
};

/* Prepares *face. Returns false if the kernel cannot paint this: *face is undefined then. */
bool fxl_segments_find(const fxl_paint *paint, fxl_segment_face *face);

/* The weight at the beginning of a segment of a row. */
static inline int32_t fxl_segment_weight(const fxl_segment_face *face, const fxl_paint_row *row,
                                         uint32_t segment)
{
    return (int32_t)(((uint64_t)row->weight + (uint64_t)face->weight_step * segment) >> 32);
}

/* Whether the weight is large enough at both ends of all segments of a part of a row. It is linear,
 * so it suffices to look at the first end and the last. */
static inline bool fxl_segments_suffice(const fxl_segment_face *face, const fxl_paint_row *row,
                                        int32_t x0, int32_t x1)
{
    return fxl_segment_weight(face, row, (uint32_t)x0 >> 4) >= face->weight_min &&
           fxl_segment_weight(face, row, ((uint32_t)x1 + 15u) >> 4) >= face->weight_min;
}

/* Whether the light at the beginning of a segment is surely a level of the ramp. Requires a weight
 * there of at least weight_min. The sum of upper words is at most segment + 1 less than the light's
 * own upper word. The light is below 2^31 and light_scale at most 2^30; the weight is below 2^31
 * and light_limit at most 2^24: no product exceeds 64 bits. */
static inline bool fxl_segment_light_suffices(const fxl_segment_face *face,
                                              const fxl_paint_row *row, uint32_t segment)
{
    const uint32_t light =
        (uint32_t)(row->attributes[FXL_SEGMENT_LIGHT] >> 32) + segment * (uint32_t)face->light_step;
    const uint32_t weight = (uint32_t)fxl_segment_weight(face, row, segment);
    return (int32_t)light >= 0 && fxl_multiply_u32(light + segment + 1u, face->light_scale) <
                                      fxl_multiply_u32(weight, face->light_limit);
}

/* Whether the kernel surely takes a part of a row: the weights suffice, and light is within the
 * ramp at both ends, so between them, too. False says nothing of light. */
static inline bool fxl_segments_take(const fxl_segment_face *face, const fxl_paint_row *row,
                                     int32_t x0, int32_t x1)
{
    return fxl_segments_suffice(face, row, x0, x1) &&
           (face->ramp == NULL ||
            (fxl_segment_light_suffices(face, row, (uint32_t)x0 >> 4) &&
             fxl_segment_light_suffices(face, row, ((uint32_t)x1 + 15u) >> 4)));
}

/* Paints the pixels x0 <= x < x1 of a row. Requires 0 <= x0 < x1, and weights of at least
 * weight_min at both ends of each segment. Safe for any other number: no texel or entry of the ramp
 * is read that is not of the table. */
void fxl_paint_segments(const fxl_segment_face *face, const fxl_paint_row *row, int32_t x0,
                        int32_t x1);

/* --- the texels of a part of a segment: what fxl_paint_segments calls, where it is in C ---------
 */

/* At a run's first pixel, and the steps a pixel. */
typedef struct {
    uint32_t position, step;
    uint32_t light, light_step; /* 1/256 level */
} fxl_texel_run;

/* Paints count pixels. Requires 1 <= count <= 16. */
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
static inline fxl_reciprocal fxl_reciprocal_of(uint32_t weight)
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

/* value * 2^shift / weight, modulo 2^32, rounded down. Requires |value| < 2^30. */
static inline int32_t fxl_attribute_of(int32_t value, const fxl_reciprocal *reciprocal, int shift)
{
    const int drop = 62 - (int)reciprocal->zeros - shift;
    const int64_t product = fxl_multiply_s32(value, reciprocal->value); /* below 2^61 */
    return (int32_t)(uint32_t)(product >> (drop < 0 ? 0 : drop > 63 ? 63 : drop));
}

#ifdef __cplusplus
}
#endif

#endif
