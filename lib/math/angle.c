/* SPDX-License-Identifier: MIT */

#include "arith.h"

/* Numbers below are unsigned fractions with 64 bits after the binary point, unless their names say
 * otherwise. fxl_multiply_high multiplies two of them; its error is less than one unit. Besides the
 * omitted terms of a series, errors stay below 2^-58. */

/* 2 pi with 61 bits after the point. */
#define TWO_PI_Q61 0xC90FDAA22168C235u

/* Converts an angle of at most an eighth of a turn to radians: angle * 2 pi / 2^32 < 0.79. */
static uint64_t radians(uint32_t angle)
{
    FXL_ASSERT(angle <= FXL_ANGLE_QUARTER / 2);
    return fxl_multiply_high((uint64_t)angle << 34, TWO_PI_Q61) << 1;
}

/* The factor that divides by a number of the series. */
#define BY(divisor) (UINT64_MAX / (divisor))

/* sin x = x (1 - x^2/6 (1 - x^2/20 (1 - x^2/42 (1 - x^2/72 (1 - x^2/110))))).
 * The omitted terms are below x^13/13! < 2^-37 for x <= pi/4.
 * cos x = 1 - x^2/2 (1 - x^2/12 (1 - x^2/30 (1 - x^2/56 (1 - x^2/90 (1 - x^2/132))))).
 * The omitted terms are below x^14/14! < 2^-41 for x <= pi/4. */
static const uint64_t factors[] = {BY(110), BY(72), BY(42), BY(20), BY(6), BY(132),
                                   BY(90),  BY(56), BY(30), BY(12), BY(2)};
#define SINE_FACTORS 5u /* the first five factors; the others are the cosine's */
#define ALL_FACTORS  (sizeof factors / sizeof factors[0])

/* The sine of 0..1/4 turn, with 62 bits after the point. Up to an eighth of a turn it is the sine
 * of the angle; above, it is the cosine of a quarter turn less the angle. Both series are summed
 * from the innermost bracket outward; a step is square * factor * (1 - rest). */
static uint64_t quarter_sine_q62(uint32_t angle)
    FXL_REQUIRES(angle <= FXL_ANGLE_QUARTER) FXL_ASSIGNS()
    FXL_ENSURES(FXL_RESULT <= (uint64_t)1 << 62)
{
    const bool by_cosine = angle > FXL_ANGLE_QUARTER / 2;
    const uint64_t x = radians(by_cosine ? FXL_ANGLE_QUARTER - angle : angle);
    const uint64_t square = fxl_multiply_high(x, x);
    const uint32_t end = by_cosine ? ALL_FACTORS : SINE_FACTORS;
    uint64_t remainder = 0;
    for (uint32_t i = by_cosine ? SINE_FACTORS : 0; i < end; i++) {
        remainder = fxl_multiply_high(square - fxl_multiply_high(square, remainder), factors[i]);
    }
    /* 1 itself does not fit 64 bits after the point. */
    return by_cosine ? ((uint64_t)1 << 62) - (remainder >> 2)
                     : (x - fxl_multiply_high(x, remainder)) >> 2;
}

/* The magnitude of the sine of any angle, with 62 bits after the point. The angle is folded to a
 * quarter turn. The callers apply the sign after rounding, so sin(-a) is exactly -sin(a). */
static int64_t magnitude_q62(fxl_angle angle)
{
    uint32_t folded = angle > 2 * FXL_ANGLE_QUARTER ? 0u - angle : angle;
    if (folded > FXL_ANGLE_QUARTER) {
        folded = 2 * FXL_ANGLE_QUARTER - folded;
    }
    return (int64_t)quarter_sine_q62(folded);
}

/* SPEC 1.2 */
static int64_t with_sign(fxl_angle angle, int64_t magnitude)
{
    return angle > 2 * FXL_ANGLE_QUARTER ? -magnitude : magnitude;
}

int64_t fxl_sin_q31(fxl_angle angle)
{
    return with_sign(angle, fxl_round_shift(magnitude_q62(angle), 31));
}

int64_t fxl_cos_q31(fxl_angle angle)
{
    return fxl_sin_q31(angle + FXL_ANGLE_QUARTER);
}

/* SPEC 1.2, 2.1 */
fxl_q2_30 fxl_sin(fxl_angle angle)
    FXL_ASSIGNS() FXL_ENSURES(FXL_BELOW(FXL_RESULT, FXL_Q2_30_ONE))
{
    return (fxl_q2_30)with_sign(angle, fxl_round_shift(magnitude_q62(angle), 32));
}

/* SPEC 1.2, 2.1 */
fxl_q2_30 fxl_cos(fxl_angle angle)
    FXL_ASSIGNS() FXL_ENSURES(FXL_BELOW(FXL_RESULT, FXL_Q2_30_ONE))
{
    return fxl_sin(angle + FXL_ANGLE_QUARTER);
}
