/* SPDX-License-Identifier: MIT */
#include "fixel/angle.h"

#include "arith.h"
#include "sine.h"

/* Numbers below are unsigned fractions with 64 bits after the point unless
 * their names say otherwise; fxl_multiply_high multiplies two of them and loses
 * less than one unit. Beside what a series leaves out, errors stay below 2^-58. */

/* 2 pi with 61 bits after the point. */
#define TWO_PI_Q61 0xC90FDAA22168C235u

/* 1 with 62 bits after the point: what the series answer in. */
#define ONE_Q62 ((uint64_t)1 << 62)

/* An eighth of a turn at the most, as radians: angle * 2 pi / 2^32 < 0.79. */
static uint64_t radians(uint32_t angle)
{
    FXL_ASSERT(angle <= FXL_ANGLE_QUARTER / 2);
    return fxl_multiply_high((uint64_t)angle << 34, TWO_PI_Q61) << 1;
}

/* square * factor * (1 - rest): one step of a Taylor series from within. */
static uint64_t series_step(uint64_t square, uint64_t factor, uint64_t rest)
{
    return fxl_multiply_high(square - fxl_multiply_high(square, rest), factor);
}

/* What divides by a number of the series. */
#define BY(divisor) (UINT64_MAX / (divisor))

/* sin x = x (1 - x^2/6 (1 - x^2/20 (1 - x^2/42 (1 - x^2/72 (1 - x^2/110))))).
 * What is left out is below x^13/13! < 2^-37 for x <= pi/4. */
static uint64_t sine_q62(uint64_t x)
{
    static const uint64_t factors[] = {BY(110), BY(72), BY(42), BY(20), BY(6)};
    uint64_t square = fxl_multiply_high(x, x);
    uint64_t rest = 0;
    for (size_t i = 0; i < sizeof factors / sizeof factors[0]; i++) {
        rest = series_step(square, factors[i], rest);
    }
    return (x - fxl_multiply_high(x, rest)) >> 2;
}

/* cos x = 1 - x^2/2 (1 - x^2/12 (1 - x^2/30 (1 - x^2/56 (1 - x^2/90 (1 - x^2/132))))).
 * What is left out is below x^14/14! < 2^-41 for x <= pi/4. */
static uint64_t cosine_q62(uint64_t x)
{
    static const uint64_t factors[] = {BY(132), BY(90), BY(56), BY(30), BY(12), BY(2)};
    uint64_t square = fxl_multiply_high(x, x);
    uint64_t rest = 0;
    for (size_t i = 0; i < sizeof factors / sizeof factors[0]; i++) {
        rest = series_step(square, factors[i], rest);
    }
    return ONE_Q62 - (rest >> 2);
}

/* The sine of 0..1/4 turn. */
static uint64_t quarter_sine_q62(uint32_t angle)
{
    if (angle <= FXL_ANGLE_QUARTER / 2) {
        return sine_q62(radians(angle));
    }
    return cosine_q62(radians(FXL_ANGLE_QUARTER - angle));
}

/* The sine of any angle in units of 2^-bits, rounded once. Any angle is folded
 * to a quarter turn first, so that sin(-a) is -sin(a) by itself. */
static int64_t rounded_sine(fxl_angle angle, unsigned bits)
{
    bool negative = angle > 2 * FXL_ANGLE_QUARTER;
    uint32_t folded = negative ? 0u - angle : angle;
    if (folded > FXL_ANGLE_QUARTER) {
        folded = 2 * FXL_ANGLE_QUARTER - folded;
    }
    int64_t magnitude = fxl_round_shift((int64_t)quarter_sine_q62(folded), 62 - bits);
    return negative ? -magnitude : magnitude;
}

int64_t fxl_sin_q31(fxl_angle angle)
{
    return rounded_sine(angle, 31);
}

int64_t fxl_cos_q31(fxl_angle angle)
{
    return rounded_sine(angle + FXL_ANGLE_QUARTER, 31);
}

fxl_q2_30 fxl_sin(fxl_angle angle)
{
    return (fxl_q2_30)rounded_sine(angle, 30);
}

fxl_q2_30 fxl_cos(fxl_angle angle)
{
    return (fxl_q2_30)rounded_sine(angle + FXL_ANGLE_QUARTER, 30);
}
