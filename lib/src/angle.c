/* SPDX-License-Identifier: MIT */
#include "fixel/angle.h"

#include "arith.h"
#include "sine.h"

/* Numbers in this file are unsigned fractions with 32 bits after the point,
 * held in 64 bits so that 1 is 2^32. */
#define ONE ((uint64_t)1 << 32)

/* 2 pi, with 29 bits after the point; off by less than 2^-34 of itself. */
#define TWO_PI_Q29 ((uint64_t)3373259426u)

/* a * b for a, b <= 2^32, not both 2^32; costs half a unit. */
static uint64_t multiply(uint64_t a, uint64_t b)
{
    FXL_ASSERT(a <= ONE && b <= ONE && (a < ONE || b < ONE));
    uint64_t product = a * b;
    return (product >> 32) + ((product >> 31) & 1u);
}

/* An eighth of a turn at the most, as radians: angle * 2 pi / 2^32. */
static uint64_t radians(uint32_t angle)
{
    FXL_ASSERT(angle <= FXL_ANGLE_QUARTER / 2);
    return (angle * TWO_PI_Q29 + ((uint64_t)1 << 28)) >> 29;
}

/* 1 - square / (n (n + 1)) * rest: one step of a Taylor series from within. */
static uint64_t series_step(uint64_t square, uint32_t divisor, uint64_t rest)
{
    return ONE - multiply(multiply(square, rest), (ONE + divisor / 2) / divisor);
}

/* sin x = x (1 - x^2/6 (1 - x^2/20 (1 - x^2/42 (1 - x^2/72 (1 - x^2/110))))).
 * What is left out is below x^13/13! < 2^-37 for x <= pi/4. */
static uint64_t sine_of_radians(uint64_t x)
{
    uint64_t square = multiply(x, x);
    uint64_t sum = series_step(square, 110, ONE - 1);
    sum = series_step(square, 72, sum);
    sum = series_step(square, 42, sum);
    sum = series_step(square, 20, sum);
    sum = series_step(square, 6, sum);
    return multiply(x, sum);
}

/* cos x = 1 - x^2/2 (1 - x^2/12 (1 - x^2/30 (1 - x^2/56 (1 - x^2/90 (1 - x^2/132))))).
 * What is left out is below x^14/14! < 2^-41 for x <= pi/4. */
static uint64_t cosine_of_radians(uint64_t x)
{
    uint64_t square = multiply(x, x);
    uint64_t sum = series_step(square, 132, ONE - 1);
    sum = series_step(square, 90, sum);
    sum = series_step(square, 56, sum);
    sum = series_step(square, 30, sum);
    sum = series_step(square, 12, sum);
    return series_step(square, 2, sum);
}

/* The sine of 0..1/4 turn in units of 2^-31, rounded once more: 0..2^31. */
static uint32_t quarter_sine(uint32_t angle)
{
    uint64_t sine;
    if (angle <= FXL_ANGLE_QUARTER / 2) {
        sine = sine_of_radians(radians(angle));
    } else {
        sine = cosine_of_radians(radians(FXL_ANGLE_QUARTER - angle));
    }
    return (uint32_t)((sine + 1) >> 1);
}

/* Folds any angle to a quarter turn, so that sin(-a) is -sin(a) by itself. */
static uint32_t magnitude_and_sign(fxl_angle angle, bool *negative)
{
    *negative = angle > 2 * FXL_ANGLE_QUARTER;
    uint32_t folded = *negative ? 0u - angle : angle;
    if (folded > FXL_ANGLE_QUARTER) {
        folded = 2 * FXL_ANGLE_QUARTER - folded;
    }
    return quarter_sine(folded);
}

int64_t fxl_sin_q31(fxl_angle angle)
{
    bool negative;
    int64_t magnitude = (int64_t)magnitude_and_sign(angle, &negative);
    return negative ? -magnitude : magnitude;
}

int64_t fxl_cos_q31(fxl_angle angle)
{
    return fxl_sin_q31(angle + FXL_ANGLE_QUARTER);
}

fxl_q2_30 fxl_sin(fxl_angle angle)
{
    bool negative;
    uint32_t magnitude = magnitude_and_sign(angle, &negative);
    fxl_q2_30 rounded = (fxl_q2_30)((magnitude >> 1) + (magnitude & 1u));
    return negative ? -rounded : rounded;
}

fxl_q2_30 fxl_cos(fxl_angle angle)
{
    return fxl_sin(angle + FXL_ANGLE_QUARTER);
}
