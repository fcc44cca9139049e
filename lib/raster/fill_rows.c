/* SPDX-License-Identifier: MIT */

#include "../math/arith.h"
#include "../math/family.h"
#include "fill.h"

#if !FXL_KERNELS_ARMV6M && !FXL_KERNELS_ARMV7M

void fxl_fill_trapezoid(const fxl_band *band, const fxl_trapezoid *trapezoid, uint8_t colour)
{
    FXL_ASSERT(trapezoid->first_row >= band->first_row &&
               trapezoid->first_row < trapezoid->end_row &&
               trapezoid->end_row <= band->first_row + band->rows);
    const uint32_t four = colour * 0x01010101u;
    uint8_t *row = band->pixels + (size_t)(trapezoid->first_row - band->first_row) * band->stride;
    fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
    for (int32_t rows = trapezoid->end_row - trapezoid->first_row; rows > 0; rows--) {
        if (a.x <= b.x) {
            fxl_fill_row(row + a.x, row + b.x, four);
        } else {
            fxl_fill_row(row + b.x, row + a.x, four);
        }
        fxl_edge_step(&a);
        fxl_edge_step(&b);
        row += band->stride;
    }
}

#endif
