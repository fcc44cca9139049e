/* SPDX-License-Identifier: MIT */
/* Products of 32 by 32 bits, all 64 bits, for a core that has only the lower 32 bits of a
 * product: four products of 16 by 16 bits. They give the same results as
 * lib/math/multiply_portable.h. Internal.
 *
 * They are in assembly because the compiler's code is twice as long. Each product fits 32
 * bits: 16 by 16 bits fit 32, also if one or both factors are signed, because
 * 2^15 (2^16 - 1) < 2^31. */
#ifndef FXL_MULTIPLY_H
#define FXL_MULTIPLY_H

#include <stdint.h>

/* low, high, one and other become the four products of the halves of a and b. SHIFT takes
 * the upper halves. The product of a and b is 2^32 high + 2^16 (one + other) + low. */
#define FXL_HALVES(SHIFT, a, b, low, one, other, high) \
    __asm__(".syntax unified\n\tuxth %[l], %[p]\n\t" \
            "uxth %[o], %[q]\n\t" SHIFT " %[p], %[p], #16\n\t" SHIFT " %[q], %[q], #16\n\t" \
            "mov %[t], %[l]\n\t" \
            "muls %[t], %[q]\n\t" \
            "muls %[l], %[o]\n\t" \
            "muls %[o], %[p]\n\t" \
            "muls %[q], %[p]" \
            : [p] "+l"(a), [q] "+l"(b), [l] "=&l"(low), [o] "=&l"(other), [t] "=&l"(one) \
            : \
            : "cc"); \
    (high) = (uint32_t)(b)

/* Adds 2^16 middle to 2^32 high + low. middle is overwritten. */
#define FXL_ADD_MIDDLE(SHIFT, low, high, middle) \
    do { \
        uint32_t fxl_spare; \
        __asm__(".syntax unified\n\tlsls %[s], %[m], #16\n\t" SHIFT " %[m], %[m], #16\n\t" \
                "adds %[l], %[l], %[s]\n\t" \
                "adcs %[h], %[m]" /* bug: m0-middle-carry */ \
                : [l] "+l"(low), [h] "+l"(high), [m] "+l"(middle), [s] "=&l"(fxl_spare) \
                : \
                : "cc"); \
    } while (0)

static inline uint64_t fxl_multiply_u32(uint32_t a, uint32_t b)
{
    uint32_t low, one, other, high;
    FXL_HALVES("lsrs", a, b, low, one, other, high);
    FXL_ADD_MIDDLE("lsrs", low, high, one);
    FXL_ADD_MIDDLE("lsrs", low, high, other);
    return (uint64_t)high << 32 | low;
}

static inline int64_t fxl_multiply_s32(int32_t a, int32_t b)
{
    uint32_t low, one, other, high;
    FXL_HALVES("asrs", a, b, low, one, other, high);
    FXL_ADD_MIDDLE("asrs", low, high, one);
    FXL_ADD_MIDDLE("asrs", low, high, other);
    return (int64_t)((uint64_t)high << 32 | low);
}

/* The same as fxl_multiply_s32, with two instructions less. Requires |a| <= 2^30 + 2^16 and
 * |b| < 2^30: the sum of the two middle products is then below 2 (2^14 + 1) 2^16 and fits
 * 32 bits. */
static inline int64_t fxl_multiply_s31(int32_t a, int32_t b)
{
    uint32_t low, one, other, high;
    FXL_HALVES("asrs", a, b, low, one, other, high);
    one += other;
    FXL_ADD_MIDDLE("asrs", low, high, one);
    return (int64_t)((uint64_t)high << 32 | low);
}

/* The product of a signed and an unsigned number. It is below 2^63. A negative a, converted
 * to unsigned, is larger by 2^32, so 2^32 b is subtracted. */
static inline int64_t fxl_multiply_su32(int32_t a, uint32_t b)
{
    uint64_t wrapped = a < 0 ? (uint64_t)b << 32 : 0;
    return (int64_t)(fxl_multiply_u32((uint32_t)a, b) - wrapped);
}

/* The 64 lowest bits of a product. */
static inline int64_t fxl_multiply_s64(int64_t a, int64_t b)
{
    uint32_t a_low = (uint32_t)a, b_low = (uint32_t)b;
    uint32_t cross = (uint32_t)(a >> 32) * b_low + a_low * (uint32_t)(b >> 32);
    return (int64_t)(fxl_multiply_u32(a_low, b_low) + ((uint64_t)cross << 32));
}

#endif
