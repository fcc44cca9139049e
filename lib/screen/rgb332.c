/* SPDX-License-Identifier: MIT */
#include "fixel/pixels.h"

/* The upper bits of each colour: it loses less than 32/255 of red and green, 64/255 of blue. */
static void prepare(uint16_t *entries, const uint8_t *palette)
{
    for (uint32_t i = 0; i < FXL_PALETTE_COLOURS; i++, palette += 3) {
        entries[i] = (uint16_t)((palette[0] & 0xE0u) | (palette[1] & 0xE0u) >> 3 | palette[2] >> 6);
    }
}

static void convert(const fxl_pixels *pixels, const fxl_band *band, uint8_t *out)
{
    const uint8_t *row = band->pixels;
    for (uint32_t rows = band->rows; rows > 0; rows--, row += band->stride) {
        for (uint32_t x = 0; x < band->width; x++) {
            *out++ = (uint8_t)pixels->entries[row[x]];
        }
    }
}

const fxl_pixel_format fxl_pixels_rgb332 = {8, 1, prepare, convert};
