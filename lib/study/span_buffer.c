/* SPDX-License-Identifier: MIT */
#include "../raster/fill.h"
#include "span_buffer.h"

#include "../math/arith.h"
#include "../math/memory.h"

FXL_STATIC_ASSERT(sizeof(fxl_covered) == 6, "docs/extras/spans.md");
FXL_STATIC_ASSERT(FXL_SCREEN_MAX < FXL_COVERED_END, "a pixel fits, and every row can be counted");
FXL_STATIC_ASSERT(FXL_SPAN_BUFFER_ROW(FXL_SCREEN_MAX) < FXL_COVERED_END, "a row fits a pool");

fxl_span_buffer *fxl_span_buffer_make(void *memory, uint32_t size, uint16_t height)
{
    FXL_ASSERT(memory != NULL && size >= FXL_SPAN_BUFFER_BYTES(height, 1));
    fxl_span_buffer *buffer = (fxl_span_buffer *)memory;
    uint32_t pool = (size - FXL_SPAN_BUFFER_BYTES(height, 0)) / (uint32_t)sizeof(fxl_covered);
    buffer->rows = (uint16_t *)(void *)(buffer + 1);
    buffer->pool = (fxl_covered *)(void *)((uint8_t *)memory + FXL_SPAN_BUFFER_BYTES(height, 0));
    buffer->capacity = (uint16_t)(pool < FXL_COVERED_END ? pool : FXL_COVERED_END);
    buffer->row_count = 0;
    return buffer;
}

/* spans 3.1 */
void fxl_span_buffer_begin(fxl_span_buffer *buffer, const fxl_band *band)
{
    FXL_ASSERT((uint8_t *)(buffer->rows + band->rows) <= (uint8_t *)buffer->pool);
    memset(buffer->rows, 0xFF, band->rows * sizeof buffer->rows[0]); /* FXL_COVERED_END */
    buffer->used = 0;
    buffer->unused = FXL_COVERED_END;
    buffer->first_row = band->first_row;
    buffer->row_count = band->rows;
    buffer->width = band->width;
    buffer->open_rows = band->rows;
}

/* Inserts a new interval at *link, before the interval there. Returns false where the pool is
 * full. */
/* spans 2.1 */
static inline bool insert(fxl_span_buffer *buffer, uint16_t *link, uint32_t x0, uint32_t x1)
{
    uint32_t number = buffer->unused;
    if (number != FXL_COVERED_END) {
        buffer->unused = buffer->pool[number].next;
    } else if (buffer->used < buffer->capacity) {
        number = buffer->used++;
    } else {
        return false;
    }
    const fxl_covered interval = {(uint16_t)x0, (uint16_t)x1, *link};
    buffer->pool[number] = interval;
    *link = (uint16_t)number;
    return true;
}

/* Draws the uncovered pixels from the interval's end to x1, and merges all intervals that it
 * then touches into it. */
/* spans 2.1 */
static inline void extend(fxl_span_buffer *buffer, fxl_covered *at, uint32_t x1, uint8_t *pixels,
                          uint32_t four)
{
    while (at->x1 < x1) {
        const uint16_t number = at->next;
        fxl_covered *next = &buffer->pool[number];
        if (number == FXL_COVERED_END || next->x0 > x1) {
            fxl_fill_row(pixels + at->x1, pixels + x1, four);
            at->x1 = (uint16_t)x1;
            return;
        }
        fxl_fill_row(pixels + at->x1, pixels + next->x0, four);
        at->x1 = next->x1;
        at->next = next->next;
        next->next = buffer->unused;
        buffer->unused = number;
    }
}

/* Draws and covers pixels x0 <= x < x1 of a row. The first interval of the row is *link and the
 * first pixel *pixels; x0 < x1. Returns false where the pool is full. */
/* spans 2.2, 2.3 */
static inline bool cover(fxl_span_buffer *buffer, uint16_t *link, uint32_t x0, uint32_t x1,
                         uint8_t *pixels, uint32_t four)
{
    fxl_covered *at = NULL; /* the first interval that does not end before the span */
    while (*link != FXL_COVERED_END) {
        at = &buffer->pool[*link];
        if (at->x1 >= x0) {
            break;
        }
        link = &at->next;
    }
    if (*link == FXL_COVERED_END || at->x0 > x1) {
        if (!insert(buffer, link, x0, x1)) {
            return false;
        }
        at = &buffer->pool[*link];
        fxl_fill_row(pixels + x0, pixels + x1, four);
    } else if (x0 >= at->x0 && x1 <= at->x1) {
        return true;
    } else {
        if (x0 < at->x0) {
            fxl_fill_row(pixels + x0, pixels + at->x0, four);
            at->x0 = (uint16_t)x0;
        }
        extend(buffer, at, x1, pixels, four);
    }
    buffer->open_rows = (uint16_t)(buffer->open_rows - (at->x0 == 0 && at->x1 == buffer->width));
    return true;
}

bool fxl_span_buffer_draw(fxl_span_buffer *buffer, const fxl_trapezoid *trapezoid, uint8_t colour,
                          const fxl_band *band)
{
    FXL_ASSERT(trapezoid->first_row >= buffer->first_row &&
               trapezoid->first_row < trapezoid->end_row &&
               trapezoid->end_row <= buffer->first_row + buffer->row_count);
    const uint32_t four = colour * 0x01010101u, first = (uint32_t)trapezoid->first_row;
    uint8_t *pixels = band->pixels + (size_t)(first - band->first_row) * band->stride;
    uint16_t *row = &buffer->rows[first - buffer->first_row];
    fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
    for (int32_t rows = trapezoid->end_row - trapezoid->first_row; rows > 0; rows--) {
        const uint32_t x0 = (uint32_t)(a.x < b.x ? a.x : b.x);
        const uint32_t x1 = (uint32_t)(a.x < b.x ? b.x : a.x);
        FXL_ASSERT(x0 <= x1 && x1 <= buffer->width);
        if (x0 != x1 && !cover(buffer, row, x0, x1, pixels, four)) {
            return false;
        }
        fxl_edge_step(&a);
        fxl_edge_step(&b);
        pixels += band->stride;
        row += 1;
    }
    return true;
}
