/* SPDX-License-Identifier: MIT */
#include "dither.h"

#include "../math/memory.h"
#include "../raster/columns.h"

#define HIGHEST 1u

static void prepare(uint16_t *entries, const uint8_t *palette)
{
    fxl_grey_table(entries, palette, HIGHEST);
}

/* formats 4.4, pixels 1.2 */
static void convert_rows(const fxl_pixels *pixels, const fxl_band *band, uint8_t *out)
{
    const uint8_t *row = band->pixels;
    const fxl_pixel_kind kind = fxl_kind_of_band(band);
    const uint32_t first = band->first_column, end = fxl_band_end_column(band);
    for (uint32_t y = band->first_row; y < (uint32_t)band->first_row + band->rows; y++) {
        const uint8_t *dither = fxl_dither_row(y);
        uint32_t byte = 1; /* with eight more bits behind this 1 it is full */
        for (uint32_t x = first; x < end; x++) {
            byte = byte << 1 | fxl_dithered_pixel(pixels, row, kind, HIGHEST, dither, x);
            if (byte > 0xFFu) {
                *out++ = (uint8_t)byte;
                byte = 1;
            }
        }
        if (byte > 1) {
            while (byte <= 0xFFu) {
                byte <<= 1;
            }
            *out++ = (uint8_t)byte;
        }
        row += fxl_pixel_bytes(kind, band->stride);
    }
}

/* pixels 1.2 */
static void convert_pages(const fxl_pixels *pixels, const fxl_band *band, uint8_t *out)
{
    const uint8_t *row = band->pixels;
    const fxl_pixel_kind kind = fxl_kind_of_band(band);
    const uint32_t first = band->first_column, end = fxl_band_end_column(band);
    memset(out, 0, fxl_pixels_size(pixels->format, (uint16_t)(end - first), band->rows));
    for (uint32_t y = 0; y < band->rows; y++) { /* first_row is a multiple of 8 */
        const uint8_t *dither = fxl_dither_row(y);
        uint8_t *page = out + (size_t)(y / 8u) * (end - first);
        for (uint32_t x = first; x < end; x++) {
            const uint32_t level =
                fxl_dithered_pixel(pixels, row, kind, HIGHEST, dither, x);
            page[x - first] = (uint8_t)(page[x - first] | level << (y & 7u));
        }
        row += fxl_pixel_bytes(kind, band->stride);
    }
}

const fxl_pixel_format fxl_pixels_mono_rows = {1, 1, prepare, convert_rows};
const fxl_pixel_format fxl_pixels_mono_pages = {1, 8, prepare, convert_pages};
