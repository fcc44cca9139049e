/* SPDX-License-Identifier: MIT */
#include "../raster/fill.h"
#include "overlay_band.h"

fxl_status fxl_overlay_check(const fxl_band *band)
{
    if (band == NULL || band->pixels == NULL) {
        return FXL_E_ARGUMENT;
    }
    return band->width >= 1 && band->width <= FXL_SCREEN_MAX && band->stride >= band->width &&
                   band->rows >= 1 && band->first_row + band->rows <= FXL_SCREEN_MAX
               ? FXL_OK
               : FXL_E_RANGE;
}

static void fill(const fxl_band *band, int64_t x, int64_t y, int64_t width, int64_t height,
                 uint8_t colour)
{
    const fxl_stretch columns = fxl_clip_stretch(x, width, 0, band->width);
    const fxl_stretch rows =
        fxl_clip_stretch(y, height, band->first_row, band->first_row + band->rows);
    for (int32_t row = rows.first; row < rows.end && columns.first < columns.end; row++) {
        const fxl_span span = {(int16_t)row, (int16_t)columns.first, (int16_t)columns.end};
        fxl_fill_span(band, &span, colour);
    }
}

fxl_status fxl_draw_rectangle(const fxl_band *band, int32_t x, int32_t y, int32_t width,
                              int32_t height, uint8_t colour)
{
    const fxl_status status = fxl_overlay_check(band);
    if (status == FXL_OK) {
        fill(band, x, y, width, height, colour);
    }
    return status;
}

fxl_status fxl_draw_border(const fxl_band *band, int32_t x, int32_t y, int32_t width,
                           int32_t height, uint8_t colour)
{
    const fxl_status status = fxl_overlay_check(band);
    if (status == FXL_OK && width > 0 && height > 0) {
        fill(band, x, y, width, 1, colour);
        fill(band, x, (int64_t)y + height - 1, width, 1, colour);
        fill(band, x, y, 1, height, colour);
        fill(band, (int64_t)x + width - 1, y, 1, height, colour);
    }
    return status;
}
