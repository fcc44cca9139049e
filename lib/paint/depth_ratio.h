/* SPDX-License-Identifier: MIT */
/* near_z by a distance, to 30 bits. Internal. */
#ifndef FXL_DEPTH_RATIO_H
#define FXL_DEPTH_RATIO_H

#include "../math/arith.h"

/* A number mantissa * 2^exponent. */
typedef struct {
    uint32_t mantissa; /* 2^31 to 2^32 */
    int exponent;
} fxl_normalised;

/* Requires number > 0. Rounded down, by less than 2^-31 of it. */
static inline fxl_normalised fxl_normalise(uint64_t number)
{
    const int drop = (int)fxl_bit_length(number) - 32;
    const fxl_normalised result = {(uint32_t)(drop > 0 ? number >> drop : number << -drop), drop};
    return result;
}

/* The ratio of the mantissas, times 2^31 and rounded down: from 2^30 to 2^32 - 2. */
static inline uint32_t fxl_ratio_of(const fxl_normalised *near_z, const fxl_normalised *divisor)
{
    uint32_t rest;
    return fxl_divide_u64((uint64_t)(near_z->mantissa >> 1) << 32, divisor->mantissa, &rest);
}

#endif
