/* SPDX-License-Identifier: MIT */
/* Products of 32 by 32 bits, whole, on a core that keeps the lower 32 bits of a
 * product: four products of 16 by 16. The same bits as portable. Internal. */
#ifndef FXL_MULTIPLY_H
#define FXL_MULTIPLY_H

#include <stdint.h>

/* 2^32 high + 2^16 (one + other) + low. A product of 16 by 16 bits fits 32, of
 * signed and unsigned as well: 2^15 (2^16 - 1) < 2^31. */
static inline uint64_t fxl_multiply_u32(uint32_t a, uint32_t b)
{
    uint32_t a_low = (uint16_t)a, a_high = a >> 16;
    uint32_t b_low = (uint16_t)b, b_high = b >> 16;
    uint64_t outer = (uint64_t)(a_high * b_high) << 32 | a_low * b_low;
    return outer + ((uint64_t)(a_low * b_high) << 16) + ((uint64_t)(a_high * b_low) << 16);
}

static inline int64_t fxl_multiply_s32(int32_t a, int32_t b)
{
    int32_t a_low = (uint16_t)a, a_high = a >> 16;
    int32_t b_low = (uint16_t)b, b_high = b >> 16;
    uint64_t outer =
        (uint64_t)(uint32_t)(a_high * b_high) << 32 | (uint32_t)a_low * (uint32_t)b_low;
    uint64_t one = (uint64_t)(int64_t)(a_low * b_high) << 16;
    uint64_t other = (uint64_t)(int64_t)(a_high * b_low) << 16;
    return (int64_t)(outer + one + other);
}

/* The 64 lowest bits of a product. */
static inline int64_t fxl_multiply_s64(int64_t a, int64_t b)
{
    uint32_t a_low = (uint32_t)a, b_low = (uint32_t)b;
    uint32_t cross = (uint32_t)(a >> 32) * b_low + a_low * (uint32_t)(b >> 32);
    return (int64_t)(fxl_multiply_u32(a_low, b_low) + ((uint64_t)cross << 32));
}

#endif
