/* SPDX-License-Identifier: MIT */
#include "../raster/fill.h"
#include "rgb565_colour.h"

/* Two pixels are one aligned word, but for the first and the last one. */
void fxl_fill_row_rgb565(uint16_t *pixel, uint16_t *end, uint16_t colour)
{
    if (pixel != end && ((uintptr_t)pixel & 2u) != 0) {
        *pixel++ = colour;
    }
    uint16_t *whole = pixel + ((end - pixel) & ~(ptrdiff_t)1);
    fxl_fill_row((uint8_t *)pixel, (uint8_t *)whole, colour * 0x00010001u);
    if (whole != end) {
        *whole = colour;
    }
}
