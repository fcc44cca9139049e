/* SPDX-License-Identifier: MIT */
/* The division of an edge's set-up. Internal. Each family of cores has its own file; all
 * give the same bits as this one. */
#ifndef FXL_EDGE_DIVIDE_H
#define FXL_EDGE_DIVIDE_H

#include <stdint.h>

/* The largest divisor, and the largest magnitude of a dividend. */
#define FXL_EDGE_HEIGHT_MAX   ((1 << 26) - 1)
#define FXL_EDGE_DIVIDEND_MAX ((1 << 27) + (1 << 17))

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

/* The largest shift such that 2^shift is not above 2^32 / height. So it is above
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
    if (numerator % height >= 0) {
        quotient += 1;
    }
    *whole = (int32_t)(quotient >> 32);
    *fraction = (uint32_t)quotient;
}

#endif
