/* SPDX-License-Identifier: MIT */
/* The outcode, for those that work it out together with something else.
 * Internal. */
#ifndef FXL_OUTSIDE_H
#define FXL_OUTSIDE_H

#include "arith.h"
#include "fixel/outcode.h"

/* Those of a pair of side planes, plane and plane + 1, that a point is outside
 * of: exact, for where the upper bits do not decide. */
unsigned fxl_outside_of_pair(const fxl_view_frustum *frustum, int plane,
                             const fxl_view_point *point);

/* floor(side * (across / 2^32) / 2^32). In units of 2^-12 that is the term
 * side * across, less than 1.25 too small: the factor that is cut off is below
 * 1, side at most 2^30. */
static inline int32_t fxl_upper_term(fxl_q2_30 side, fxl_q18_46 across)
{
    return (int32_t)(fxl_multiply_s31(side, (int32_t)((uint64_t)across >> 32)) >> 32);
}

/* Whether an upper distance leaves the sign open. */
static inline bool fxl_is_open(int32_t distance)
{
    return (uint32_t)distance + 4u < 8u; /* bug: outcode-soon */
}

/* A pair of side planes, at distances depth +- across (less the inset, which
 * depth lacks already, rounded downward). Each true term exceeds its upper one by
 * 0 to 1.25, the true inset by 0 to 1: the true distance lies within -2.25..2.5
 * of the upper, so the latter has its sign where it is not within -4..3. The
 * sums are below 2^29. */
static inline unsigned fxl_pair_outside(const fxl_view_frustum *frustum, int plane, int32_t across,
                                        int32_t depth, const fxl_view_point *point)
{
    int32_t first = depth + across, second = depth - across;
    if (fxl_is_open(first) || fxl_is_open(second)) {
        return fxl_outside_of_pair(frustum, plane, point);
    }
    return ((uint32_t)first >> 31 | (uint32_t)second >> 31 << 1) << plane;
}

static inline fxl_planes fxl_outside(const fxl_view_frustum *frustum, fxl_planes planes,
                                     const fxl_view_point *point)
{
    unsigned outside = 0;
    int32_t inset = (int32_t)(frustum->inset >> 34);
    if (planes & (1u << FXL_PLANE_LEFT | 1u << FXL_PLANE_RIGHT)) {
        outside |=
            fxl_pair_outside(frustum, FXL_PLANE_LEFT, fxl_upper_term(frustum->x_side, point->x),
                             fxl_upper_term(frustum->x_depth, point->z) - inset, point);
    }
    if (planes & (1u << FXL_PLANE_BOTTOM | 1u << FXL_PLANE_TOP)) {
        outside |=
            fxl_pair_outside(frustum, FXL_PLANE_BOTTOM, fxl_upper_term(frustum->y_side, point->y),
                             fxl_upper_term(frustum->y_depth, point->z) - inset, point);
    }
    outside |= (unsigned)(point->z < frustum->near) << FXL_PLANE_NEAR;
    outside |= (unsigned)(point->z > frustum->far) << FXL_PLANE_FAR;
    return (fxl_planes)(outside & planes);
}

#endif
