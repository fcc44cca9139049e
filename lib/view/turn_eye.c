/* SPDX-License-Identifier: MIT */
/* A file of its own, so that fxl_turn_eye keeps no registers for it. */

#include "../math/arith.h"
#include "turn.h"

/* value / (scale 2^(14 + shift)), rounded: floor((value + half) / divisor), in two exact floors.
 * half is below 2^24 2^23. Returns false if the quotient exceeds 2^30. */
static bool divide(int64_t value, fxl_q16_16 scale, unsigned shift, int32_t *quotient)
{
    const int64_t half = (int64_t)scale << (13 + shift);
    const int64_t numerator = (value + half) >> (14 + shift);
    if (!fxl_within(numerator, (int64_t)scale << 30)) {
        return false;
    }
    *quotient = fxl_divide_down(numerator, (uint32_t)scale);
    return true;
}

unsigned fxl_turn_divide_eye(const fxl_q18_46 exact[3], fxl_q16_16 scale, fxl_q16_16 radius,
                             fxl_point *eye)
{
    unsigned shift = 0;
    int32_t limit = (1 << 30) - 1 - radius;
    while (!(divide(exact[0], scale, shift, &eye->x) && divide(exact[1], scale, shift, &eye->y) &&
             divide(exact[2], scale, shift, &eye->z) && limit >= 0 &&
             fxl_eye_is_within(eye, limit))) {
        shift++;
        limit = (1 << 30) - 1 - (radius >> shift);
    }
    return shift;
}
