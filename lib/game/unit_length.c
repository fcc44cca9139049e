/* SPDX-License-Identifier: MIT */
#include "unit_length.h"

#include "../math/arith.h"
#include "../math/square_root.h"

/* Shifted so that the largest component has 31 bits. Rounding a longer one may make it 2^31. */
static uint32_t scaled(uint64_t magnitude, int shift)
{
    return (uint32_t)(shift > 0 ? (uint64_t)fxl_round_shift((int64_t)magnitude, (unsigned)shift)
                                : magnitude << -shift);
}

bool fxl_unit_length(const int64_t vector[3], int64_t unit[3])
{
    const uint64_t magnitudes[3] = {fxl_magnitude(vector[0]), fxl_magnitude(vector[1]),
                                    fxl_magnitude(vector[2])};
    const unsigned bits = fxl_bit_length(magnitudes[0] | magnitudes[1] | magnitudes[2]);
    uint32_t parts[3];
    uint64_t square = 0; /* at most 3 * 2^62, which the square root takes */
    if (bits == 0) {
        return false;
    }
    for (uint32_t i = 0; i < 3; i++) {
        parts[i] = scaled(magnitudes[i], (int)bits - 31);
        square += fxl_multiply_u32(parts[i], parts[i]);
    }
    const uint32_t length = fxl_square_root(square); /* 2^30 at least, and no part is longer */
    for (uint32_t i = 0; i < 3; i++) {
        uint32_t rest;
        const uint64_t dividend = ((uint64_t)parts[i] << 31) + (length >> 1);
        const int64_t part = fxl_divide_u64(dividend, length, &rest);
        unit[i] = vector[i] < 0 ? -part : part;
    }
    return true;
}
