/* SPDX-License-Identifier: MIT */
#include "fixel/pixels.h"

#include "../raster/columns.h"

fxl_status fxl_pixels_init(fxl_pixels *pixels, const fxl_pixel_format *format,
                           const uint8_t *palette)
{
    if (pixels == NULL || format == NULL || palette == NULL || format->prepare == NULL ||
        format->convert == NULL || format->rows == 0) {
        return FXL_E_ARGUMENT;
    }
    pixels->format = format;
    format->prepare(pixels->entries, palette);
    return FXL_OK;
}

/* pixels 1.2 */
size_t fxl_pixels_size(const fxl_pixel_format *format, uint16_t width, uint16_t rows)
{
    if (format == NULL || format->rows == 0) {
        return 0;
    }
    const size_t lines = ((size_t)rows + format->rows - 1u) / format->rows;
    /* A row of a byte's height has 24 * 65535 bits at most. */
    const size_t line = format->rows > 1 ? width : ((size_t)width * format->bits + 7u) / 8u;
    return lines * line; /* < 2^16 * 2^18 */
}

fxl_status fxl_pixels_convert(const fxl_pixels *pixels, const fxl_band *band, void *out,
                              size_t size)
{
    if (pixels == NULL || band == NULL || out == NULL || band->pixels == NULL || band->width == 0 ||
        band->rows == 0) {
        return FXL_E_ARGUMENT;
    }
    if (pixels->format == NULL) {
        return FXL_E_ORDER;
    }
    if (((uintptr_t)out & 3u) != 0 || !fxl_band_is_aligned(band)) {
        return FXL_E_ALIGNMENT;
    }
    if (!fxl_band_is_within(band, band->width, UINT32_MAX) ||
        band->first_row % pixels->format->rows != 0) {
        return FXL_E_RANGE;
    }
    if (size < fxl_pixels_size(pixels->format, (uint16_t)fxl_band_columns(band), band->rows)) {
        return FXL_E_CAPACITY;
    }
    fxl_band from_0 = *band;
    fxl_band_begin_at_column_0(&from_0);
    pixels->format->convert(pixels, &from_0, (uint8_t *)out);
    return FXL_OK;
}
