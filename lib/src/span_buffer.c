/* SPDX-License-Identifier: MIT */
#include "fixel/span_buffer.h"

#include <string.h>

#include "arith.h"
#include "fixel/fill.h"

_Static_assert(sizeof(fxl_covered) == 6, "SPEC.md, chapter 4c");
_Static_assert(FXL_SCREEN_MAX < FXL_COVERED_END, "a pixel fits, and every row can be counted");
_Static_assert(FXL_SPAN_BUFFER_ROW(FXL_SCREEN_MAX) < FXL_COVERED_END, "a row fits a pool");

fxl_span_buffer *fxl_span_buffer_make(void *memory, uint32_t size, uint16_t height)
{
    FXL_ASSERT(memory != NULL && size >= FXL_SPAN_BUFFER_ROOM(height, 1));
    fxl_span_buffer *buffer = memory;
    uint32_t pool = (size - FXL_SPAN_BUFFER_ROOM(height, 0)) / (uint32_t)sizeof(fxl_covered);
    buffer->rows = (uint16_t *)(void *)(buffer + 1);
    buffer->pool = (fxl_covered *)(void *)((uint8_t *)memory + FXL_SPAN_BUFFER_ROOM(height, 0));
    buffer->capacity = (uint16_t)(pool < FXL_COVERED_END ? pool : FXL_COVERED_END);
    buffer->row_count = 0;
    return buffer;
}

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

static void fill(const fxl_band *band, int16_t y, uint16_t x0, uint16_t x1, uint8_t colour)
{
    const fxl_span gap = {y, (int16_t)x0, (int16_t)x1};
    fxl_fill_span(band, &gap, colour);
}

/* A new interval at *link, before what is there. False where the pool is full. */
static bool insert(fxl_span_buffer *buffer, uint16_t *link, uint16_t x0, uint16_t x1)
{
    uint16_t number = buffer->unused;
    if (number != FXL_COVERED_END) {
        buffer->unused = buffer->pool[number].next;
    } else if (buffer->used < buffer->capacity) {
        number = buffer->used++;
    } else {
        return false;
    }
    buffer->pool[number] = (fxl_covered){x0, x1, *link};
    *link = number;
    return true;
}

/* Draws from the interval's end to x1 where nothing is, and takes into the interval all that
 * it then touches. */
static void extend(fxl_span_buffer *buffer, fxl_covered *at, uint16_t x1, int16_t y, uint8_t colour,
                   const fxl_band *band)
{
    while (at->x1 < x1) {
        const uint16_t number = at->next;
        fxl_covered *next = &buffer->pool[number];
        if (number == FXL_COVERED_END || next->x0 > x1) {
            fill(band, y, at->x1, x1, colour);
            at->x1 = x1;
            return;
        }
        fill(band, y, at->x1, next->x0, colour); /* they did not touch: it is not empty */
        at->x1 = next->x1;
        at->next = next->next;
        next->next = buffer->unused;
        buffer->unused = number;
    }
}

bool fxl_span_buffer_draw(fxl_span_buffer *buffer, const fxl_span *span, uint8_t colour,
                          const fxl_band *band)
{
    FXL_ASSERT(span->y >= buffer->first_row && span->y < buffer->first_row + buffer->row_count);
    FXL_ASSERT(span->x0 >= 0 && span->x0 < span->x1 && span->x1 <= buffer->width);
    const uint16_t x0 = (uint16_t)span->x0, x1 = (uint16_t)span->x1;
    uint16_t *link = &buffer->rows[span->y - buffer->first_row];
    while (*link != FXL_COVERED_END && buffer->pool[*link].x1 < x0) {
        link = &buffer->pool[*link].next;
    }
    fxl_covered *at = &buffer->pool[*link]; /* the first that does not end before the span */
    if (*link == FXL_COVERED_END || at->x0 > x1) {
        if (!insert(buffer, link, x0, x1)) {
            return false;
        }
        at = &buffer->pool[*link];
        fill(band, span->y, x0, x1, colour);
    } else if (x0 >= at->x0 && x1 <= at->x1) {
        return true;
    } else {
        if (x0 < at->x0) {
            fill(band, span->y, x0, at->x0, colour);
            at->x0 = x0;
        }
        extend(buffer, at, x1, span->y, colour, band);
    }
    buffer->open_rows = (uint16_t)(buffer->open_rows - (at->x0 == 0 && at->x1 == buffer->width));
    return true;
}
