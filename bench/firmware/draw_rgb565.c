/* SPDX-License-Identifier: MIT */
/* Draws with Fixel, and converts each frame to RGB565, in bands of eight rows. */
#define draw_frame draw_indices
#include "draw_fixel.c"
#undef draw_frame

#include "fixel/pixels.h"

#define BAND_ROWS 8u

static uint32_t converted[BAND_ROWS * FXL_SCREEN_MAX / 2u];
static fxl_pixels pixels;

bool draw_frame(const fxl_pose *pose, const fxl_band *whole)
{
    static uint8_t palette[3u * FXL_PALETTE_COLOURS]; /* which colours makes no difference */
    fxl_band band = *whole;

    if (!draw_indices(pose, whole)) {
        return false;
    }
    if (pixels.format == NULL && fxl_pixels_init(&pixels, &fxl_pixels_rgb565, palette) != FXL_OK) {
        return false;
    }
    for (uint32_t row = 0; row < whole->rows; row += BAND_ROWS) {
        const uint32_t left = whole->rows - row;
        band.pixels = whole->pixels + row * whole->stride;
        band.first_row = (uint16_t)row;
        band.rows = (uint16_t)(left < BAND_ROWS ? left : BAND_ROWS);
        if (fxl_pixels_convert(&pixels, &band, converted, sizeof converted) != FXL_OK) {
            return false;
        }
    }
    return true;
}
