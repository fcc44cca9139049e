/* SPDX-License-Identifier: MIT */
/* The division of an edge's set-up with UDIV of 32 bits and UMULL; the contract
 * is lib/kernels/portable/edge_divide.h. */
#ifndef FXL_EDGE_DIVIDE_H
#define FXL_EDGE_DIVIDE_H

#include <stdint.h>

#define FXL_EDGE_HEIGHT_MAX   ((1 << 26) - 1)
#define FXL_EDGE_DIVIDEND_MAX ((1 << 27) + (1 << 17))

typedef struct {
    uint32_t height;
    uint32_t half;      /* 2^31 <= 2 half < 2^32: height 2^(shift - 1) */
    int32_t reciprocal; /* 2^62 / (2 half), off by -2^-29.38 to 2^-30.9 of it (every upper half
                           tried) */
    unsigned shift;
} fxl_edge_divider;

/* One division of 32 bits gives the reciprocal's upper 16, one step after
 * Newton the rest; what is subtracted from the numerator shares the first
 * error out to both sides. rough 2 half is about 2^63, and
 * rough (2^64 - rough 2 half) / 2^64 about 2^62 / (2 half). */
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

/* dividend 2^62 / (height 2^shift), shifted right by 30 - shift, is the
 * quotient but for an error of |dividend| 2^(32 - 29.38) / height + 1 at most.
 * What is left of the dividend then is below 2^29.63 + 2^26 < 2^30 either way,
 * so its lower 32 bits tell all of it; with 2^30 <= half < 2^31 added, which is
 * height 2^(shift - 1), it is not negative, and one division finds the rest.
 * The dividend's two spare bits are given before the product: so the shift is
 * 1 at least. */
static inline void fxl_edge_divide(const fxl_edge_divider *divider, int32_t dividend,
                                   int32_t *whole, uint32_t *fraction)
{
    int64_t product = (int64_t)(dividend * 4) * divider->reciprocal;
    int32_t high = (int32_t)(product >> 32);
    unsigned shift = divider->shift, rest_shift = 32 - shift;
    uint32_t near_z = (uint32_t)high << shift | (uint32_t)product >> rest_shift;
    uint32_t left = divider->half - near_z * divider->height;
    int32_t more = (int32_t)(left / divider->height) - (int32_t)((1u << shift) >> 1) + 1;
    uint32_t sum = near_z + (uint32_t)more;
    *whole = (high >> rest_shift) + (more >> 31) + (sum < near_z);
    *fraction = sum;
}

#endif
