/* SPDX-License-Identifier: MIT */
/* Products and divisions of 32 bits, and the count of leading zeros. Internal; of a core that has other
 * ones, there is another file, which gives the same results. */
#ifndef FXL_CORE_ARITHMETIC_H
#define FXL_CORE_ARITHMETIC_H

#include <stdint.h>

static inline uint64_t fxl_multiply_u32(uint32_t a, uint32_t b)
{
    return (uint64_t)a * b;
}

static inline int64_t fxl_multiply_s32(int32_t a, int32_t b)
{
    return (int64_t)a * b;
}

/* The same as fxl_multiply_s32; on some cores it is cheaper. Requires |a| <= 2^30 + 2^16 and
 * |b| < 2^30. */
static inline int64_t fxl_multiply_s31(int32_t a, int32_t b)
{
    return (int64_t)a * b;
}

/* The product of a signed and an unsigned number. It is below 2^63. */
static inline int64_t fxl_multiply_su32(int32_t a, uint32_t b)
{
    return (int64_t)a * b;
}

/* The 64 lowest bits of a product. */
static inline int64_t fxl_multiply_s64(int64_t a, int64_t b)
{
    return (int64_t)((uint64_t)a * (uint64_t)b);
}

/* floor(numerator / denominator); *rest becomes the remainder. Requires denominator > 0. */
static inline uint32_t fxl_divide_u32(uint32_t numerator, uint32_t denominator, uint32_t *rest)
{
    uint32_t quotient = numerator / denominator;
    *rest = numerator - quotient * denominator;
    return quotient;
}

/* floor(numerator / denominator). Requires 2^15 <= denominator <= 2^16. */
static inline uint32_t fxl_divide_half(uint32_t numerator, uint32_t denominator)
{
    return numerator / denominator;
}

/* The number of 0 bits above the highest 1 of value. Requires value > 0. */
static inline unsigned fxl_leading_zeros(uint32_t value)
{
    return (unsigned)__builtin_clz(value);
}

#endif
