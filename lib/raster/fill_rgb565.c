/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "../math/family.h"
#include "columns.h"
#include "fill.h"

/* Two pixels are one aligned word, but for the first and the last one. */
/* rgb565 1.2, 3.7 */
void fxl_fill_row_rgb565(uint16_t *pixel, uint16_t *end, uint16_t colour)
{
    if (pixel != end && ((uintptr_t)pixel & 2u) != 0) {
        *pixel++ = colour;
    }
    uint16_t *whole = pixel + ((end - pixel) & ~(ptrdiff_t)1);
    fxl_fill_row((uint8_t *)pixel, (uint8_t *)whole, colour * 0x00010001u);
    if (whole != end) {
        *whole = colour;
    }
}

/* rgb565 1.2 */
void fxl_fill_band_rgb565(const struct fxl_renderer *renderer, const fxl_band *band, uint8_t colour)
{
    (void)renderer;
    if (!fxl_band_is_even(band)) {
        return;
    }
    if (FXL_IS_COMPACT) {
        uint16_t *row = (uint16_t *)(void *)band->pixels;
        for (uint32_t rows = band->rows; rows > 0; rows--, row += band->stride) {
            fxl_fill_row_rgb565(row, row + fxl_band_columns(band), band->palette[colour]);
        }
        return;
    }
    const fxl_trapezoid rows = {(int16_t)band->first_row,
                                (int16_t)(band->first_row + band->rows),
                                {{0, 0, 0, 0}, {(int32_t)fxl_band_columns(band), 0, 0, 0}}};
    fxl_fill_trapezoid_rgb565(band, &rows, band->palette[colour]);
}

#if !FXL_KERNELS_ARMV6M && !FXL_KERNELS_ARMV7M

/* rgb565 1.2 */
void fxl_fill_trapezoid_rgb565(const fxl_band *band, const fxl_trapezoid *trapezoid,
                               uint16_t colour)
{
    FXL_ASSERT(trapezoid->first_row >= band->first_row &&
               trapezoid->first_row < trapezoid->end_row &&
               trapezoid->end_row <= band->first_row + band->rows);
    uint16_t *row = (uint16_t *)(void *)band->pixels +
                    (size_t)(trapezoid->first_row - band->first_row) * band->stride;
    fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
    for (int32_t rows = trapezoid->end_row - trapezoid->first_row; rows > 0; rows--) {
        if (a.x <= b.x) {
            fxl_fill_row_rgb565(row + a.x, row + b.x, colour);
        } else {
            fxl_fill_row_rgb565(row + b.x, row + a.x, colour);
        }
        fxl_edge_step(&a);
        fxl_edge_step(&b);
        row += band->stride;
    }
}

#endif
