/* SPDX-License-Identifier: MIT */
#include "reference/fill.h"

#include <stddef.h>

static ptrdiff_t place_of(const ref_band *band, int x, int y)
{
    return (ptrdiff_t)(y - band->first_row) * band->stride + x;
}

uint16_t ref_pixel(const ref_band *band, int x, int y)
{
    const ptrdiff_t place = place_of(band, x, y);
    return band->pixels ? band->pixels[place] : band->pixels_16[place];
}

void ref_fill_span(const ref_band *band, const ref_span *span, uint16_t colour)
{
    for (int x = span->x0; x < span->x1; x++) {
        const ptrdiff_t place = place_of(band, x, span->y);
        if (band->pixels) {
            band->pixels[place] = (uint8_t)colour;
        } else {
            band->pixels_16[place] = colour;
        }
    }
}

void ref_fill_band(const ref_band *band, uint16_t colour)
{
    for (int y = 0; y < band->rows; y++) {
        ref_span whole = {band->first_row + y, 0, band->width};
        ref_fill_span(band, &whole, colour);
    }
}
