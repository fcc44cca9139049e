/* SPDX-License-Identifier: MIT */
#include "fixel/fill.h"

#include <string.h>

#include "arith.h"
#include "edge.h"

/* Rows are the C library's to fill: a program has memset anyway. */
void fxl_fill_trapezoid(const fxl_band *band, const fxl_trapezoid *trapezoid, uint8_t colour)
{
    FXL_ASSERT(trapezoid->first_row >= band->first_row &&
               trapezoid->first_row < trapezoid->end_row &&
               trapezoid->end_row <= band->first_row + band->rows);
    uint8_t *row = band->pixels + (size_t)(trapezoid->first_row - band->first_row) * band->stride;
    fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
    for (int32_t rows = trapezoid->end_row - trapezoid->first_row; rows > 0; rows--) {
        int32_t from = a.x < b.x ? a.x : b.x;
        memset(row + from, colour, (size_t)(a.x + b.x - 2 * from));
        fxl_edge_advance(&a, 1);
        fxl_edge_advance(&b, 1);
        row += band->stride;
    }
}
