/* SPDX-License-Identifier: MIT */
/* The division of an edge's set-up, for a core without division and with products of 32 bits
 * only. lib/raster/edge_divide_portable.h states what each function requires and returns. */
#ifndef FXL_EDGE_DIVIDE_H
#define FXL_EDGE_DIVIDE_H

#include <stdint.h>

#include "../math/core.h"

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

#endif
