/* SPDX-License-Identifier: MIT */
#include "fixel/fill.h"

#include <string.h>

#include "edge.h"

/* Rows are the C library's to fill: a program has memset anyway. */
void fxl_fill_trapezoid(const fxl_band *band, const fxl_trapezoid *trapezoid, uint8_t colour)
{
    FXL_ASSERT(trapezoid->first_row >= band->first_row &&
               trapezoid->first_row < trapezoid->end_row &&
               trapezoid->end_row <= band->first_row + band->rows);
    for (int32_t row = trapezoid->first_row; row < trapezoid->end_row; row++) {
        const uint32_t rows = (uint32_t)(row - trapezoid->first_row);
        int32_t x[2];
        for (uint32_t side = 0; side < 2; side++) {
            const fxl_edge *edge = &trapezoid->edges[side];
            uint64_t fraction = edge->fraction + fxl_multiply_u32(edge->step_fraction, rows);
            x[side] = edge->x + edge->step * (int32_t)rows + (int32_t)(fraction >> 32);
        }
        int32_t x0 = x[0] < x[1] ? x[0] : x[1];
        memset(band->pixels + (row - band->first_row) * band->stride + x0, colour,
               (size_t)(x[0] + x[1] - 2 * x0));
    }
}
