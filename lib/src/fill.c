/* SPDX-License-Identifier: MIT */
#include "fixel/fill.h"

#include <string.h>

#include "arith.h"

void fxl_fill_span(const fxl_band *band, const fxl_span *span, uint8_t colour)
{
    FXL_ASSERT(span->y >= band->first_row && span->y < band->first_row + band->rows);
    FXL_ASSERT(span->x0 >= 0 && span->x0 < span->x1 && span->x1 <= band->width);
    size_t row = (size_t)(span->y - band->first_row);
    uint8_t *pixels = band->pixels + row * band->stride;
    memset(pixels + span->x0, colour, (size_t)(span->x1 - span->x0));
}

void fxl_fill_band(const fxl_band *band, uint8_t colour)
{
    for (size_t row = 0; row < band->rows; row++) {
        memset(band->pixels + row * band->stride, colour, band->width);
    }
}
