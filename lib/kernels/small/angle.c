/* SPDX-License-Identifier: MIT */
/* The series of lib/src/angle.c, which says how far they reach; both by one loop
 * over what they divide by. */
#include "fixel/angle.h"

#include "arith.h"
#include "sine.h"

/* 2 pi with 61 bits after the point. */
#define TWO_PI_Q61 0xC90FDAA22168C235u

/* What divides by a number of the series. */
#define BY(divisor) (UINT64_MAX / (divisor))

/* The sine's and, from the first on, the cosine's. */
static const uint64_t factors[] = {BY(132), BY(90), BY(56), BY(30), BY(12), BY(2),
                                   BY(110), BY(72), BY(42), BY(20), BY(6)};
#define COSINE_COUNT 6u
#define COUNT        11u

/* The sine of any angle, with 62 bits after the point, but for its sign: up to an eighth of
 * a turn by the sine's series, then by the cosine's of what is left to a quarter. */
static uint64_t sine_q62(fxl_angle angle)
{
    uint32_t folded = angle > 2 * FXL_ANGLE_QUARTER ? 0u - angle : angle;
    uint32_t at = COSINE_COUNT, end = COUNT;
    if (folded > FXL_ANGLE_QUARTER) {
        folded = 2 * FXL_ANGLE_QUARTER - folded;
    }
    const bool cosine = folded > FXL_ANGLE_QUARTER / 2;
    if (cosine) {
        folded = FXL_ANGLE_QUARTER - folded;
        at = 0;
        end = COSINE_COUNT;
    }
    const uint64_t x = fxl_multiply_high((uint64_t)folded << 34, TWO_PI_Q61) << 1;
    const uint64_t square = fxl_multiply_high(x, x);
    uint64_t rest = 0;
    for (; at < end; at++) {
        rest = fxl_multiply_high(square - fxl_multiply_high(square, rest), factors[at]);
    }
    /* 1 itself has one bit more than 64 after the point. */
    return cosine ? ((uint64_t)1 << 62) - (rest >> 2) : (x - fxl_multiply_high(x, rest)) >> 2;
}

int64_t fxl_sin_q31(fxl_angle angle)
{
    int64_t sine = fxl_round_shift((int64_t)sine_q62(angle), 31);
    return angle > 2 * FXL_ANGLE_QUARTER ? -sine : sine;
}

int64_t fxl_cos_q31(fxl_angle angle)
{
    return fxl_sin_q31(angle + FXL_ANGLE_QUARTER);
}

fxl_q2_30 fxl_sin(fxl_angle angle)
{
    int64_t sine = fxl_round_shift((int64_t)sine_q62(angle), 32);
    return (fxl_q2_30)(angle > 2 * FXL_ANGLE_QUARTER ? -sine : sine);
}

fxl_q2_30 fxl_cos(fxl_angle angle)
{
    return fxl_sin(angle + FXL_ANGLE_QUARTER);
}
