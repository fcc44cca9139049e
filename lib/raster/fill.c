/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "../math/family.h"
#include "../math/memory.h"
#include "columns.h"
#include "fill.h"
#include "fixel/target.h"

/* In a library for size a row is a call of memset, and no trapezoid is filled here: 110 bytes less
 * on a Cortex-M3, and 240 with FXL_SMALL. */
/* SPEC 4.9 */
void fxl_fill_span(const fxl_band *band, const fxl_span *span, uint8_t colour)
{
    FXL_ASSERT(span->x0 >= 0 && span->x0 < span->x1 && span->x1 <= band->width);
    if (FXL_IS_COMPACT) {
        uint8_t *row = band->pixels + (size_t)(span->y - band->first_row) * band->stride;
        memset(row + span->x0, colour, (size_t)(span->x1 - span->x0));
        return;
    }
    const fxl_trapezoid row = {
        span->y, (int16_t)(span->y + 1), {{span->x0, 0, 0, 0}, {span->x1, 0, 0, 0}}};
    fxl_fill_trapezoid(band, &row, colour);
}

void fxl_fill_band_palette(const struct fxl_renderer *renderer, const fxl_band *band,
                           uint8_t colour)
{
    (void)renderer;
    if (FXL_IS_COMPACT) {
        for (uint32_t row = 0; row < band->rows; row++) {
            memset(band->pixels + (size_t)row * band->stride, colour, fxl_band_columns(band));
        }
        return;
    }
    const fxl_trapezoid rows = {(int16_t)band->first_row,
                                (int16_t)(band->first_row + band->rows),
                                {{0, 0, 0, 0}, {(int32_t)fxl_band_columns(band), 0, 0, 0}}};
    fxl_fill_trapezoid(band, &rows, colour);
}

void fxl_fill_band(const fxl_band *band, uint8_t colour)
{
    fxl_fill_band_palette(NULL, band, colour);
}

#if !FXL_KERNELS_ARMV6M && !FXL_KERNELS_ARMV7M

/* SPEC 4.9 */
void fxl_fill_trapezoid(const fxl_band *band, const fxl_trapezoid *trapezoid, uint8_t colour)
{
    FXL_ASSERT(trapezoid->first_row >= band->first_row &&
               trapezoid->first_row < trapezoid->end_row &&
               trapezoid->end_row <= band->first_row + band->rows);
    const uint32_t four = colour * 0x01010101u, stride = band->stride;
    uint8_t *row = band->pixels + (size_t)(trapezoid->first_row - band->first_row) * stride;
    fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
    for (int32_t rows = trapezoid->end_row - trapezoid->first_row; rows > 0; rows--) {
        if (a.x <= b.x) {
            fxl_fill_row(row + a.x, row + b.x, four);
        } else {
            fxl_fill_row(row + b.x, row + a.x, four);
        }
        fxl_edge_step(&a);
        fxl_edge_step(&b);
        row += stride;
    }
}

#endif
