/* SPDX-License-Identifier: MIT */
/* An edge on its first row: the kernel of this core's family. All give the same bits. Internal. */
#ifndef FXL_EDGE_NEAR_H
#define FXL_EDGE_NEAR_H

#include "../math/family.h"
#include "edge_divide.h"
#include "fixel/types.h"

#if FXL_KERNELS_ARMV6M

/* edge_near_armv6m.S */

bool fxl_edge_set_near(const fxl_screen_point *top, const fxl_screen_point *bottom, uint32_t last,
                       fxl_edge *edge);

#else

/* Sets an edge on the first row that it crosses, and its step. Returns false, with edge untouched,
 * if the edge does not hold from there to the row that is `last` rows below: see fxl_edge_set_far.
 * Requires two rows or more, so a height above 65535, and what fxl_edge_set requires. The dividends
 * are dx, for a step, and that of fxl_slope_set, for the first row, which is below height + |dx|
 * and so within FXL_EDGE_DIVIDEND_MAX. */
static inline bool fxl_edge_set_near(const fxl_screen_point *top, const fxl_screen_point *bottom,
                                     uint32_t last, fxl_edge *edge)
{
    int32_t dx = bottom->x - top->x;
    int32_t height = bottom->y - top->y;
    int32_t start = top->x - FXL_HALF_PIXEL;
    fxl_edge_divider divider = fxl_edge_divider_of((uint32_t)height);
    if (last >> fxl_edge_divider_shift(&divider) != 0) {
        return false;
    }
    int32_t x;
    fxl_edge_divide(&divider, fxl_edge_first_dividend(start, dx, height, top->y), &x,
                    &edge->fraction);
    edge->x = (start >> 16) + x + 1;
    fxl_edge_divide(&divider, dx, &edge->step, &edge->step_fraction);
    return true;
}

#endif

#endif
