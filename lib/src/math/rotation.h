/* SPDX-License-Identifier: MIT */
/* Whether three rows are a rotation, and how far a turned model reaches. Internal. */
#ifndef FXL_ROTATION_H
#define FXL_ROTATION_H

#include "arith.h"

/* Whether a and b are within 2^-28 of a right angle. Components below 2^30 + 2^3 keep every product
 * below 2^61 and the sum below 2^63. */
static inline bool fxl_are_perpendicular(const fxl_direction *a, const fxl_direction *b)
{
    return fxl_within((int64_t)a->x * b->x + (int64_t)a->y * b->y + (int64_t)a->z * b->z,
                      (int64_t)1 << 32);
}

/* Whether the length is within 2^-28 of 1: the squared length within 2^-27, to within 2^-56. */
static inline bool fxl_is_row(const fxl_direction *row)
{
    const int64_t limit = (int64_t)FXL_Q2_30_ONE + 4;
    if (!fxl_within(row->x, limit) || !fxl_within(row->y, limit) || !fxl_within(row->z, limit)) {
        return false;
    }
    const int64_t square =
        (int64_t)row->x * row->x + (int64_t)row->y * row->y + (int64_t)row->z * row->z;
    return fxl_within(square - (int64_t)FXL_Q2_30_ONE * FXL_Q2_30_ONE, (int64_t)1 << 33);
}

/* Whether the rows are within 2^-28 of unit length and of right angles, and no mirror image. The
 * sign of one component of x cross y says so where z has that component: where z's largest one has
 * the sign of the cross product's. Both products are below 2^61. */
static inline bool fxl_is_rotation(const fxl_orientation *orientation)
{
    const fxl_direction *x = &orientation->x, *y = &orientation->y, *z = &orientation->z;
    if (!fxl_is_row(x) || !fxl_is_row(y) || !fxl_is_row(z) || !fxl_are_perpendicular(x, y) ||
        !fxl_are_perpendicular(y, z) || !fxl_are_perpendicular(z, x)) {
        return false;
    }
    /* The cross product is z or -z to within a few units, so its largest component is 0.57 at
     * least. */
    const uint64_t in_x = fxl_magnitude(z->x), in_y = fxl_magnitude(z->y),
                   in_z = fxl_magnitude(z->z);
    if (in_x >= in_y && in_x >= in_z) {
        return ((int64_t)x->y * y->z > (int64_t)x->z * y->y) == (z->x > 0);
    }
    return in_y >= in_z ? ((int64_t)x->z * y->x > (int64_t)x->x * y->z) == (z->y > 0)
                        : ((int64_t)x->x * y->y > (int64_t)x->y * y->x) == (z->z > 0);
}

#define FXL_SCALE_LEAST FXL_CAST(fxl_q16_16, 256)
#define FXL_SCALE_MOST  FXL_CAST(fxl_q16_16, 256 * 65536)

/* Whether a turn may be drawn. */
static inline bool fxl_turn_in_range(const fxl_turn *turn)
{
    return turn->scale >= FXL_SCALE_LEAST && turn->scale <= FXL_SCALE_MOST &&
           fxl_is_rotation(&turn->orientation);
}

#endif
