/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "../math/family.h"
#include "fixel/line.h"
#include "intersection.h"

uint64_t fxl_intersection_fraction(fxl_q18_46 inside, fxl_q18_46 outside)
{
    FXL_ASSERT(inside >= 0 && outside < 0);
    return fxl_fraction((uint64_t)inside, (uint64_t)inside + fxl_magnitude(outside));
}

/* |to - from| is below 2^62. */
/* clippers 1.2 */
fxl_q18_46 fxl_intersection_part(fxl_q18_46 from, fxl_q18_46 to, uint64_t fraction)
{
    uint64_t part = fxl_multiply_high(fxl_magnitude(to - from), fraction);
    return to < from ? from - (int64_t)part : from + (int64_t)part;
}

/* |to - from| is below 2^32. */
/* clippers 1.2 */
fxl_q16_16 fxl_intersection_varying(fxl_q16_16 from, fxl_q16_16 to, uint64_t fraction)
{
    int64_t extent = (int64_t)to - from;
    int64_t part = (int64_t)((fxl_multiply_high(fxl_magnitude(extent) << 1, fraction) + 1) >> 1);
    return (fxl_q16_16)(extent < 0 ? from - part : from + part);
}

void fxl_intersection_vertex(const fxl_varying_vertex *inside, const fxl_varying_vertex *outside,
                             uint64_t fraction, uint32_t carried, fxl_varying_vertex *vertex)
{
    const fxl_view_point *from = &inside->position;
    const fxl_view_point *to = &outside->position;
    vertex->position.x = fxl_intersection_part(from->x, to->x, fraction);
    vertex->position.y = fxl_intersection_part(from->y, to->y, fraction);
    vertex->position.z = fxl_intersection_part(from->z, to->z, fraction);
    for (uint32_t i = 0; i < carried; i++) {
        vertex->carried[i] =
            fxl_intersection_varying(inside->carried[i], outside->carried[i], fraction);
    }
}

void fxl_copy_vertex(const fxl_varying_vertex *from, uint32_t carried, fxl_varying_vertex *to)
{
    to->position = from->position;
    for (uint32_t i = 0; i < carried; i++) {
        to->carried[i] = from->carried[i];
    }
}

#if !FXL_INTERSECTS_IN_ASSEMBLY

static fxl_q18_46 interpolate(fxl_q18_46 from, fxl_q18_46 to, uint64_t fraction)
{
    uint64_t part = fxl_multiply_high(fxl_magnitude(to - from), fraction);
    return to < from ? from - (int64_t)part : from + (int64_t)part;
}

/* SPEC 4.7, clippers 7.2 */
void fxl_intersect_edge(const fxl_view_point *from, const fxl_view_point *to,
                        const fxl_q18_46 *inside, const fxl_q18_46 *outside, fxl_view_point *point)
{
    FXL_ASSERT(*inside > 0 && *outside < 0);
    const uint64_t fraction =
        fxl_fraction((uint64_t)*inside, (uint64_t)*inside - fxl_bits_64(*outside));
    point->x = interpolate(from->x, to->x, fraction);
    point->y = interpolate(from->y, to->y, fraction);
    point->z = interpolate(from->z, to->z, fraction);
}

#endif
