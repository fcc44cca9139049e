/* SPDX-License-Identifier: MIT */
#include "fixel/stage/fill.h"

#include <string.h>

#include "../math/arith.h"

/* The kernels in assembly have the offsets of these members, for pointers of 32 bits. */
#ifdef __arm__
_Static_assert(offsetof(fxl_band, pixels) == 0 && offsetof(fxl_band, stride) == 6 &&
                   offsetof(fxl_band, first_row) == 8,
               "fill_rows.S");
_Static_assert(offsetof(fxl_trapezoid, end_row) == 2 && offsetof(fxl_trapezoid, edges) == 4 &&
                   offsetof(fxl_edge, fraction) == 4 && offsetof(fxl_edge, step) == 8 &&
                   offsetof(fxl_edge, step_fraction) == 12 && sizeof(fxl_edge) == 16,
               "fill_rows.S");
#endif

/* With FXL_SMALL a row is a call of memset, and no trapezoid is filled: 240 bytes less on a
 * Cortex-M3, and fewer instructions. */
void fxl_fill_span(const fxl_band *band, const fxl_span *span, uint8_t colour)
{
    FXL_ASSERT(span->x0 >= 0 && span->x0 < span->x1 && span->x1 <= band->width);
    if (FXL_IS_SMALL) {
        uint8_t *row = band->pixels + (size_t)(span->y - band->first_row) * band->stride;
        memset(row + span->x0, colour, (size_t)(span->x1 - span->x0));
        return;
    }
    const fxl_trapezoid row = {
        span->y, (int16_t)(span->y + 1), {{span->x0, 0, 0, 0}, {span->x1, 0, 0, 0}}};
    fxl_fill_trapezoid(band, &row, colour);
}

void fxl_fill_band(const fxl_band *band, uint8_t colour)
{
    if (FXL_IS_SMALL) {
        for (uint32_t row = 0; row < band->rows; row++) {
            memset(band->pixels + (size_t)row * band->stride, colour, band->width);
        }
        return;
    }
    const fxl_trapezoid rows = {(int16_t)band->first_row,
                                (int16_t)(band->first_row + band->rows),
                                {{0, 0, 0, 0}, {band->width, 0, 0, 0}}};
    fxl_fill_trapezoid(band, &rows, colour);
}
