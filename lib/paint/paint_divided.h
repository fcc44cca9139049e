/* SPDX-License-Identifier: MIT */
/* Pixels of which each is divided by itself, unlit, of a face with FXL_DIVIDE_1: 8 bits a texel,
 * repeated and opaque, or of one other kind. Internal.
 *
 * A segment is the 16 columns of the screen from a multiple of 16 on. Its weight W and its
 * coordinates U and V begin as the row's numbers of 64 bits, cut to one word each, and a pixel adds
 * a word to each. All three are shifted by what makes the larger weight of both ends fill 32 bits.
 * With the reciprocal r = 2^60 / W a pixel has
 *
 *   u = U r / 2^32 in units of 2^-18 texel,  v = V r / 2^32 in 2^-11 texel of the texture's memory,
 *
 * where a row of texels is 2^log_width of them. Where these are 256, v is in 2^-7: then V fits a word
 * for as many rows. The coordinates of a texture that does not repeat are in 2^-22 of its size.
 *
 * Error: at both ends a weight is above 2^30, so the estimate of r, 2^30 / (W / 2^16) rounded
 * down, is relatively within 2^-14, and Newton's step squares that: 2^-28. A unit of U is at most a
 * quarter of a unit of u. What is cut off a word and off 15 steps is below 16 units: of W
 * relatively 2^-26, of U 4 units of u. So u is off by less than 2^-25 |u| + 2^-16 texel, and v by
 * less than 2^-25 |v| + 2^(-9 - log_width), or 2^-13 where a row has 256 texels. Of a texture that
 * does not repeat both are off by 2^-20 of its size. */
#ifndef FXL_PAINT_DIVIDED_H
#define FXL_PAINT_DIVIDED_H

#include "paint.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FXL_DIVIDED_U_BITS 18 /* of the fraction of u */
#define FXL_DIVIDED_V_BITS 11
#define FXL_DIVIDED_V_BITS_WIDE 7 /* where a row has 256 texels */
#define FXL_DIVIDED_SIZE_BITS 22  /* of the size of a texture that does not repeat */

/* Beside the kinds of segments.h: plain texels, 256 a row. */
#define FXL_DIVIDED_WIDE 5u

/* The least log_width that the kernel takes: v has a fraction of at least 15 bits. */
#define FXL_DIVIDED_LOG_MIN 4u

/* The least weight at both ends of a segment, where the larger one has 32 bits: after 15 steps that
 * are rounded down it is still 2^30. */
#define FXL_DIVIDED_LEAST 0x40004000u

/* place sampling: pixels that are each divided: both coordinates in words of their own */
/* What the kernel needs of a face. The slopes are those of a pixel, the steps those of 16. U is
 * shifted to the left by u_shift and the leading zeros of the larger weight, V by v_shift. */
typedef struct {
    int64_t weight_step, u_step, v_step;
    int64_t weight_slope, u_slope, v_slope;
    const uint8_t *texels;
    uint32_t columns_mask; /* 2^log_width - 1; of a clamped texture, 16 - log_width */
    uint32_t rows_mask;    /* (2^log_height - 1) 2^log_width */
    int32_t u_shift, v_shift;
    union {
        uint32_t key;           /* FXL_TEXELS_KEYED */
        uint32_t stipple;       /* FXL_TEXELS_STIPPLED, as of fxl_segment_face */
        const uint8_t *colours; /* FXL_TEXELS_4 */
    };
    uint8_t kind;   /* FXL_TEXELS_PLAIN and so on, or FXL_DIVIDED_WIDE */
    uint8_t v_drop; /* bits of v, or of its 16 upper ones where it is clamped, below rows_mask */
} fxl_divided_face;

/* Prepares *face. Returns false if the kernel cannot paint this: *face is undefined then. */
bool fxl_divided_find(const fxl_paint *paint, fxl_divided_face *face);

/* Paints the pixels x0 <= x < x1 of a row, up to the first segment whose weights are too far apart
 * or too small, or whose coordinates too large. Returns the column from which on nothing is
 * painted. Which segments it paints depends on the face and the row alone. Requires 0 <= x0 < x1.
 * Safe for any other number: no texel is read that is not of the table. */
int32_t fxl_paint_divided(const fxl_divided_face *face, const fxl_paint_row *row, int32_t x0,
                          int32_t x1);

#ifdef __cplusplus
}
#endif

#endif
