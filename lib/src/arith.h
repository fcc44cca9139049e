/* SPDX-License-Identifier: MIT */
/* The integer kernels that every stage shares. Each says why it cannot
 * overflow and what its rounding costs. Not part of the public interface. */
#ifndef FXL_ARITH_H
#define FXL_ARITH_H

#include "fixel/record.h"
#include "leading_zeros.h"
#include "multiply.h"

/* One assertion for our own bugs: a test build lets it abort, a proof takes it
 * as a goal, a shipped build leaves it out. */
#ifdef FXL_ASSERT_HOOK
void fxl_assert_failed(const char *file, int line);
#define FXL_ASSERT(condition) \
    do { \
        if (!(condition)) { \
            fxl_assert_failed(__FILE__, __LINE__); \
        } \
    } while (0)
#else
#define FXL_ASSERT(condition) ((void)0)
#endif

/* Right shifts of negative numbers are arithmetic on every compiler that we
 * build with; the standard leaves it open. */
_Static_assert((-3 >> 1) == -2, "needs arithmetic right shift");

/* floor(value / 2^shift + 1/2), 1 <= shift <= 62. The addition cannot overflow
 * for |value| <= 2^62. Costs half a unit of the result. */
static inline int64_t fxl_round_shift(int64_t value, unsigned shift)
{
    return (value + ((int64_t)1 << (shift - 1))) >> shift;
}

/* floor(numerator / denominator + 1/2), denominator > 0. Costs half a unit.
 * No intermediate is larger than the operands. */
static inline int64_t fxl_divide_round(int64_t numerator, int64_t denominator)
{
    FXL_ASSERT(denominator > 0);
    int64_t quotient = numerator / denominator;
    int64_t remainder = numerator % denominator;
    if (remainder < 0) {
        remainder += denominator;
        quotient -= 1;
    }
    return remainder >= denominator - remainder ? quotient + 1 : quotient;
}

/* floor(numerator / denominator) and what is left, denominator > 0. */
static inline int32_t fxl_divide_floor(int32_t numerator, int32_t denominator, int32_t *remainder)
{
    FXL_ASSERT(denominator > 0);
    int32_t quotient = numerator / denominator;
    int32_t rest = numerator % denominator;
    if (rest < 0) {
        rest += denominator;
        quotient -= 1;
    }
    *remainder = rest;
    return quotient;
}

/* How many bits a number needs; 0 for 0. */
static inline unsigned fxl_bit_length(uint64_t value)
{
    uint32_t high = (uint32_t)(value >> 32);
    uint32_t low = (uint32_t)value;
    if (high != 0) {
        return 64u - fxl_leading_zeros(high);
    }
    return low == 0 ? 0u : 32u - fxl_leading_zeros(low);
}

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

static inline uint64_t fxl_magnitude(int64_t value)
{
    return value < 0 ? (uint64_t)0 - (uint64_t)value : (uint64_t)value;
}

static inline bool fxl_within(int64_t value, int64_t limit)
{
    return value >= -limit && value <= limit;
}

static inline bool fxl_point_in_range(const fxl_point *point)
{
    return fxl_within(point->x, FXL_COORDINATE_MAX) && fxl_within(point->y, FXL_COORDINATE_MAX) &&
           fxl_within(point->z, FXL_COORDINATE_MAX);
}

/* direction . (x, y, z), exact, in units of 2^-46.
 * |x|, |y|, |z| < 2^30 and |direction| <= 1 + 2^-28: by Cauchy-Schwarz the sum
 * is below sqrt(3) * 2^60 * (1 + 2^-28) < 2^61, and so is every partial sum of
 * it: a partial sum is the product with the same vector, some components 0. */
static inline fxl_q18_46 fxl_dot(const fxl_direction *direction, int32_t x, int32_t y, int32_t z)
{
    return fxl_multiply_s32(direction->x, x) + fxl_multiply_s32(direction->y, y) +
           fxl_multiply_s32(direction->z, z);
}

#endif
