/* SPDX-License-Identifier: MIT */
/* The arithmetic of this core's family, inline, and what every family makes of it: products and
 * divisions of 32 bits, and the count of leading zeros. All families give the same results.
 * Internal. */
#ifndef FXL_CORE_H
#define FXL_CORE_H

#include <stdint.h>

#include "contract.h"
#include "family.h"

/* On a core of 32 bits:
 * FXL_HIDE hides from the compiler what it knows of a word, where it makes worse code of it: three
 * instructions for a mask that is at hand in a register, or a product of 64 by 64 bits for one of
 * 32 by 32 whose signs it knows, or a sum for an address beside another one.
 * FXL_IN_ORDER keeps it from loading what comes after before what comes before is stored: with all
 * at once it would save registers that their parts do not need. */
#if !FXL_HAS_LONG_DIVIDER
#define FXL_HIDE(word) __asm__("" : "+r"(word))
#else
#define FXL_HIDE(word) (void)(word)
#endif
#if !FXL_HAS_LONG_DIVIDER && !FXL_CORE_ARMV7M /* which stores several at once */
#define FXL_IN_ORDER() __asm__("" ::: "memory")
#else
#define FXL_IN_ORDER() (void)0
#endif

/* Conversions that are meant to change a value: `make prove` demands of all others that they do not.
 * The lowest bits of a number, and the number of the same bits that has a sign or has none. */
#ifdef FXL_PROVE
#pragma CPROVER check push
#pragma CPROVER check disable "conversion"
#endif

static inline uint8_t fxl_low_8(uint32_t value)
{
    return (uint8_t)value;
}

static inline uint16_t fxl_low_16(uint32_t value)
{
    return (uint16_t)value;
}

static inline uint32_t fxl_low_32(uint64_t value)
{
    return (uint32_t)value;
}

static inline uint32_t fxl_bits_32(int32_t value)
{
    return (uint32_t)value;
}

static inline uint64_t fxl_bits_64(int64_t value)
{
    return (uint64_t)value;
}

static inline int32_t fxl_signed_32(uint32_t bits)
{
    return (int32_t)bits;
}

static inline int64_t fxl_signed_64(uint64_t bits)
{
    return (int64_t)bits;
}

#ifdef FXL_PROVE
#pragma CPROVER check pop
#endif

#if !FXL_CORE_ARMV6M

static inline uint64_t fxl_multiply_u32(uint32_t a, uint32_t b)
{
    return (uint64_t)a * b;
}

static inline int64_t fxl_multiply_s32(int32_t a, int32_t b)
{
    FXL_HIDE(a);
    FXL_HIDE(b);
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

#ifdef FXL_PROVE
#pragma CPROVER check push
#pragma CPROVER check disable "conversion"
#endif

/* The 64 lowest bits of a product. */
static inline int64_t fxl_multiply_s64(int64_t a, int64_t b)
{
    return (int64_t)((uint64_t)a * (uint64_t)b);
}

/* The same. Requires b < 2^16. */
static inline int64_t fxl_multiply_s64_u16(int64_t a, uint32_t b)
{
    return (int64_t)((uint64_t)a * b);
}

#ifdef FXL_PROVE
#pragma CPROVER check pop
#endif

#else

/* Without long products. They are four of 16 by 16 bits. They are in
 * assembly because the compiler's code is twice as long. Each fits 32 bits, also if one or both
 * factors are signed, because 2^15 (2^16 - 1) < 2^31. */

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
                "adcs %[h], %[m]" \
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

/* The same. Requires b < 2^16. The middle sum is at most (2^16 - 1)^2 + 2^16 - 1: below 2^32. */
static inline int64_t fxl_multiply_s64_u16(int64_t a, uint32_t b)
{
    const uint32_t low = (uint32_t)a, lowest = (low & 0xFFFFu) * b;
    const uint32_t middle = (low >> 16) * b + (lowest >> 16);
    const uint32_t high = (uint32_t)(a >> 32) * b + (middle >> 16);
    return (int64_t)((uint64_t)high << 32 | (middle << 16 | (lowest & 0xFFFFu)));
}

#endif

#if FXL_HAS_DIVIDER

/* floor(numerator / denominator); *rest becomes the remainder. Requires denominator > 0. */
static inline uint32_t fxl_divide_u32(uint32_t numerator, uint32_t denominator, uint32_t *remainder)
    FXL_REQUIRES(denominator > 0 && FXL_OBJECT(remainder)) FXL_ASSIGNS(*remainder)
    FXL_EQUATES(*remainder < denominator && *remainder <= numerator && FXL_RESULT <= numerator)
{
    uint32_t quotient = numerator / denominator;
    *remainder = numerator - quotient * denominator;
    return quotient;
}

/* floor(numerator / denominator). Requires 2^15 <= denominator <= 2^16. */
static inline uint32_t fxl_divide_half(uint32_t numerator, uint32_t denominator)
{
    return numerator / denominator;
}

#else

/* floor(numerator / denominator); *rest becomes the remainder. Requires denominator > 0. It
 * takes a step for each bit of the quotient; the quotients of an edge's slope have few. */
static inline uint32_t fxl_divide_u32(uint32_t numerator, uint32_t denominator, uint32_t *remainder)
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
    *remainder = numerator;
    return quotient;
}

