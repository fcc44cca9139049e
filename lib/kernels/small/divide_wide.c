/* SPDX-License-Identifier: MIT */
/* Long division, a bit at a time. */
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
