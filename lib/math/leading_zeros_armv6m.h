/* SPDX-License-Identifier: MIT */
/* The count of leading zeros, for a core without CLZ. Internal. */
#ifndef FXL_LEADING_ZEROS_H
#define FXL_LEADING_ZEROS_H

#include <stdint.h>

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
