/* SPDX-License-Identifier: MIT */
#include "fixel/rgb565.h"

void fxl_swap_rgb565(const fxl_band_565 *band)
{
    uint16_t *row = band->pixels;
    for (uint32_t rows = band->rows; rows > 0; rows--, row += band->stride) {
        for (uint32_t x = 0; x < band->width; x++) {
            row[x] = (uint16_t)(row[x] << 8 | row[x] >> 8);
        }
    }
}
