/* SPDX-License-Identifier: MIT */
/* A frame in bands of so many rows. */
#ifndef BENCH_BANDS_H
#define BENCH_BANDS_H

#include "fixel/render.h"

#define NOT_CLEARED (-1)

/* Draws a frame into a band of the whole screen. background: the colour that each band is filled
 * with first, or NOT_CLEARED. False where the renderer refused. */
static inline bool draw_in_bands(fxl_renderer *renderer, const fxl_pose *pose,
                                 const fxl_band *whole, uint32_t rows, int background)
{
    const uint32_t row_bytes = whole->stride * (renderer->target->pixel_bits / 8u);
    fxl_band band = *whole;

    if (fxl_frame_begin(renderer, pose) != FXL_OK) {
        return false;
    }
    for (uint32_t row = 0; row < whole->rows; row += rows) {
        const uint32_t left = whole->rows - row;
        band.pixels = whole->pixels + row * row_bytes;
        band.first_row = (uint16_t)row;
        band.rows = (uint16_t)(left < rows ? left : rows);
        if (background != NOT_CLEARED) {
            renderer->target->fill(&band, (uint8_t)background);
        }
        if (fxl_frame_draw(renderer, &band) != FXL_OK) {
            return false;
        }
    }
    return true;
}

#endif
