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

/* The sine in units of 2^-bits of 0..1/4 turn, which is up to an eighth the sine's
 * series, and then the cosine's of what is left. */
static int64_t rounded_sine(fxl_angle angle, unsigned bits)
{
    bool negative = angle > 2 * FXL_ANGLE_QUARTER;
    uint32_t folded = negative ? 0u - angle : angle;
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
    uint64_t x = fxl_multiply_high((uint64_t)folded << 34, TWO_PI_Q61) << 1;
    uint64_t square = fxl_multiply_high(x, x), rest = 0;
    for (; at < end; at++) {
        rest = fxl_multiply_high(square - fxl_multiply_high(square, rest), factors[at]);
    }
    /* In 62 bits. */
    uint64_t result =
        cosine ? ((uint64_t)1 << 62) - (rest >> 2) : (x - fxl_multiply_high(x, rest)) >> 2;
    int64_t magnitude = fxl_round_shift((int64_t)result, 62 - bits);
    return negative ? -magnitude : magnitude;
}

int64_t fxl_sin_q31(fxl_angle angle)
{
    return rounded_sine(angle, 31);
}

int64_t fxl_cos_q31(fxl_angle angle)
{
    return fxl_sin_q31(angle + FXL_ANGLE_QUARTER);
}

fxl_q2_30 fxl_sin(fxl_angle angle)
{
    return (fxl_q2_30)rounded_sine(angle, 30);
}

fxl_q2_30 fxl_cos(fxl_angle angle)
{
    return fxl_sin(angle + FXL_ANGLE_QUARTER);
}
