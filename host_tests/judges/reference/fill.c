/* SPDX-License-Identifier: MIT */
#include "reference/fill.h"

void ref_fill_span(const ref_band *band, const ref_span *span, uint8_t colour)
{
    uint8_t *row = band->pixels + (span->y - band->first_row) * band->stride;
    for (int x = span->x0; x < span->x1; x++) {
        row[x] = colour;
    }
}

void ref_fill_band(const ref_band *band, uint8_t colour)
{
    for (int y = 0; y < band->rows; y++) {
        ref_span whole = {band->first_row + y, 0, band->width};
        ref_fill_span(band, &whole, colour);
    }
}
