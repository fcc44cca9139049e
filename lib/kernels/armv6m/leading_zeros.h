/* SPDX-License-Identifier: MIT */
/* For a core without CLZ. Internal. */
#ifndef FXL_LEADING_ZEROS_H
#define FXL_LEADING_ZEROS_H

#include <stdint.h>

/* How many bits of value, not 0, are 0 before its highest 1: halves the bits in
 * question, then looks four of them up. */
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
    /* 4 bits each for 0..15, 0 not asked for: 3 2 2 1 1 1 1 and 0 from 8 on. */
    return zeros + (value >> 31 != 0 ? 0u : (0x11112230u >> (value >> 28) * 4u & 15u));
}

#endif
