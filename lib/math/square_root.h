/* SPDX-License-Identifier: MIT */
/* A square root, for set-up that is done once. Internal. */
#ifndef FXL_SQUARE_ROOT_H
#define FXL_SQUARE_ROOT_H

#include <stdint.h>

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

#endif
