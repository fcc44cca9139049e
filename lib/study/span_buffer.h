/* SPDX-License-Identifier: MIT */
/* The span buffer (C5) keeps, for each row of a band, the pixels that are covered. With
 * front-to-back drawing each pixel is then drawn once, by the first polygon that covers it. */
#ifndef FXL_SPAN_BUFFER_H
#define FXL_SPAN_BUFFER_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* An interval of covered pixels x0 <= x < x1 of a row; next is the number of the next interval
 * to the right. */
typedef struct {
    uint16_t x0, x1, next;
} fxl_covered;

/* The next of the last interval of a row. */
#define FXL_COVERED_END 0xFFFFu

/* Rows of covered intervals from one pool. The intervals of a row are sorted from left to right,
 * and no two touch. The caller owns the record. Only span_buffer.c writes its members; the
 * caller may read them. */
typedef struct {
    uint16_t *rows;    /* the first interval of each row, or FXL_COVERED_END */
    fxl_covered *pool; /* the first `used` of `capacity` hold intervals, or did once */
    uint16_t capacity, used;
    uint16_t unused; /* the first of these that holds none now: a list by next */
    uint16_t first_row, row_count, width;
    uint16_t open_rows; /* rows that are not wholly covered */
} fxl_span_buffer;

/* How many intervals always suffice for one row of this width in pixels. */
/* spans 3.3 */
#define FXL_SPAN_BUFFER_ROW(width) ((FXL_CAST(uint32_t, width) + 1u) / 2u)

/* Size in bytes for bands of so many rows and a pool of so many intervals. */
#define FXL_SPAN_BUFFER_BYTES(rows, intervals) \
    FXL_CAST(uint32_t, sizeof(fxl_span_buffer) + (FXL_CAST(uint32_t, rows) + 1u) / 2u * 4u + \
                           FXL_CAST(uint32_t, intervals) * sizeof(fxl_covered))

/* The smallest size for a screen, in bytes: its pool suffices for any one row. */
#define FXL_SPAN_BUFFER_BYTES_LEAST(width, height) \
    FXL_SPAN_BUFFER_BYTES(height, FXL_SPAN_BUFFER_ROW(width))

/* Makes a span buffer in memory that is aligned to a pointer, for bands of a screen of this
 * height. Uses at most 65535 intervals; memory beyond them stays unused. Requires size >=
 * FXL_SPAN_BUFFER_BYTES(height, 1). Returns memory. The buffer then has no rows. */
fxl_span_buffer *fxl_span_buffer_make(void *memory, uint32_t size, uint16_t height);

/* Empties the buffer and gives it the rows of a band. Requires band->rows <= height. */
void fxl_span_buffer_begin(fxl_span_buffer *buffer, const fxl_band *band);

/* Draws the uncovered pixels of a trapezoid into the band, row by row, and marks them covered.
 * Returns false where the pool is full; then that row and the rows below are not drawn. A row
 * that holds FXL_SPAN_BUFFER_ROW(width) intervals never needs another one.
 * Requires a trapezoid within the band that the buffer was begun with. Exact. Source: the span
 * structure of "Realtime 3D Clipping" (C5), which here holds the covered pixels. */
bool fxl_span_buffer_draw(fxl_span_buffer *buffer, const fxl_trapezoid *trapezoid, uint8_t colour,
                          const fxl_band *band);

/* Converts a span to a trapezoid of one row. */
static inline fxl_trapezoid fxl_trapezoid_of_span(const fxl_span *span)
{
    fxl_trapezoid trapezoid = {
        span->y, FXL_CAST(int16_t, span->y + 1), {{span->x0, 0, 0, 0}, {span->x1, 0, 0, 0}}};
    return trapezoid;
}

#ifdef __cplusplus
}
#endif

#endif
