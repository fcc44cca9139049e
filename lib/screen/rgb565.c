/* SPDX-License-Identifier: MIT */
#include "fixel/pixels.h"

/* The upper bits of each colour: it loses less than 8/255 of red and blue, 4/255 of green. The
 * bytes stand in the table as they are sent, whatever the byte order of the core. */
static void prepare(uint16_t *entries, const uint8_t *palette, uint32_t high, uint32_t low)
{
    uint8_t *bytes = (uint8_t *)entries;
    for (uint32_t i = 0; i < FXL_PALETTE_COLOURS; i++, bytes += 2, palette += 3) {
        bytes[high] = (uint8_t)((palette[0] & 0xF8u) | palette[1] >> 5);
        bytes[low] = (uint8_t)((palette[1] & 0x1Cu) << 3 | palette[2] >> 3);
    }
}

static void prepare_high(uint16_t *entries, const uint8_t *palette)
{
    prepare(entries, palette, 0, 1);
}

static void prepare_low(uint16_t *entries, const uint8_t *palette)
{
    prepare(entries, palette, 1, 0);
}

static void convert(const fxl_pixels *pixels, const fxl_band *band, uint8_t *out)
{
    const uint8_t *row = band->pixels;
    for (uint32_t rows = band->rows; rows > 0; rows--, row += band->stride) {
        fxl_row_to_16(row, band->width, pixels->entries, (uint16_t *)(void *)out);
        out += 2u * band->width;
    }
}

const fxl_pixel_format fxl_pixels_rgb565 = {16, 1, prepare_high, convert};
const fxl_pixel_format fxl_pixels_rgb565_low = {16, 1, prepare_low, convert};
