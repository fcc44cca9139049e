/* SPDX-License-Identifier: MIT */
/* Functions of lib/paint of one input, or of few: one source at a time, because names of static
 * functions recur. */
#if CASE_OF_LIGHT
#include "paint/light_level.c"
#elif CASE_OF_GRADIENTS
#include "paint/gradients.c"
#else
#include "paint/rgb565_colour.h"
#include "paint/texel_place.h"
#include "paint/texture_level.h"
#endif

#include "enumeration.h"

#if CASE_OF_LIGHT

/* [[row]]
 * id = "every reciprocal of a root"
 * function = "root_reciprocal"
 * property = "it is within 2^-25 of itself of 2^46 / value^(1/2), for every value from 2^30"
 * checks = 3221225472
 * flags = ["-DCASE_OF_LIGHT"]
 * links = ["lib/math/arith.c", "lib/math/plane.c"]
 * cases = [1, 2, 3]
 * every = true
 */
/* The square of the root, times the value, is 2^92 within twice 2^-25, less the square of that. */
void enumerate_root_reciprocal(void)
{
    const wide exact = (wide)1 << 92, bound = ((wide)1 << 68) - ((wide)1 << 42);
    uint32_t value = (uint32_t)CASE << 30;
    do {
        const uint64_t root = root_reciprocal(value);
        const wide error = (wide)(root * root) * value - exact;
        TRY(value, error <= bound && error >= -bound);
        value += 1;
    } while (value % (1u << 30) != 0);
}

#elif CASE_OF_GRADIENTS

/* [[row]]
 * id = "every cube root"
 * function = "lib/paint/gradients.c:cube_root_up"
 * property = "it is the least integer whose cube is not below the value, for every value from 1 to 2^30"
 * checks = 1073741824
 * flags = ["-DCASE_OF_GRADIENTS"]
 * links = ["lib/math/arith.c", "lib/math/plane.c", "lib/view/project.c"]
 * every = true
 */
void enumerate_cube_root_up(void)
{
    uint64_t root = 1; /* the least whose cube is not below the value */
    for (uint32_t value = 1; value <= 1u << 30; value++) {
        root += root * root * root < value;
        TRY(value, cube_root_up(value) == root);
    }
}

/* [[row]]
 * id = "every third"
 * function = "lib/paint/gradients.c:third"
 * property = "it is floor(number / 3), from -599 to 2^20"
 * checks = 1049175
 * flags = ["-DCASE_OF_GRADIENTS"]
 * links = ["lib/math/arith.c", "lib/math/plane.c", "lib/view/project.c"]
 * every = true
 */
void enumerate_third(void)
{
    for (int number = -599; number < 1 << 20; number++) {
        TRY(number, 3 * third(number) <= number && 3 * third(number) > number - 3);
    }
}

/* The least integer that is not below number 2^exponent, from 1 to 2^31. */
static uint64_t least_above(uint64_t number, int exponent)
{
    const uint64_t most = (uint64_t)1 << 31;
    if (exponent >= 0) {
        return exponent > 31 || number << exponent > most ? most : number << exponent;
    }
    return exponent < -40 ? 1 : (number + (((uint64_t)1 << -exponent) - 1)) >> -exponent;
}

/* [[row]]
 * id = "every power"
 * function = "lib/paint/gradients.c:power_up"
 * property = "it is number 2^exponent, rounded up and held to 1 and 2^31, for every number and exponents from -400 to 400"
 * checks = 52493535
 * flags = ["-DCASE_OF_GRADIENTS"]
 * links = ["lib/math/arith.c", "lib/math/plane.c", "lib/view/project.c"]
 * every = true
 */
void enumerate_power_up(void)
{
    for (int exponent = -400; exponent <= 400; exponent++) {
        for (uint32_t number = 1; number < 1u << 16; number++) {
            TRY(number, power_up(number, exponent) == least_above(number, exponent));
        }
    }
}

#else

static const uint32_t channels[3] = {FXL_RED_565, FXL_GREEN_565, FXL_BLUE_565};

