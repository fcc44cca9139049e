/* SPDX-License-Identifier: MIT */
#include "dither.h"

#include "../raster/columns.h"

#define HIGHEST 15u

static void prepare(uint16_t *entries, const uint8_t *palette)
{
    fxl_grey_table(entries, palette, HIGHEST);
}

/* formats 4.4 */
static void convert(const fxl_pixels *pixels, const fxl_band *band, uint8_t *out)
{
    const uint8_t *row = band->pixels;
    const fxl_pixel_kind kind = fxl_kind_of_band(band);
    const uint32_t end = fxl_band_end_column(band);
    for (uint32_t y = band->first_row; y < (uint32_t)band->first_row + band->rows; y++) {
        const uint8_t *dither = fxl_dither_row(y);
        uint32_t x = band->first_column;
        for (; x + 1u < end; x += 2) {
            const uint32_t left = fxl_dithered_pixel(pixels, row, kind, HIGHEST, dither, x);
            const uint32_t right =
                fxl_dithered_pixel(pixels, row, kind, HIGHEST, dither, x + 1u);
            *out++ = (uint8_t)(left << 4 | right);
        }
        if (x < end) {
            *out++ = (uint8_t)(fxl_dithered_pixel(pixels, row, kind, HIGHEST, dither, x) << 4);
        }
        row += fxl_pixel_bytes(kind, band->stride);
    }
}

const fxl_pixel_format fxl_pixels_grey4 = {4, 1, prepare, convert};
