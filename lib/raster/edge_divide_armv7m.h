/* SPDX-License-Identifier: MIT */
/* The division of an edge's set-up, with UDIV of 32 bits and UMULL.
 * lib/raster/edge_divide_portable.h states what each function requires and returns. */
#ifndef FXL_EDGE_DIVIDE_H
#define FXL_EDGE_DIVIDE_H

#include <stdint.h>

#define FXL_EDGE_HEIGHT_MAX   ((1 << 26) - 1)
#define FXL_EDGE_DIVIDEND_MAX ((1 << 27) + (1 << 17))

typedef struct {
    uint32_t height;
    uint32_t half;      /* height 2^(shift - 1): 2^31 <= 2 half < 2^32 */
    int32_t reciprocal; /* 2^62 / (2 half); error -2^-29.38 to 2^-30.9 of it (all upper halves
                           were tried) */
    unsigned shift;
} fxl_edge_divider;

/* One division of 32 bits gives the upper 16 bits of the reciprocal, and one step of Newton's
 * method gives the rest. The numerator is reduced so that the error of the division is
 * centred about 0. rough 2 half is about 2^63, and rough (2^64 - rough 2 half) / 2^64 is
 * about 2^62 / (2 half). */
static inline fxl_edge_divider fxl_edge_divider_of(uint32_t height)
{
    fxl_edge_divider divider;
    divider.height = height;
    divider.shift = (unsigned)__builtin_clz(height);
    uint32_t scaled = height << divider.shift;
    uint32_t rough = (0xFFFF7FFFu / (scaled >> 16)) << 15;
    uint32_t product = (uint32_t)(((uint64_t)rough * scaled) >> 32);
    divider.reciprocal = (int32_t)(((uint64_t)rough * (0u - product)) >> 32);
    divider.half = scaled >> 1;
    return divider;
}

static inline unsigned fxl_edge_divider_shift(const fxl_edge_divider *divider)
{
    return divider->shift;
}

/* The estimate is dividend 2^62 / (height 2^shift), shifted right by 30 - shift. Its error is
 * at most |dividend| 2^(32 - 29.38) / height + 1. The magnitude of the rest that it leaves
 * is below 2^29.63 + 2^26 < 2^30, so the lower 32 bits hold all of the rest. half, which is
 * height 2^(shift - 1) and 2^30 <= half < 2^31, is added to the rest, which then is not
 * negative, and one division finds the correction. The dividend is multiplied by 4 before
 * the product, because it has two spare bits. So the shift right is by at least 1. */
static inline void fxl_edge_divide(const fxl_edge_divider *divider, int32_t dividend,
                                   int32_t *whole, uint32_t *fraction)
{
    int64_t product = (int64_t)(dividend * 4) * divider->reciprocal;
    int32_t high = (int32_t)(product >> 32);
    unsigned shift = divider->shift, rest_shift = 32 - shift;
    uint32_t estimate = (uint32_t)high << shift | (uint32_t)product >> rest_shift;
    uint32_t left = divider->half - estimate * divider->height;
    int32_t more = (int32_t)(left / divider->height) - (int32_t)((1u << shift) >> 1) + 1;
    uint32_t sum = estimate + (uint32_t)more;
    *whole = (high >> rest_shift) + (more >> 31) + (sum < estimate);
    *fraction = sum;
}

#endif
