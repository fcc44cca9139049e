/* SPDX-License-Identifier: MIT */
#include "is_rotation.h"

#include "arith.h"

/* A product of two rows, exact, in units of 2^-60. Requires components of at most 2^30 + 4, so that
 * each product is below 2^61 and the sum below 2^63. */
static int64_t row_product(const fxl_direction *a, const fxl_direction *b)
{
    return fxl_multiply_s32(a->x, b->x) + fxl_multiply_s32(a->y, b->y) +
           fxl_multiply_s32(a->z, b->z);
}

static bool is_row(const fxl_direction *row)
{
    const int64_t limit = (int64_t)FXL_Q2_30_ONE + 4;
    return fxl_within(row->x, limit) && fxl_within(row->y, limit) && fxl_within(row->z, limit) &&
           fxl_within(row_product(row, row) - ((int64_t)1 << 60), FXL_ROW_SQUARE_MAX_ERROR);
}

static bool are_square(const fxl_direction *a, const fxl_direction *b)
{
    return fxl_within(row_product(a, b), FXL_ROW_ANGLE_MAX_ERROR);
}

/* An entry of the cross product of two rows, as 2.30. The product of two rows at right angles has
 * the length of a row, so it fits. */
static int32_t cross(int32_t a, int32_t b, int32_t c, int32_t d)
{
    return (int32_t)((fxl_multiply_s32(a, b) - fxl_multiply_s32(c, d)) >> 30);
}

/* x cross y is z for a rotation, and -z for a mirror: the sign of its product with z tells them
 * apart. */
static bool is_mirror(const fxl_orientation *o)
{
    const fxl_direction z = {cross(o->x.y, o->y.z, o->x.z, o->y.y),
                             cross(o->x.z, o->y.x, o->x.x, o->y.z),
                             cross(o->x.x, o->y.y, o->x.y, o->y.x)};
    return row_product(&z, &o->z) < 0; /* bug: mirror-accepted */
}

bool fxl_is_rotation(const fxl_orientation *o)
{
    return is_row(&o->x) && is_row(&o->y) && is_row(&o->z) && are_square(&o->x, &o->y) &&
           are_square(&o->y, &o->z) && are_square(&o->z, &o->x) && !is_mirror(o);
}
