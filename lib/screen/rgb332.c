/* SPDX-License-Identifier: MIT */
#include "fixel/pixels.h"

#include "../raster/columns.h"

/* The upper bits of each colour: it loses less than 32/255 of red and green, 64/255 of blue. */
/* pixels 1.1 */
static void prepare(uint16_t *entries, const uint8_t *palette)
{
    for (uint32_t i = 0; i < FXL_PALETTE_COLOURS; i++, palette += 3) {
        entries[i] = (uint16_t)((palette[0] & 0xE0u) | (palette[1] & 0xE0u) >> 3 | palette[2] >> 6);
    }
}

/* The same bits of a pixel of RGB565. */
static uint32_t entry_of_rgb565(uint32_t colour)
{
    return (colour >> 8 & 0xE0u) | (colour >> 6 & 0x1Cu) | (colour >> 3 & 3u);
}

static void convert(const fxl_pixels *pixels, const fxl_band *band, uint8_t *out)
{
    const uint8_t *row = band->pixels;
    const fxl_pixel_kind kind = fxl_kind_of_band(band);
    for (uint32_t rows = band->rows; rows > 0; rows--, row += fxl_pixel_bytes(kind, band->stride)) {
        for (uint32_t x = band->first_column; x < fxl_band_end_column(band); x++) {
            const uint32_t pixel = fxl_pixel_at(kind, row, x);
            *out++ =
                (uint8_t)(kind.is_colour ? entry_of_rgb565(pixel) : pixels->entries[pixel]);
        }
    }
}

/* place converter: a new file beside it */
const fxl_pixel_format fxl_pixels_rgb332 = {8, 1, prepare, convert};
