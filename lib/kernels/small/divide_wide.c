/* SPDX-License-Identifier: MIT */
/* Long division, a bit at a time, and the long product. */
#include "divide_wide.h"

#include "arith.h"

uint32_t fxl_divide_u64(uint64_t numerator, uint32_t denominator, uint32_t *rest)
{
    uint32_t left = (uint32_t)(numerator >> 32), lower = (uint32_t)numerator;
    FXL_ASSERT(left < denominator);
    if (left == 0) {
        return fxl_divide_u32(lower, denominator, rest);
    }
    /* The quotient comes into lower as the numerator goes out. */
    for (unsigned bits = 32; bits != 0; bits--) {
        bool carry = left >> 31 != 0;
        left = left << 1 | lower >> 31;
        lower <<= 1;
        if (carry || left >= denominator) {
            left -= denominator;
            lower |= 1u;
        }
    }
    *rest = left;
    return lower;
}

uint64_t fxl_fraction(uint64_t part, uint64_t whole)
{
    FXL_ASSERT(part < whole && whole >> 63 == 0);
    uint64_t fraction = 0;
    for (unsigned bits = 64; bits != 0; bits--) {
        part <<= 1;
        fraction <<= 1;
        if (part >= whole) {
            part -= whole;
            fraction |= 1u;
        }
    }
    return fraction;
}

/* floor(a * b / 2^64), from four products of 32 bits. Each middle sum is at
 * most (2^32 - 1)^2 + 2 (2^32 - 1) = 2^64 - 1. */
uint64_t fxl_multiply_high(uint64_t a, uint64_t b)
{
    uint32_t a_high = (uint32_t)(a >> 32), a_low = (uint32_t)a;
    uint32_t b_high = (uint32_t)(b >> 32), b_low = (uint32_t)b;
    uint64_t middle = fxl_multiply_u32(a_high, b_low) + (fxl_multiply_u32(a_low, b_low) >> 32);
    uint64_t other = fxl_multiply_u32(a_low, b_high) + (uint32_t)middle;
    return fxl_multiply_u32(a_high, b_high) + (middle >> 32) + (other >> 32);
}
