/* SPDX-License-Identifier: MIT */
/* The division of an edge's set-up: the inline kernel for what this core has. The first text states
 * what each function requires and returns; all give the same bits. Internal. */
#ifndef FXL_EDGE_DIVIDE_H
#define FXL_EDGE_DIVIDE_H

#include <stdint.h>

#include "../math/core.h"
#include "../math/family.h"
#include "../math/pixel_centre.h"

#ifdef __cplusplus
extern "C" {
#endif

#if FXL_HAS_LONG_DIVIDER

/* The largest divisor, and the largest magnitude of a dividend. */
#define FXL_EDGE_HEIGHT_MAX   ((1 << 26) - 1)
#define FXL_EDGE_DIVIDEND_MAX ((1 << 27) + (1 << 17))

/* place fill-rule: the first column of an edge in a row */
/* A height as a divisor. */
typedef struct {
    uint32_t height;
} fxl_edge_divider;

/* Requires 1 <= height <= FXL_EDGE_HEIGHT_MAX. */
static inline fxl_edge_divider fxl_edge_divider_of(uint32_t height)
{
    fxl_edge_divider divider = {height};
    return divider;
}

/* The largest shift such that 2^shift is below 2^32 / height. So it is at least
 * 2^32 / (2 height). */
static inline unsigned fxl_edge_divider_shift(const fxl_edge_divider *divider)
{
    unsigned shift = 0;
    while ((uint64_t)divider->height << (shift + 1) <= UINT32_MAX) {
        shift += 1;
    }
    return shift;
}

/* floor(2^32 dividend / height) + 1, as whole and fraction. It is larger than the exact
 * quotient by at most 2^-32. Requires |dividend| <= FXL_EDGE_DIVIDEND_MAX, so 2^32 times
 * the dividend is below 2^60. */
static inline void fxl_edge_divide(const fxl_edge_divider *divider, int32_t dividend,
                                   int32_t *whole, uint32_t *fraction)
{
    int64_t height = divider->height;
    int64_t numerator = (int64_t)dividend * ((int64_t)1 << 32);
    int64_t quotient = numerator / height;
    FXL_LEMMA(FXL_BELOW(quotient, (int64_t)1 << 60));
    if (numerator % height >= 0) {
        quotient += 1;
    }
    *whole = (int32_t)(quotient >> 32);
    *fraction = fxl_low_32(fxl_bits_64(quotient));
}

#elif !FXL_HAS_LONG_PRODUCT || !FXL_HAS_DIVIDER

/* Without division, and with products of 32 bits only. */

#define FXL_EDGE_HEIGHT_MAX   ((1 << 26) - 1)
#define FXL_EDGE_DIVIDEND_MAX ((1 << 27) + (1 << 17))

typedef struct {
    uint32_t height;
    uint32_t reciprocal; /* 2^(47 - shift) / height; error 2^-14 of it at most (all were tried) */
    unsigned shift;      /* 2^31 <= height 2^shift < 2^32 */
} fxl_edge_divider;

/* 2^15 / (i + 1/2), rounded, for i = 128..255. */
static const uint8_t fxl_edge_reciprocals[128] = {
    255, 253, 251, 249, 247, 245, 244, 242, 240, 238, 237, 235, 233, 232, 230, 228, 227, 225, 224,
    222, 221, 219, 218, 216, 215, 213, 212, 211, 209, 208, 207, 205, 204, 203, 202, 200, 199, 198,
    197, 196, 194, 193, 192, 191, 190, 189, 188, 187, 186, 185, 184, 183, 182, 181, 180, 179, 178,
    177, 176, 175, 174, 173, 172, 171, 170, 169, 168, 168, 167, 166, 165, 164, 163, 163, 162, 161,
    160, 159, 159, 158, 157, 156, 156, 155, 154, 153, 153, 152, 151, 151, 150, 149, 149, 148, 147,
    147, 146, 145, 145, 144, 143, 143, 142, 142, 141, 140, 140, 139, 139, 138, 137, 137, 136, 136,
    135, 135, 134, 133, 133, 132, 132, 131, 131, 130, 130, 129, 129, 128,
};

/* The table gives eight bits of the reciprocal; one step of Newton's method gives fifteen.
 * With top = height 2^shift / 2^16 and rough about 2^31 / top, the relative error of rough
 * is below 2^-7.4. So (2^31 - top rough) / 2^9 is below 2^14.6, and its product with
 * rough < 2^16 is below 2^31. */
static inline fxl_edge_divider fxl_edge_divider_of(uint32_t height)
{
    fxl_edge_divider divider;
    divider.height = height;
    divider.shift = fxl_leading_zeros(height);
    uint32_t top = (height << divider.shift) >> 16;
    int32_t rough = fxl_edge_reciprocals[(top >> 8) - 128] << 8;
    int32_t error = (int32_t)(0x80000000u - top * (uint32_t)rough);
    divider.reciprocal = (uint32_t)(rough + ((rough * (error >> 9)) >> 22));
    return divider;
}

static inline unsigned fxl_edge_divider_shift(const fxl_edge_divider *divider)
{
    return divider->shift;
}

/* The next 16 bits of a quotient whose remainder is *left < height; *left becomes the new
 * remainder. The estimate is off by a few units (every divider was tried). So the magnitude
 * of the rest that it leaves is below 2^31, and the lower 32 bits hold all of the rest. */
static inline uint32_t fxl_edge_digit(const fxl_edge_divider *divider, uint32_t *left)
{
    uint32_t top = (*left << divider->shift) >> 16;
    uint32_t digit = (top * divider->reciprocal) >> 15;
    int32_t rest = (int32_t)((*left << 16) - digit * divider->height);
    while (rest < 0) {
        rest += (int32_t)divider->height;
        digit -= 1;
    }
    while (rest >= (int32_t)divider->height) {
        rest -= (int32_t)divider->height;
        digit += 1;
    }
    *left = (uint32_t)rest;
    return digit;
}

/* floor(*magnitude / height); *magnitude becomes the remainder. From a height of 2^13 on the
 * estimate is off by a few units. Lower edges that cross a row are rare. */
static inline uint32_t fxl_edge_whole(const fxl_edge_divider *divider, uint32_t *magnitude)
{
    uint32_t height = divider->height;
    if (*magnitude < height) {
        return 0;
    }
    if (height < 8192) {
        return fxl_divide_u32(*magnitude, height, magnitude);
    }
    uint32_t quotient = ((*magnitude >> 12) * divider->reciprocal) >> (35 - divider->shift);
    int32_t rest = (int32_t)(*magnitude - quotient * height);
    while (rest < 0) {
        rest += (int32_t)height;
        quotient -= 1;
    }
    while (rest >= (int32_t)height) {
        rest -= (int32_t)height;
        quotient += 1;
    }
    *magnitude = (uint32_t)rest;
    return quotient;
}

static inline void fxl_edge_divide(const fxl_edge_divider *divider, int32_t dividend,
                                   int32_t *whole, uint32_t *fraction)
{
    uint32_t left = dividend < 0 ? 0u - (uint32_t)dividend : (uint32_t)dividend;
    int32_t quotient = (int32_t)fxl_edge_whole(divider, &left);
    if (dividend < 0) {
        quotient = -quotient;
        if (left != 0) {
            quotient -= 1;
            left = divider->height - left;
        }
    }
    uint32_t high = fxl_edge_digit(divider, &left);
    uint32_t low = fxl_edge_digit(divider, &left);
    uint32_t sum = (high << 16 | low) + 1;
    *whole = quotient + (sum == 0);
    *fraction = sum;
}

#else

/* With long products and a division of 32 bits. */

#define FXL_EDGE_HEIGHT_MAX   ((1 << 26) - 1)
#define FXL_EDGE_DIVIDEND_MAX ((1 << 27) + (1 << 17))

typedef struct {
    uint32_t height;
    uint32_t half;      /* height 2^(shift - 1): 2^31 <= 2 half < 2^32 */
    int32_t reciprocal; /* 2^62 / (2 half); error -2^-29.38 to 2^-30.9 of it (all upper halves
                           were tried) */
    unsigned shift;
} fxl_edge_divider;

/* One division of 32 bits gives the upper 16 bits of the reciprocal, and one step of Newton's
 * method gives the rest. The numerator is reduced so that the error of the division is
 * centred about 0. rough 2 half is about 2^63, and rough (2^64 - rough 2 half) / 2^64 is
 * about 2^62 / (2 half). */
static inline fxl_edge_divider fxl_edge_divider_of(uint32_t height)
{
    fxl_edge_divider divider;
    divider.height = height;
    divider.shift = fxl_leading_zeros(height);
    uint32_t scaled = height << divider.shift;
    uint32_t rough = (0xFFFF7FFFu / (scaled >> 16)) << 15;
    uint32_t product = (uint32_t)(((uint64_t)rough * scaled) >> 32);
    divider.reciprocal = (int32_t)(((uint64_t)rough * (0u - product)) >> 32);
    divider.half = scaled >> 1;
    return divider;
}

static inline unsigned fxl_edge_divider_shift(const fxl_edge_divider *divider)
{
    return divider->shift;
}

/* The estimate is dividend 2^62 / (height 2^shift), shifted right by 30 - shift. Its error is
 * at most |dividend| 2^(32 - 29.38) / height + 1. The magnitude of the rest that it leaves
 * is below 2^29.63 + 2^26 < 2^30, so the lower 32 bits hold all of the rest. half, which is
 * height 2^(shift - 1) and 2^30 <= half < 2^31, is added to the rest, which then is not
 * negative, and one division finds the correction. The dividend is multiplied by 4 before
 * the product, because it has two spare bits. So the shift right is by at least 1. */
static inline void fxl_edge_divide(const fxl_edge_divider *divider, int32_t dividend,
                                   int32_t *whole, uint32_t *fraction)
{
    int64_t product = (int64_t)(dividend * 4) * divider->reciprocal;
    int32_t high = (int32_t)(product >> 32);
    unsigned shift = divider->shift, rest_shift = 32 - shift;
    uint32_t estimate = fxl_bits_32(high) << shift | fxl_low_32(fxl_bits_64(product)) >> rest_shift;
    uint32_t left = divider->half - estimate * divider->height;
    int32_t more = (int32_t)(left / divider->height) - (int32_t)((1u << shift) >> 1) + 1;
    uint32_t sum = estimate + fxl_bits_32(more);
    *whole = (high >> rest_shift) + (more >> 31) + (sum < estimate);
    *fraction = sum;
}

#endif

/* The dividend for the first pixel of an edge on a row whose centre is t below the edge's top; the
 * divisor is the height.
 *
 * The edge's x there is top.x + dx t / height, and the first pixel is ceil(x - 1/2). With
 * start = top.x - 1/2 = 65536 whole + part (0 <= part < 65536) that is
 *   whole + ceil((part height + dx t) / (65536 height)).
 * Now ceil(n / m) = floor((n - 1) / m) + 1, and the floor of a floor divided by an integer
 * is the floor of the whole quotient. height, |dx|, t < 2^29 and part < 2^16, so the sum is
 * below 2^59 and, without its low 16 bits, below 2^43. On the edge's first row t < 2^16, so
 * there it is below 2^30. Exact. */
static inline int64_t fxl_edge_dividend(int32_t start, int32_t dx, int32_t height, int32_t t)
    FXL_REQUIRES(FXL_BELOW(dx, 1 << 29) && height > 0 && height <= 1 << 29 && t >= 0 && t < height)
    FXL_ASSIGNS() FXL_ENSURES(FXL_BELOW(FXL_RESULT, (int64_t)1 << 43))
    FXL_EQUATES(FXL_BELOW(FXL_RESULT, (int64_t)height << 14))
{
    uint32_t part = fxl_bits_32(start) & 65535;
    int64_t sum = (int64_t)fxl_multiply_u32(part, (uint32_t)height) + fxl_multiply_s32(dx, t);
    return (sum - 1) >> 16;
}

/* The same on the first row, whose centre is at or below the top. Requires height <=
 * FXL_EDGE_HEIGHT_MAX and |dx| of at most 1025 pixels. */
#if FXL_HAS_LONG_PRODUCT

static inline int32_t fxl_edge_first_dividend(int32_t start, int32_t dx, int32_t height,
                                              int32_t top_y)
{
    const int32_t t = (int32_t)(fxl_bits_32(FXL_HALF_PIXEL - top_y) & 65535u);
    return (int32_t)fxl_edge_dividend(start, dx, height, t);
}

#else

/* part and t are below 2^16, so products of 16 bits suffice: with height = 2^16 h + h' and
 * dx = 2^16 d + d' the sum of fxl_edge_dividend is 2^16 (part h + t d) + part h' + t d'. The bracket
 * is below 2^28 in magnitude. */
static inline int32_t fxl_edge_first_dividend(int32_t start, int32_t dx, int32_t height,
                                              int32_t top_y)
{
    const uint32_t part = fxl_bits_32(start) & 65535u,
                   t = fxl_bits_32(FXL_HALF_PIXEL - top_y) & 65535u;
    const uint32_t a = part * ((uint32_t)height & 65535u), b = t * (fxl_bits_32(dx) & 65535u);
    const int32_t low = (int32_t)((a & 65535u) + (b & 65535u)) - 1;
    const int32_t high = (int32_t)(part * ((uint32_t)height >> 16)) + (int32_t)t * (dx >> 16);
    return high + (int32_t)(a >> 16) + (int32_t)(b >> 16) + (low >> 16);
}

#endif

#ifdef __cplusplus
}
#endif

#endif
