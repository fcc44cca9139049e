/* SPDX-License-Identifier: MIT */
#include "edge.h"

/* The edge starts from the exact remainder on the row, so the rows for which it holds count from
 * there. */
int32_t fxl_edge_set_far(const fxl_screen_point *top, const fxl_screen_point *bottom, int32_t row,
                         int32_t rows, fxl_edge *edge)
{
    fxl_slope slope;
    fxl_slope_set(top, bottom, fxl_centre_of(row), &slope);
    fxl_edge_divider divider = fxl_edge_divider_of(slope.height);
    int32_t unused;
    fxl_edge_divide(&divider, (int32_t)slope.error, &unused, &edge->fraction);
    fxl_edge_divide(&divider, (int32_t)slope.error_step, &unused, &edge->step_fraction);
    edge->x = slope.x;
    edge->step = slope.step;
    uint32_t good = 1u << fxl_edge_divider_shift(&divider);
    return good < (uint32_t)rows ? (int32_t)good : rows;
}