static uint32_t lowest(uint32_t channel)
{
    return channel & (0u - channel);
}

/* [[row]]
 * id = "every exchange"
 * function = "lib/paint/rgb565_colour.h:fxl_exchanged_565"
 * property = "the halves of a word change places, for every colour in either"
 * checks = 131072
 * every = true
 */
void enumerate_exchanged(void)
{
    for (uint32_t colour = 0; colour < 1u << 16; colour++) {
        TRY(colour, fxl_exchanged_565(colour) == colour << 16);
        TRY(colour, fxl_exchanged_565(colour << 16) == colour);
    }
}

/* [[row]]
 * id = "every blend"
 * function = "lib/paint/rgb565_colour.h:fxl_blend_565"
 * property = "each channel of both colours is the mean by sixteenths, rounded down, for every two levels of it and every part"
 * checks = 417792
 */
/* Channels of a sum are fields of a word, so one meets another only by a carry, which is there if
 * it is with the largest colours. So a channel is tried with the others at both ends. */
void enumerate_blend(void)
{
    for (uint32_t part = 0; part <= 16; part++) {
        for (uint32_t i = 0; i < 6; i++) {
            const uint32_t channel = channels[i % 3] << 16 * (i / 3), unit = lowest(channel), rest = ~channel;
            const uint32_t most = channel / unit;
            for (uint32_t a = 0; a <= most; a++) {
                for (uint32_t b = 0; b <= most; b++) {
                    const uint32_t wanted = (a * part + b * (16 - part)) / 16 * unit;
                    TRY(a, fxl_blend_565(a * unit, b * unit, part) == wanted);
                    TRY(a, fxl_blend_565(a * unit | rest, b * unit | rest, part) == (wanted | rest));
                }
            }
        }
    }
}

/* [[row]]
 * id = "every mixture"
 * function = "lib/paint/rgb565_colour.h:fxl_mix_channel_565"
 * property = "it is the mean by 256ths, rounded to nearest, for every two levels and every part"
 * checks = 1579008
 * every = true
 */
/* So does it. */
void enumerate_mix_channel(void)
{
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t channel = channels[i], unit = lowest(channel);
        for (uint32_t a = 0; a <= channel; a += unit) {
            for (uint32_t b = 0; b <= channel; b += unit) {
                for (uint32_t part = 0; part <= 256; part++) {
                    const uint32_t wanted =
                        (a / unit * part + b / unit * (256 - part) + 128) / 256 * unit;
                    TRY(a, fxl_mix_channel_565(a, b, part, channel) == wanted);
                }
            }
        }
    }
}

/* [[row]]
 * id = "every opacity"
 * function = "lib/paint/texel_place.h:fxl_is_stippled_away"
 * property = "of a square of 16 pixels as many are drawn as the opacity says"
 * checks = 17
 */
void enumerate_stipple(void)
{
    for (uint32_t opacity = 0; opacity <= 16; opacity++) {
        uint32_t drawn = 0;
        for (int32_t pixel = 0; pixel < 16; pixel++) {
            drawn += !fxl_is_stippled_away(opacity, pixel & 3, pixel >> 2);
        }
        TRY(opacity, drawn == opacity);
    }
}

/* [[row]]
 * id = "every level's side"
 * function = "lib/paint/texture_level.h:fxl_level_log"
 * property = "a level's side is half of the one before, and at least the least"
 * checks = 496
 * every = true
 */
/* A texture has sides of up to 2^15 texels, and a row of 4 bits a texel has at least two. */
void enumerate_level_log(void)
{
    for (uint32_t least = 0; least <= 1; least++) {
        for (uint32_t log = least; log < 16; log++) {
            uint32_t wanted = log; /* a level's side is half of the one before */
            for (uint32_t level = 0; level < 16; level++) {
                TRY(level, fxl_level_log(log, level, least) == wanted);
                wanted -= wanted > least;
            }
        }
    }
}

#endif
