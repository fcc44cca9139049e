/* SPDX-License-Identifier: MIT */
/* Whether a normal has unit length, for the checks of a scene. Internal. */
#ifndef FXL_UNIT_VECTOR_H
#define FXL_UNIT_VECTOR_H

#include <stdint.h>

#include "arith.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Whether the squared length is within FXL_NORMAL_SQUARE_MAX_ERROR of 1. Components of at
 * most 2^30 + 2^2 keep every square below 2^61 and the sum below 2^63. */
static inline bool fxl_is_unit(const fxl_direction *normal)
{
    const int64_t limit = (int64_t)FXL_Q2_30_ONE + 4;
    if (!fxl_within(normal->x, limit) || !fxl_within(normal->y, limit) ||
        !fxl_within(normal->z, limit)) {
        return false;
    }
    int64_t square = (int64_t)normal->x * normal->x + (int64_t)normal->y * normal->y +
                     (int64_t)normal->z * normal->z;
    return fxl_within(square - (int64_t)FXL_Q2_30_ONE * FXL_Q2_30_ONE, FXL_NORMAL_SQUARE_MAX_ERROR);
}

/* The integer nearest to sqrt(value), one bit a step. It is below 2^32 for
 * value < 2^64 - 2^32. At the end the remainder is value - root^2, and it is compared with
 * root because (root + 1/2)^2 is root^2 + root + 1/4. */
static inline uint32_t fxl_square_root(uint64_t value)
{
    uint64_t root = 0;
    for (uint64_t bit = (uint64_t)1 << 62; bit != 0; bit >>= 2) {
        if (value >= root + bit) {
            value -= root + bit;
            root = (root >> 1) + bit;
        } else {
            root >>= 1;
        }
    }
    return (uint32_t)(value > root ? root + 1 : root);
}

#ifdef __cplusplus
}
#endif

#endif
