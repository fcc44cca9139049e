/* SPDX-License-Identifier: MIT */
#include "fixel/fill.h"

#include "arith.h"
#include "fill_rows.h"

static uint8_t *row_of(const fxl_band *band, int32_t row)
{
    FXL_ASSERT(row >= band->first_row && row < band->first_row + band->rows);
    return band->pixels + (size_t)(row - band->first_row) * band->stride;
}

void fxl_fill_trapezoid(const fxl_band *band, const fxl_trapezoid *trapezoid, uint8_t colour)
{
    FXL_ASSERT(trapezoid->first_row < trapezoid->end_row &&
               trapezoid->end_row <= band->first_row + band->rows);
    fxl_fill_rows(row_of(band, trapezoid->first_row), band->stride, trapezoid, colour);
}

void fxl_fill_span(const fxl_band *band, const fxl_span *span, uint8_t colour)
{
    FXL_ASSERT(span->x0 >= 0 && span->x0 < span->x1 && span->x1 <= band->width);
    const fxl_trapezoid row = {
        span->y, (int16_t)(span->y + 1), {{span->x0, 0, 0, 0}, {span->x1, 0, 0, 0}}};
    fxl_fill_rows(row_of(band, span->y), band->stride, &row, colour);
}

void fxl_fill_band(const fxl_band *band, uint8_t colour)
{
    const fxl_trapezoid rows = {0, (int16_t)band->rows, {{0, 0, 0, 0}, {band->width, 0, 0, 0}}};
    fxl_fill_rows(band->pixels, band->stride, &rows, colour);
}
