/* SPDX-License-Identifier: MIT */
#include "divide_wide.h"

#include "arith.h"
#include "divide.h"

/* A digit of 16 bits of 2^16 rest / whole, rest < whole, 2^31 <= whole < 2^32,
 * with the numerator's next half; *rest becomes what is left (Knuth, algorithm
 * D). The estimate from the upper half of whole is too large by two at most. */
static uint32_t divide_digit(uint32_t *rest, uint32_t whole, uint32_t half)
{
    uint32_t upper = whole >> 16, lower = whole & 0xFFFFu;
    uint32_t digit = fxl_divide_half(*rest, upper);
    uint32_t left = *rest - digit * upper;
    while (left <= 0xFFFFu && (digit > 0xFFFFu || digit * lower > (left << 16 | half))) {
        digit -= 1;
        left += upper;
    }
    /* The true remainder is below 2^32, so what wraps on the way cancels. */
    *rest = (*rest << 16 | half) - digit * whole;
    return digit;
}

uint32_t fxl_divide_u64(uint64_t numerator, uint32_t denominator, uint32_t *rest)
{
    FXL_ASSERT(numerator >> 32 < denominator);
    unsigned shift = fxl_leading_zeros(denominator);
    uint32_t whole = denominator << shift;
    /* Below 2^32 denominator, so nothing is shifted out. */
    uint64_t shifted = numerator << shift;
    uint32_t left = (uint32_t)(shifted >> 32), lower = (uint32_t)shifted;
    uint32_t upper_digit = divide_digit(&left, whole, lower >> 16);
    uint32_t lower_digit = divide_digit(&left, whole, lower & 0xFFFFu);
    *rest = left >> shift;
    return upper_digit << 16 | lower_digit;
}
