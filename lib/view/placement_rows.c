/* SPDX-License-Identifier: MIT */
#include "placement.h"
#include "placement.h"

#include "../math/arith.h"
#include "../math/family.h"

#if !FXL_PLACEMENTS_IN_ASSEMBLY

/* A row of the view along a column of the orientation. Both may have an entry of -2^30 - 4, so
 * fxl_multiply_s31 would not do. */
static inline fxl_q2_30 along(const fxl_direction *row, int32_t x, int32_t y, int32_t z)
{
    return (fxl_q2_30)fxl_round_shift(fxl_multiply_s32(row->x, x) + fxl_multiply_s32(row->y, y) +
                                          fxl_multiply_s32(row->z, z),
                                      30);
}

static void turn_row(const fxl_direction *row, const fxl_orientation *of, fxl_direction *to)
{
    to->x = along(row, of->x.x, of->y.x, of->z.x);
    to->y = along(row, of->x.y, of->y.y, of->z.y);
    to->z = along(row, of->x.z, of->y.z, of->z.z);
}

void fxl_placement_rows(const fxl_axes *view, const fxl_orientation *of, fxl_axes *matrix)
{
    turn_row(&view->right, of, &matrix->right);
    turn_row(&view->up, of, &matrix->up);
    turn_row(&view->forward, of, &matrix->forward);
}

#endif
