/* SPDX-License-Identifier: MIT */
#include "fixel/fill.h"

#include <string.h>

#include "arith.h"

void fxl_fill_span(const fxl_band *band, const fxl_span *span, uint8_t colour)
{
    FXL_ASSERT(span->x0 >= 0 && span->x0 < span->x1 && span->x1 <= band->width);
    memset(band->pixels + (size_t)(span->y - band->first_row) * band->stride + span->x0, colour,
           (size_t)(span->x1 - span->x0));
}

void fxl_fill_band(const fxl_band *band, uint8_t colour)
{
    uint8_t *row = band->pixels;
    for (uint32_t rows = band->rows; rows != 0; rows--) {
        memset(row, colour, band->width);
        row += band->stride;
    }
}
