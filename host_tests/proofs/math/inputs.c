/* SPDX-License-Identifier: MIT */
/* Functions of lib/math of one input. */
#include "math/family.h"

#if FOLDED
/* quarter_sine_q62 is defined under another name, and where it is called with `folded` a line
 * stands in for it: straight but for its low words, which take any value, so that there is
 * something to round. */
#include "math/arith.h"
#define quarter_sine_q62(parameter) OF_##parameter)
#define OF_uint32_t                 quarter_of_library(uint32_t
#define OF_folded                   line(folded
static inline uint64_t line(uint32_t angle)
{
    const uint32_t low = angle == FXL_ANGLE_QUARTER ? 0 : angle * 0x9E3779B1u;
    return ((uint64_t)angle << 32) + low;
}
#endif

#if !FXL_HAS_DIVIDER
#include "math/core.h"
#else
#include "math/angle.c"
#include "math/arith.c"
#include "math/pixel_centre.h"
#endif

#include <math.h>

#include "enumeration.h"

#if FOLDED

/* The line makes a wave of triangles of the sine, with 62 bits after the point. */
static int64_t wave(uint32_t angle)
{
    const uint32_t part = angle & (FXL_ANGLE_QUARTER - 1u), rest = FXL_ANGLE_QUARTER - part;
    const int64_t magnitude = (int64_t)line((angle >> 30) & 1u ? rest : part);
    return angle >> 31 ? -magnitude : magnitude;
}

static bool is_nearest(int64_t rounded, int64_t exact, int shift)
{
    return llabs(rounded * ((int64_t)1 << shift) - exact) <= (int64_t)1 << (shift - 1);
}

/* [[row]]
 * id = "every angle, folded"
 * function = "lib/math/angle.c:magnitude_q62"
 * property = "sine and cosine are those of the first quarter, folded and with their sign, and rounded to the nearest, for every angle"
 * checks = 4294967296
 * flags = ["-DFOLDED"]
 */
void enumerate_folded(void)
{
    uint32_t angle = 0;
    (void)quarter_of_library;
    do {
        const int64_t sine = wave(angle), cosine = wave(angle + FXL_ANGLE_QUARTER);
        TRY(angle, is_nearest(fxl_sin(angle), sine, 32) && is_nearest(fxl_sin_q31(angle), sine, 31));
        tried -= 1;
        TRY(angle, is_nearest(fxl_cos(angle), cosine, 32) && is_nearest(fxl_cos_q31(angle), cosine, 31));
    } while (++angle != 0);
}

#elif !FXL_HAS_DIVIDER

/* [[row]]
 * id = "leading zeros without an instruction"
 * function = "lib/math/core.h:fxl_leading_zeros"
 * property = "the text for cores without an instruction counts what the compiler counts, for every value above 0"
 * checks = 4294967295
 * flags = ["-DFXL_CORE_HAS=0"]
 */
void enumerate_leading_zeros(void)
{
    uint32_t value = 0;
    while (++value != 0) {
        TRY(value, fxl_leading_zeros(value) == (unsigned)__builtin_clz(value));
    }
}

/* [[row]]
 * id = "reciprocal of 16 bits without a divider"
 * function = "lib/math/core.h:fxl_reciprocal_half"
 * property = "it is within 3 units of 2^31 / value"
 * checks = 32769
 * flags = ["-DFXL_CORE_HAS=0"]
 */
void enumerate_reciprocal_half(void)
{
    for (int64_t value = 1 << 15; value <= 1 << 16; value++) {
        const int64_t reciprocal = fxl_reciprocal_half((uint32_t)value);
        TRY(value, llabs(reciprocal * value - ((int64_t)1 << 31)) <= 3 * value);
    }
}

#elif !FXL_HAS_LEADING_ZEROS