/* Entry i is 2^23 / (2^15 + 2^9 i + 2^8), rounded: a reciprocal of 7 bits. Kernels have it too. */
#if FXL_KERNELS_ARMV6M
#ifdef __cplusplus
extern "C"
#else
extern
#endif
    const uint8_t fxl_reciprocals_armv6m[65];
#define fxl_reciprocals fxl_reciprocals_armv6m
#else
static const uint8_t fxl_reciprocals[65] = {
    254, 250, 246, 243, 239, 236, 232, 229, 226, 223, 220, 217, 214, 211, 209, 206, 204,
    201, 199, 196, 194, 192, 189, 187, 185, 183, 181, 179, 177, 175, 173, 172, 170, 168,
    166, 165, 163, 161, 160, 158, 157, 155, 154, 152, 151, 150, 148, 147, 146, 144, 143,
    142, 141, 139, 138, 137, 136, 135, 134, 133, 132, 131, 130, 129, 128};
#endif

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
    int32_t remainder = (int32_t)(numerator - quotient * denominator);
    int32_t more = remainder >> 4;
    more = more * (int32_t)(reciprocal >> 4) >> 23;
    quotient += (uint32_t)more;
    remainder -= more * (int32_t)denominator;
    while (remainder < 0) {
        remainder += (int32_t)denominator;
        quotient -= 1;
    }
    while (remainder >= (int32_t)denominator) {
        remainder -= (int32_t)denominator;
        quotient += 1;
    }
    return quotient;
}

#endif

#if FXL_HAS_LEADING_ZEROS

/* The number of 0 bits above the highest 1 of value. Requires value > 0. */
static inline unsigned fxl_leading_zeros(uint32_t value)
{
    return (unsigned)__builtin_clz(value);
}

#elif FXL_HAS_LONG_PRODUCT && !FXL_IS_COMPACT

/* Of each byte but 0. */
extern const uint8_t fxl_zeros_of_byte[256];

/* The number of 0 bits above the highest 1 of value. Requires value > 0. */
static inline unsigned fxl_leading_zeros(uint32_t value)
{
    if (value >> 16 != 0) {
        return value >> 24 != 0 ? fxl_zeros_of_byte[value >> 24]
                                : 8u + fxl_zeros_of_byte[value >> 16];
    }
    return value >> 8 != 0 ? 16u + fxl_zeros_of_byte[value >> 8] : 24u + fxl_zeros_of_byte[value];
}

#else

/* The number of 0 bits above the highest 1 of value. Requires value > 0. It halves the range of
 * bits three times, then looks up four of them. */
static inline unsigned fxl_leading_zeros(uint32_t value)
{
    unsigned zeros = 0;
    if (value >> 16 == 0) {
        zeros += 16;
        value <<= 16;
    }
    if (value >> 24 == 0) {
        zeros += 8;
        value <<= 8;
    }
    if (value >> 28 == 0) {
        zeros += 4;
        value <<= 4;
    }
    /* The table has 4 bits for each of 1..7: 3 2 2 1 1 1 1. The result is 0 from 8 on; the
     * entry for 0 is not used. */
    return zeros + (value >> 31 != 0 ? 0u : (0x11112230u >> (value >> 28) * 4u & 15u));
}

#endif

/* floor(a * b / 2^64), from four products of 32 bits. Each middle sum is at
 * most (2^32 - 1)^2 + 2 (2^32 - 1) = 2^64 - 1. */
static inline uint64_t fxl_multiply_high(uint64_t a, uint64_t b) FXL_REQUIRES(1) FXL_ASSIGNS()
    FXL_EQUATES(FXL_RESULT <= a && FXL_RESULT <= b)
{
    uint32_t a_high = (uint32_t)(a >> 32), a_low = fxl_low_32(a);
    uint32_t b_high = (uint32_t)(b >> 32), b_low = fxl_low_32(b);
    uint64_t middle = fxl_multiply_u32(a_high, b_low) + (fxl_multiply_u32(a_low, b_low) >> 32);
    uint64_t other = fxl_multiply_u32(a_low, b_high) + fxl_low_32(middle);
    return fxl_multiply_u32(a_high, b_high) + (middle >> 32) + (other >> 32);
}

#endif
