/* SPDX-License-Identifier: MIT */
/* Products of 32 by 32 bits, all 64 bits. Internal; each family of cores has its own file. */
#ifndef FXL_MULTIPLY_H
#define FXL_MULTIPLY_H

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

#endif
