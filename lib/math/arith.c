/* SPDX-License-Identifier: MIT */
#define FXL_HERE
#include "arith.h"

#if FXL_HAS_LONG_PRODUCT && !FXL_HAS_LEADING_ZEROS && !FXL_IS_COMPACT

/* clang-format off */
const uint8_t fxl_zeros_of_byte[256] = {
    0, 7, 6, 6, 5, 5, 5, 5, 4, 4, 4, 4, 4, 4, 4, 4, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
/* clang-format on */

#endif

/* A digit of 16 bits: floor((2^16 rest + half) / whole), where half is the numerator's
 * next 16 bits; *rest becomes the remainder (Knuth, algorithm D).
 * Requires rest < whole and 2^31 <= whole < 2^32. The estimate from the upper half of
 * whole is too large by two at most. If it is 2^16 or more, then left < lower, so the test that
 * corrects it sees that too; its product is below 2^32. */
static uint32_t divide_digit(uint32_t *remainder, uint32_t whole, uint32_t half)
{
    uint32_t upper = whole >> 16, lower = whole & 0xFFFFu;
    uint32_t digit = fxl_divide_half(*remainder, upper);
    uint32_t left = *remainder - digit * upper;
    while (left <= 0xFFFFu && digit * lower > (left << 16 | half)) {
        digit -= 1;
        left += upper;
    }
    /* The true remainder is below 2^32, so intermediate wraps cancel. */
    *remainder = (*remainder << 16 | half) - digit * whole;
    return digit;
}

uint32_t fxl_divide_u64(uint64_t numerator, uint32_t denominator, uint32_t *remainder)
{
    FXL_ASSERT(numerator >> 32 < denominator);
    if (FXL_IS_COMPACT && !FXL_IS_SMALL) {
        /* numerator / 2 is below 2^31 denominator, which is below 2^63. Without the last bit of the
         * numerator the quotient is at most one too small. */
        uint32_t quotient =
            (uint32_t)(fxl_fraction(numerator >> 1, (uint64_t)denominator << 31) >> 32);
        uint64_t left = numerator - fxl_multiply_u32(quotient, denominator);
        if (left >= denominator) {
            left -= denominator;
            quotient += 1;
        }
        *remainder = (uint32_t)left;
        return quotient;
    }
    if (numerator >> 32 == 0) {
        return fxl_divide_u32((uint32_t)numerator, denominator, remainder);
    }
    unsigned shift = fxl_leading_zeros(denominator);
    uint32_t whole = denominator << shift;
    /* The numerator is below 2^32 denominator, so no bit is shifted out. */
    uint64_t shifted = numerator << shift;
    uint32_t left = (uint32_t)(shifted >> 32), lower = fxl_low_32(shifted);
    uint32_t upper_digit = divide_digit(&left, whole, lower >> 16);
    uint32_t lower_digit = divide_digit(&left, whole, lower & 0xFFFFu);
    *remainder = left >> shift;
    return upper_digit << 16 | lower_digit;
}

/* A lower bound of 2^60 / value, too small by at most 2^-27 of itself, for
 * 2^30 < value <= 2^31. It starts from a reciprocal r of 16 bits, which is too small by
 * less than 2^-14 of itself: its divisor is rounded up, and the quotient downward. A
 * step of Newton's method, 2 r - r^2 v, squares that relative error. The two units that
 * are subtracted cover the rounding of the step. r is below 2^16. */
static uint32_t reciprocal_below(uint32_t value)
{
    uint32_t rough = fxl_divide_half(0x7FFFFFFFu, ((value - 1u) >> 15) + 1u);
    return (rough << 15) - (uint32_t)(fxl_multiply_u32(rough * rough, value) >> 32) - 2u;
}

/* The next `bits` bits of a fraction, 22 at most: floor(2^bits rest / whole). *rest
 * becomes the remainder. Requires 2^62 <= whole < 2^63 and rest < whole.
 * The estimate is not too large. It is too small by at most
 * 2^22 (2^-27 + 2^-29 + 2^-31), and by 1 for its truncation. So the remainder is below
 * 2 whole, and one correction suffices. */
static uint32_t fraction_digit(uint64_t *remainder, uint64_t whole, uint32_t reciprocal,
                               unsigned bits)
{
    /* rest 2^-31 times 2^92 / whole. */
    uint64_t product = fxl_multiply_u32((uint32_t)(*remainder >> 31), reciprocal);
    uint32_t digit = (uint32_t)(product >> 32) >> (29u - bits);
    /* The true remainder is below 2^64, so intermediate wraps cancel. */
    uint64_t left = (*remainder << bits) - fxl_multiply_u32(digit, fxl_low_32(whole)) -
                    ((uint64_t)(digit * (uint32_t)(whole >> 32)) << 32);
    if (left >= whole) {
        left -= whole;
        digit += 1;
    }
    *remainder = left;
    return digit;
}

uint64_t fxl_fraction(uint64_t part, uint64_t whole)
{
    FXL_ASSERT(part < whole && whole >> 63 == 0);
    unsigned shift = 63u - fxl_bit_length(whole);
    uint64_t remainder = part << shift;
    whole <<= shift;
    uint32_t reciprocal = reciprocal_below((uint32_t)(whole >> 32) + 1u);
    uint64_t upper = fraction_digit(&remainder, whole, reciprocal, 22);
    uint32_t middle = fraction_digit(&remainder, whole, reciprocal, 21);
    uint32_t lower = fraction_digit(&remainder, whole, reciprocal, 21);
    return upper << 42 | (uint64_t)middle << 21 | lower;
}

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
    int64_t low = fxl_multiply_su32(factor, fxl_low_32(fxl_bits_64(side)));
    /* If high is larger than that, the product is above 2^60 in magnitude, also where low takes from
     * it; the limit times the depth is below 2^60. */
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
