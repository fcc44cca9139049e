/* SPDX-License-Identifier: MIT */
/* Two digits of 32 bits, each by one reciprocal of the whole instead of a division
 * (Moeller and Granlund, Improved division by invariant integers, 2011: the
 * reciprocal of two words, and three words by two). B is 2^32. */
#include "fraction.h"

#include "arith.h"

/* The next 16 bits of the quotient of a number by divisor: of (*rest B / 2^16 +
 * 2^16 - 1) / divisor, *rest < divisor, 2^31 <= divisor. *rest becomes what is left.
 * The estimate by the divisor's upper half is too large by two at most (Knuth,
 * algorithm D); what wraps on the way cancels. */
static uint32_t divide_half(uint32_t *rest, uint32_t divisor)
{
    uint32_t quotient = *rest / (divisor >> 16);
    uint32_t left = (*rest - quotient * (divisor >> 16)) << 16 | 0xFFFFu;
    uint32_t taken = quotient * (divisor & 0xFFFFu);
    while (left < taken) {
        quotient -= 1;
        left += divisor;
        if (left < divisor) {
            break;
        }
    }
    *rest = left - taken;
    return quotient;
}

/* floor((B^2 - 1) / divisor) - B, 2^31 <= divisor. The numerator less B divisor
 * is (B - 1 - divisor) B + B - 1. */
static uint32_t reciprocal(uint32_t divisor)
{
    uint32_t rest = ~divisor;
    uint32_t upper = divide_half(&rest, divisor);
    return (upper << 16) + divide_half(&rest, divisor);
}

/* floor((B^3 - 1) / divisor) - B, 2^63 <= divisor: that of the upper word, less
 * what the lower takes. */
static uint32_t reciprocal_of_two(uint64_t divisor)
{
    uint32_t high = (uint32_t)(divisor >> 32), low = (uint32_t)divisor;
    uint32_t inverse = reciprocal(high);
    uint32_t left = high * inverse + low;
    if (left < low) {
        inverse -= 1;
        if (left >= high) {
            inverse -= 1;
            left -= high;
        }
        left -= high;
    }
    uint64_t product = fxl_multiply_u32(inverse, low);
    uint32_t carried = (uint32_t)(product >> 32);
    left += carried;
    if (left < carried) {
        inverse -= 1;
        if (((uint64_t)left << 32 | (uint32_t)product) >= divisor) {
            inverse -= 1;
        }
    }
    return inverse;
}

/* floor(B *rest / divisor), *rest < divisor; *rest becomes what is left. All sums
 * are those of the paper, modulo B^2; the quotient is corrected twice at most. */
static uint32_t divide_digit(uint64_t *rest, uint64_t divisor, uint32_t inverse)
{
    uint64_t estimate = fxl_multiply_u32((uint32_t)(*rest >> 32), inverse) + *rest;
    uint32_t quotient = (uint32_t)(estimate >> 32);
    uint64_t taken = (uint64_t)fxl_multiply_s64(quotient, (int64_t)divisor);
    uint64_t left = (*rest << 32) - taken - divisor;
    quotient += 1;
    if ((uint32_t)(left >> 32) >= (uint32_t)estimate) {
        quotient -= 1;
        left += divisor;
    }
    if (left >= divisor) {
        quotient += 1;
        left -= divisor;
    }
    *rest = left;
    return quotient;
}

uint64_t fxl_fraction(uint64_t part, uint64_t whole)
{
    FXL_ASSERT(part < whole && whole >> 63 == 0);
    unsigned shift = 64u - fxl_bit_length(whole);
    uint64_t rest = part << shift;
    uint64_t divisor = whole << shift;
    uint32_t inverse = reciprocal_of_two(divisor);
    uint32_t upper = divide_digit(&rest, divisor, inverse);
    return (uint64_t)upper << 32 | divide_digit(&rest, divisor, inverse);
}
