/* SPDX-License-Identifier: MIT */
/* What an edge's height becomes as a divisor, for every height: one text for each divider that cores
 * have (lib/math/family.h). */
#include "raster/edge_divide.h"

#include <math.h>

#include "enumeration.h"

#define HEIGHTS(height) \
    uint32_t height = 1; \
    height <= FXL_EDGE_HEIGHT_MAX; \
    height++

/* [[row]]
 * id = "every divider's shift"
 * function = "fxl_edge_divider_shift"
 * property = "height 2^shift is from 2^31 to below 2^32, for every height"
 * checks = 67108863
 * every = true
 */
/* [[row]]
 * id = "every divider's shift, without a divider"
 * function = "fxl_edge_divider_shift"
 * property = "the same of the text for cores without a divider"
 * checks = 67108863
 * flags = ["-DFXL_CORE_HAS=0"]
 */
/* [[row]]
 * id = "every divider's shift, by a divider of 32 bits"
 * function = "fxl_edge_divider_shift"
 * property = "the same of the text for cores with a divider of 32 bits"
 * checks = 67108863
 * flags = ["-DFXL_CORE_HAS=3"]
 * links = ["lib/math/arith.c"]
 */
/* The same for all texts: the edge holds for 2^shift rows. */
void enumerate_divider_shift(void)
{
    for (HEIGHTS(height)) {
        const fxl_edge_divider divider = fxl_edge_divider_of(height);
        const uint64_t scaled = (uint64_t)height << fxl_edge_divider_shift(&divider);
        TRY(height, scaled >> 31 == 1);
    }
}

#if !FXL_HAS_DIVIDER

/* [[row]]
 * id = "every divider, without a divider"
 * function = "fxl_edge_divider_of"
 * property = "the reciprocal is within 2^-14 of itself, for every height"
 * checks = 67108863
 * flags = ["-DFXL_CORE_HAS=0"]
 */
/* [[row]]
 * id = "every divider, by a divider of 32 bits"
 * function = "fxl_edge_divider_of"
 * property = "the reciprocal is off by -2^-29.38 to 2^-30.9 of itself, for every height"
 * checks = 67108863
 * flags = ["-DFXL_CORE_HAS=3"]
 * links = ["lib/math/arith.c"]
 */
/* The error relative to 2^(47 - shift) / height. */
void enumerate_divider(void)
{
    for (HEIGHTS(height)) {
        const fxl_edge_divider divider = fxl_edge_divider_of(height);
        const int64_t exact = (int64_t)1 << 47;
        const int64_t product = ((int64_t)height << divider.shift) * divider.reciprocal;
        TRY(height, llabs(product - exact) <= exact >> 14);
    }
}

/* [[row]]
 * id = "every digit, without a divider"
 * function = "fxl_edge_digit"
 * property = "the rest that the estimate leaves is below 2^31 in magnitude, for every height and remainder"
 * checks = 67108863
 * flags = ["-DFXL_CORE_HAS=0"]
 */
/* The rest that the first estimate of fxl_edge_digit leaves, 2^16 left - digit height, for every
 * left below the height. With top = floor(left 2^shift / 2^16) the digit is above top reciprocal /
 * 2^15 - 1, and not above that without the 1. So the rest lies between two straight lines in top,
 * which are highest and lowest at the ends, 0 and that of left = height. In units of 2^-47. */
void enumerate_digit(void)
{
    for (HEIGHTS(height)) {
        const fxl_edge_divider divider = fxl_edge_divider_of(height);
        const wide scale = (wide)1 << 47, most = scale << 31;
        const wide a_top =
            (scale << (32 - divider.shift)) - (wide)divider.reciprocal * height * ((wide)1 << 32);
        const wide last = ((uint64_t)height << divider.shift) >> 16;
        const wide above = (scale << (32 - divider.shift)) + height * scale;
        TRY(height, last * divider.reciprocal <= UINT32_MAX && a_top * last > -most &&
                        a_top * last + above < most && above < most);
    }
}

#elif !FXL_HAS_LONG_DIVIDER

/* The error relative to 2^62 / (height 2^shift): from -2^-29.38 to 2^-30.9. The product fits the 64
 * bits of a long double. */
void enumerate_divider(void)
{
    const long double below = -exp2l(-29.38L), above = exp2l(-30.9L);
    for (HEIGHTS(height)) {
        const fxl_edge_divider divider = fxl_edge_divider_of(height);
        const uint64_t scaled = (uint64_t)height << divider.shift;
        const long double error =
            ldexpl((long double)(scaled * (uint64_t)divider.reciprocal), -62) - 1;
        TRY(height, scaled == 2 * (uint64_t)divider.half && error >= below && error <= above);
    }
}

#endif