/* [[row]]
 * id = "leading zeros by a table of bytes"
 * function = "lib/math/core.h:fxl_leading_zeros"
 * property = "the text for cores with long products and without an instruction counts what the compiler counts, for every value above 0"
 * checks = 4294967295
 * flags = ["-DFXL_CORE_HAS=3"]
 */
void enumerate_zeros_of_bytes(void)
{
    uint32_t value = 0;
    while (++value != 0) {
        TRY(value, fxl_leading_zeros(value) == (unsigned)__builtin_clz(value));
    }
}

#else

#define BLOCK 4096 /* angles that a rotation goes on with before it begins anew */

/* [[row]]
 * id = "sine of every angle"
 * function = "lib/math/angle.c:quarter_sine_q62"
 * property = "it is within 0.02 unit of 2^-31 of the sine, for every angle of the first quarter of a turn"
 * checks = 1073741825
 * cases = [1, 2, 3, 4]
 * every = true
 */
/* A quarter of a turn has four cases. The reference is exact to 2^-50: a step of the rotation by
 * 2^-32 turn errs by less than 2^-62. */
void enumerate_quarter_sine(void)
{
    const long double step = ldexpl(3.14159265358979323846264338327950288L, -31);
    const long double turn_sine = sinl(step), turn_cosine = cosl(step);
    /* 0.02 units of 2^-31, in units of 2^-62: with the half of its rounding fxl_sin_q31 is off by
     * 0.52. */
    const long double bound = 0.02L * (1u << 31);
    const uint32_t first = (CASE - 1) * (1u << 28), end = CASE * (1u << 28) + (CASE == 4);
    long double sine = 0, cosine = 1;
    for (uint32_t angle = first; angle != end; angle++) {
        if (angle % BLOCK == 0) {
            sine = ldexpl(sinl(angle * step), 62);
            cosine = ldexpl(cosl(angle * step), 62);
        }
        TRY(angle, fabsl((long double)quarter_sine_q62(angle) - sine) <= bound);
        const long double next = sine * turn_cosine + cosine * turn_sine;
        cosine = cosine * turn_cosine - sine * turn_sine;
        sine = next;
    }
}

/* [[row]]
 * id = "every reciprocal of a fraction"
 * function = "lib/math/arith.c:reciprocal_below"
 * property = "it is at most 2^60 / value, and too small by at most 2^-27 of itself"
 * checks = 1073741824
 * every = true
 */
void enumerate_reciprocal_below(void)
{
    const uint64_t exact = (uint64_t)1 << 60;
    for (uint32_t value = (1u << 30) + 1u; value <= 1u << 31; value++) {
        const uint64_t product = (uint64_t)reciprocal_below(value) * value;
        TRY(value, product <= exact && exact - product <= exact >> 27);
    }
}

/* [[row]]
 * id = "every first centre"
 * function = "lib/math/pixel_centre.h:fxl_first_centre_from"
 * property = "its centre is at or past the coordinate, and the one before is not, for every coordinate"
 * checks = 2147483647
 * every = true
 */
void enumerate_first_centre_from(void)
{
    for (int32_t coordinate = 1 - (1 << 30); coordinate < 1 << 30; coordinate++) {
        const int32_t row = fxl_first_centre_from(coordinate);
        TRY(coordinate, (int64_t)row * 65536 + 32768 >= coordinate &&
                            (int64_t)(row - 1) * 65536 + 32768 < coordinate);
    }
}

/* [[row]]
 * id = "every centre"
 * function = "lib/math/pixel_centre.h:fxl_centre_of"
 * property = "it is half a pixel past the row's coordinate, and the first centre from itself"
 * checks = 32767
 * every = true
 */
void enumerate_centre_of(void)
{
    for (int32_t row = 1 - (1 << 14); row < 1 << 14; row++) {
        TRY(row, 2 * fxl_centre_of(row) == 131072 * row + 65536 &&
                     fxl_first_centre_from(fxl_centre_of(row)) == row);
    }
}

#endif
