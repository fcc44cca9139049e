/* SPDX-License-Identifier: MIT */
#include "fixel/pixels.h"

#include "../math/family.h"
#include "../math/memory.h"
#include "../raster/columns.h"
#include "../raster/fill.h"

/* The upper bits of each colour: it loses less than 8/255 of red and blue, 4/255 of green. The
 * bytes stand in the table as they are sent, whatever the byte order of the core. */
/* pixels 1.1 */
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

/* Whether the byte of a pixel that a core has first is the one with red. */
static bool core_has_red_first(void)
{
    const uint16_t red = 0xF800;
    return *(const uint8_t *)&red != 0;
}

/* Copies pixels of RGB565 with their bytes swapped: two at a time where both are aligned alike.
 * Compilers know the expression of a word: an instruction on cores that have it. */
static void copy_swapped(uint16_t *out, const uint16_t *pixels, uint32_t count)
{
    const uint16_t *end = pixels + count;
    while (pixels != end) {
        if (!FXL_IS_SMALL && end - pixels >= 2 && (((uintptr_t)pixels | (uintptr_t)out) & 3u) == 0) {
            const uint32_t two = *(const fxl_word *)(const void *)pixels;
            *(fxl_word *)(void *)out = (two & 0x00FF00FFu) << 8 | (two >> 8 & 0x00FF00FFu);
            pixels += 2;
            out += 2;
            continue;
        }
        *out++ = (uint16_t)(*pixels << 8 | *pixels >> 8);
        pixels++;
    }
}

/* A band of palette indices, or of RGB565, whose pixels need their bytes in order alone. */
static inline void convert(const fxl_pixels *pixels, const fxl_band *band, uint8_t *out,
                           bool red_first)
{
    const fxl_pixel_kind kind = fxl_kind_of_band(band);
    const uint32_t columns = fxl_band_columns(band);
    const uint8_t *row = band->pixels + fxl_pixel_bytes(kind, band->first_column);
    for (uint32_t rows = band->rows; rows > 0; rows--, row += fxl_pixel_bytes(kind, band->stride)) {
        uint16_t *to = (uint16_t *)(void *)out;
        if (!kind.is_colour) {
            fxl_row_to_16(row, columns, pixels->entries, to);
        } else if (red_first != core_has_red_first()) {
            copy_swapped(to, (const uint16_t *)(const void *)row, columns);
        } else {
            memcpy(to, row, 2u * columns);
        }
        out += 2u * columns;
    }
}

static void convert_high(const fxl_pixels *pixels, const fxl_band *band, uint8_t *out)
{
    convert(pixels, band, out, true);
}

static void convert_low(const fxl_pixels *pixels, const fxl_band *band, uint8_t *out)
{
    convert(pixels, band, out, false);
}

const fxl_pixel_format fxl_pixels_rgb565 = {16, 1, prepare_high, convert_high};
const fxl_pixel_format fxl_pixels_rgb565_low = {16, 1, prepare_low, convert_low};

/* rgb565 1.1 */
void fxl_swap_rgb565(const fxl_band *band)
{
    uint16_t *row = (uint16_t *)(void *)band->pixels;
    for (uint32_t rows = band->rows; rows > 0; rows--, row += band->stride) {
        copy_swapped(row, row, fxl_band_columns(band));
    }
}
