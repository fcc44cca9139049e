/* SPDX-License-Identifier: MIT */
/* Divisions of 32 bits for a core without UDIV. They give the same results as
 * lib/math/divide_portable.h. Internal. */
#ifndef FXL_DIVIDE_H
#define FXL_DIVIDE_H

#include <stdint.h>

/* floor(numerator / denominator); *rest becomes the remainder. Requires denominator > 0. It
 * takes a step for each bit of the quotient; the quotients of an edge's slope have few. */
static inline uint32_t fxl_divide_u32(uint32_t numerator, uint32_t denominator, uint32_t *rest)
{
    uint32_t quotient = 0, bit = 1;
    while (denominator <= numerator >> 1) {
        denominator <<= 1;
        bit <<= 1;
    }
    do {
        if (numerator >= denominator) {
            numerator -= denominator;
            quotient |= bit;
        }
        denominator >>= 1;
        bit >>= 1;
    } while (bit != 0);
    *rest = numerator;
    return quotient;
}

/* Entry i is 2^23 / (2^15 + 2^9 i + 2^8), rounded: a reciprocal of 7 bits. */
static const uint8_t fxl_reciprocals[65] = {
    254, 250, 246, 243, 239, 236, 232, 229, 226, 223, 220, 217, 214, 211, 209, 206, 204,
    201, 199, 196, 194, 192, 189, 187, 185, 183, 181, 179, 177, 175, 173, 172, 170, 168,
    166, 165, 163, 161, 160, 158, 157, 155, 154, 152, 151, 150, 148, 147, 146, 144, 143,
    142, 141, 139, 138, 137, 136, 135, 134, 133, 132, 131, 130, 129, 128};

/* 2^31 / value for 2^15 <= value <= 2^16, within 3 units (every value was tried). It starts
 * from the table; two steps of Newton's method, 2 r - r^2 v, square the relative error
 * each. 254^2 2^16 < 2^32. After the first step 2^31 - r v is below 2^18, so its product
 * with r / 16 is below 2^30. */
static inline uint32_t fxl_reciprocal_half(uint32_t value)
{
    uint32_t rough = fxl_reciprocals[(value >> 9) - 64u];
    rough = (rough << 9) - (rough * rough * value >> 15);
    int32_t error = (int32_t)(0x80000000u - rough * value);
    return rough + (uint32_t)((int32_t)rough * (error >> 4) >> 27);
}

/* floor(numerator / denominator) for 2^15 <= denominator <= 2^16. The upper half of the
 * numerator times the reciprocal gives the quotient to within 12. The rest, which includes
 * the lower half, times the reciprocal gives the correction to within 1. */
static inline uint32_t fxl_divide_half(uint32_t numerator, uint32_t denominator)
{
    uint32_t reciprocal = fxl_reciprocal_half(denominator);
    uint32_t quotient = (numerator >> 16) * reciprocal >> 15;
    int32_t rest = (int32_t)(numerator - quotient * denominator);
    int32_t more = rest >> 4;
    more = more * (int32_t)(reciprocal >> 4) >> 23;
    quotient += (uint32_t)more;
    rest -= more * (int32_t)denominator;
    while (rest < 0) {
        rest += (int32_t)denominator;
        quotient -= 1;
    }
    while (rest >= (int32_t)denominator) { /* bug: m0-estimate */
        rest -= (int32_t)denominator;
        quotient += 1;
    }
    return quotient;
}

#endif
