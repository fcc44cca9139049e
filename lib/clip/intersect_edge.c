/* SPDX-License-Identifier: MIT */
#include "intersect_edge.h"

#include "../math/arith.h"
#include "../math/divide_wide.h"
#include "../math/family.h"

#if !FXL_INTERSECTS_IN_ASSEMBLY

static fxl_q18_46 interpolate(fxl_q18_46 from, fxl_q18_46 to, uint64_t fraction)
{
    uint64_t part = fxl_multiply_high(fxl_magnitude(to - from), fraction);
    return to < from ? from - (int64_t)part : from + (int64_t)part;
}

void fxl_intersect_edge(const fxl_view_point *from, const fxl_view_point *to,
                        const fxl_q18_46 *inside, const fxl_q18_46 *outside, fxl_view_point *point)
{
    FXL_ASSERT(*inside > 0 && *outside < 0);
    const uint64_t fraction =
        fxl_fraction((uint64_t)*inside, (uint64_t)*inside - (uint64_t)*outside);
    point->x = interpolate(from->x, to->x, fraction);
    point->y = interpolate(from->y, to->y, fraction);
    point->z = interpolate(from->z, to->z, fraction);
}

#endif
