/* SPDX-License-Identifier: MIT */

#include "../math/arith.h"
#include "intersection.h"
#include "split.h"

/* from + (to - from) fraction / 2^64, rounded to the nearest, halves away from `from`. |to -
 * from| is below 2^31, so the part below 2^62 is good to 2 units of 2^-31, downward. The
 * rounding adds 2^-25 more than a half, so that a half counts as one whether or not the fraction
 * is exact. */
/* clippers 9.2 */
static fxl_q16_16 along(fxl_q16_16 from, fxl_q16_16 to, uint64_t fraction)
    FXL_REQUIRES(FXL_BELOW(from, FXL_COORDINATE_MAX) && FXL_BELOW(to, FXL_COORDINATE_MAX))
        FXL_ASSIGNS() FXL_ENSURES(from <= to ? FXL_RESULT >= from && FXL_RESULT <= to
                                             : FXL_RESULT <= from && FXL_RESULT >= to)
{
    int64_t extent = (int64_t)to - from;
    uint64_t part = fxl_multiply_high(fxl_magnitude(extent) << 31, fraction);
    int64_t whole = (int64_t)((part + (1u << 30) + (1u << 6)) >> 31);
    return (fxl_q16_16)(extent < 0 ? from - whole : from + whole);
}

/* The difference of the distances is the plane's normal times the difference of two points, so
 * it is below 2^61. */
/* clippers 9.2, 9.3 */
fxl_point fxl_split_edge(const fxl_point *front, const fxl_point *behind, fxl_q18_46 front_distance,
                         fxl_q18_46 behind_distance)
{
    FXL_ASSERT(front_distance > 0 && behind_distance < 0);
    uint64_t fraction = fxl_intersection_fraction(front_distance, behind_distance);
    fxl_point point = {along(front->x, behind->x, fraction), along(front->y, behind->y, fraction),
                       along(front->z, behind->z, fraction)};
    return point;
}
