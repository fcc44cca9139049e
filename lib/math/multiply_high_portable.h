/* SPDX-License-Identifier: MIT */
/* The upper half of a product of 64 by 64 bits. Internal. */
#ifndef FXL_MULTIPLY_HIGH_H
#define FXL_MULTIPLY_HIGH_H

#include "multiply.h"

/* floor(a * b / 2^64), from four products of 32 bits. Each middle sum is at
 * most (2^32 - 1)^2 + 2 (2^32 - 1) = 2^64 - 1. */
static inline uint64_t fxl_multiply_high(uint64_t a, uint64_t b)
{
    uint32_t a_high = (uint32_t)(a >> 32), a_low = (uint32_t)a;
    uint32_t b_high = (uint32_t)(b >> 32), b_low = (uint32_t)b;
    uint64_t middle = fxl_multiply_u32(a_high, b_low) + (fxl_multiply_u32(a_low, b_low) >> 32);
    uint64_t other = fxl_multiply_u32(a_low, b_high) + (uint32_t)middle;
    return fxl_multiply_u32(a_high, b_high) + (middle >> 32) + (other >> 32);
}

#endif
