/* SPDX-License-Identifier: MIT */
#include "fixel/outcode.h"

#include "arith.h"
#include "fixel/clip_view.h"

/* floor(side * (across / 2^32) / 2^32). In units of 2^-12 that is the term
 * side * across, less than 1.25 too small: the factor that is cut off is below
 * 1, side at most 2^30. */
static inline int32_t upper_term(fxl_q2_30 side, fxl_q18_46 across)
{
    return (int32_t)((int64_t)side * (int32_t)(across >> 32) >> 32);
}

/* Exact, where the upper bits do not decide. */
static unsigned measure_pair(const fxl_view_frustum *frustum, int plane,
                             const fxl_view_point *point)
{
    unsigned first = fxl_view_distance(frustum, plane, point) < 0;
    unsigned second = fxl_view_distance(frustum, plane + 1, point) < 0;
    return (first | second << 1) << plane;
}

/* Whether an upper distance leaves the sign open. */
static inline bool is_open(int32_t distance)
{
    return (uint32_t)distance + 4u < 8u;
}

/* A pair of side planes, at distances depth +- across (less the inset, which
 * depth lacks already, rounded downward). Each true term exceeds its upper one by
 * 0 to 1.25, the true inset by 0 to 1: the true distance lies within -2.25..2.5
 * of the upper, so the latter has its sign where it is not within -4..3. The
 * sums are below 2^29. */
static inline unsigned pair_outside(const fxl_view_frustum *frustum, int plane, int32_t across,
                                    int32_t depth, const fxl_view_point *point)
{
    int32_t first = depth + across, second = depth - across;
    if (is_open(first) || is_open(second)) {
        return measure_pair(frustum, plane, point);
    }
    return ((uint32_t)first >> 31 | (uint32_t)second >> 31 << 1) << plane;
}

fxl_planes fxl_outcode(const fxl_view_frustum *frustum, fxl_planes planes,
                       const fxl_view_point *point)
{
    unsigned outside = 0;
    int32_t inset = (int32_t)(frustum->inset >> 34);
    if (planes & (1u << FXL_PLANE_LEFT | 1u << FXL_PLANE_RIGHT)) {
        outside |= pair_outside(frustum, FXL_PLANE_LEFT, upper_term(frustum->x_side, point->x),
                                upper_term(frustum->x_depth, point->z) - inset, point);
    }
    if (planes & (1u << FXL_PLANE_BOTTOM | 1u << FXL_PLANE_TOP)) {
        outside |= pair_outside(frustum, FXL_PLANE_BOTTOM, upper_term(frustum->y_side, point->y),
                                upper_term(frustum->y_depth, point->z) - inset, point);
    }
    outside |= (unsigned)(point->z < frustum->near) << FXL_PLANE_NEAR;
    outside |= (unsigned)(point->z > frustum->far) << FXL_PLANE_FAR;
    return (fxl_planes)(outside & planes);
}
