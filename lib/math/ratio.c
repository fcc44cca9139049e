/* SPDX-License-Identifier: MIT */
#include "ratio.h"

#include "arith.h"

/* If the depth has more than 31 bits, it is shifted down to 31 bits and rounded; the error
 * is 2^-31 of the quotient. The product is shifted down by the same amount and rounded
 * downward; the error is less than 2^-30 of a unit, because the depth is then at least
 * 2^30. With side = 2^32 high + low the product is 2^32 (factor high) + factor low:
 * |factor high| <= 2^58, factor low is below 2^61, and 2^32 (factor high) is divisible by
 * 2^shift. */
bool fxl_ratio(fxl_q16_16 factor, fxl_q18_46 side, fxl_q18_46 depth, int32_t limit,
               int32_t *quotient)
{
    FXL_ASSERT(factor > 0 && depth > 0);
    unsigned bits = fxl_bit_length((uint64_t)depth);
    unsigned shift = bits > 31 ? bits - 31 : 0;
    int64_t scaled = shift > 0 ? fxl_round_shift(depth, shift) : depth;
    int64_t high = fxl_multiply_s32(factor, (int32_t)(side >> 32));
    int64_t low = fxl_multiply_su32(factor, (uint32_t)side);
    /* If high is larger than that, the product is above 2^61, while the limit times the
     * depth is below 2^60. */
    if (!fxl_within(high, (int64_t)1 << (29 + shift))) {
        return false;
    }
    int64_t product = high * ((int64_t)1 << (32 - shift)) + (low >> shift);
    if (!fxl_within(product, limit * scaled)) {
        return false;
    }
    *quotient = fxl_divide_round(product, (uint32_t)scaled);
    return true;
}
