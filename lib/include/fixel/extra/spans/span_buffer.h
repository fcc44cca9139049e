/* SPDX-License-Identifier: MIT */
/* The span buffer (C5): of each row of a band what is covered, so that front to
 * back each pixel is drawn once, by the first that covers it. */
#ifndef FXL_SPAN_BUFFER_H
#define FXL_SPAN_BUFFER_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Covered pixels x0 <= x < x1 of a row, and what comes next to the right. */
typedef struct {
    uint16_t x0, x1, next;
} fxl_covered;

/* Behind the last of a row. */
#define FXL_COVERED_END 0xFFFFu

/* Rows of covered intervals from one pool. The intervals of a row come from left
 * to right, and no two touch. The caller owns it; all members are for
 * span_buffer.c, and for who looks. */
typedef struct {
    uint16_t *rows;    /* the first interval of each row, or FXL_COVERED_END */
    fxl_covered *pool; /* the first `used` of `capacity` were in use */
    uint16_t capacity, used;
    uint16_t unused; /* of those used, what holds nothing any more: a chain */
    uint16_t first_row, row_count, width;
    uint16_t open_rows; /* that are not covered whole */
} fxl_span_buffer;

/* Intervals that are always enough for one row of so many pixels. */
#define FXL_SPAN_BUFFER_ROW(width) ((FXL_CAST(uint32_t, width) + 1u) / 2u) /* bug: pool-odd */

/* Bytes of memory for bands of so many rows and a pool of so many intervals. */
#define FXL_SPAN_BUFFER_BYTES(rows, intervals) \
    FXL_CAST(uint32_t, sizeof(fxl_span_buffer) + (FXL_CAST(uint32_t, rows) + 1u) / 2u * 4u + \
                           FXL_CAST(uint32_t, intervals) * sizeof(fxl_covered))

/* The least room for a screen: a pool that is enough for any one row. */
#define FXL_SPAN_BUFFER_BYTES_LEAST(width, height) \
    FXL_SPAN_BUFFER_BYTES(height, FXL_SPAN_BUFFER_ROW(width))

/* Makes a span buffer of memory aligned to a pointer, for bands of a screen of this
 * height; of a pool beyond 65535 intervals the rest lies idle. Requires size >=
 * FXL_SPAN_BUFFER_BYTES(height, 1). Answers memory, in which nothing is covered in no row. */
fxl_span_buffer *fxl_span_buffer_make(void *memory, uint32_t size, uint16_t height);

/* Empties it: nothing of the rows of a band is covered. Requires band->rows <= the height. */
void fxl_span_buffer_begin(fxl_span_buffer *buffer, const fxl_band *band);

/* Draws what is not covered of a trapezoid's rows into the band, one after the other, and
 * covers it. False where the pool is full: then nothing is drawn of that row and of those
 * below. A row that holds FXL_SPAN_BUFFER_ROW(width) intervals cannot want another.
 * Requires a trapezoid within the band that the buffer was begun with.
 * Exact. Source: the span structure of "Realtime 3D Clipping" (C5), kept as what is covered. */
bool fxl_span_buffer_draw(fxl_span_buffer *buffer, const fxl_trapezoid *trapezoid, uint8_t colour,
                          const fxl_band *band);

/* A span as a trapezoid of one row. */
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
