/* SPDX-License-Identifier: MIT */
/* The arithmetic of this core's family, inline; and what every family makes of it. Internal. */
#ifndef FXL_CORE_H
#define FXL_CORE_H

#include "family.h"
#if FXL_CORE_ARMV6M
#include "core_armv6m.h"
#else
#include "core_portable.h"
#endif

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
