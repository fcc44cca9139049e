/* SPDX-License-Identifier: MIT */
#include "fixel/pixels.h"

#include "../raster/columns.h"

/* pixels 1.1 */
static void prepare(uint16_t *entries, const uint8_t *palette)
{
    for (uint32_t i = 0; i < FXL_PALETTE_COLOURS; i++, palette += 3) {
        entries[i] =
            (uint16_t)((palette[0] & 0xF8u) << 8 | (palette[1] & 0xFCu) << 3 | palette[2] >> 3);
    }
}

/* A byte a channel, red first. Below the bits of RGB565 stand its upper ones again, so that white
 * is 255 in each. */
static void write_bytes(uint8_t *out, uint32_t colour)
{
    out[0] = (uint8_t)((colour >> 8 & 0xF8u) | colour >> 13);
    out[1] = (uint8_t)((colour >> 3 & 0xFCu) | (colour >> 9 & 3u));
    out[2] = (uint8_t)((colour << 3 & 0xF8u) | (colour >> 2 & 7u));
}

static void convert(const fxl_pixels *pixels, const fxl_band *band, uint8_t *out)
{
    const uint8_t *row = band->pixels;
    const fxl_pixel_kind kind = fxl_kind_of_band(band);
    for (uint32_t rows = band->rows; rows > 0; rows--, row += fxl_pixel_bytes(kind, band->stride)) {
        for (uint32_t x = band->first_column; x < fxl_band_end_column(band); x++, out += 3) {
            const uint32_t pixel = fxl_pixel_at(kind, row, x);
            write_bytes(out, kind.is_colour ? pixel : pixels->entries[pixel]);
        }
    }
}

const fxl_pixel_format fxl_pixels_rgb666 = {24, 1, prepare, convert};
