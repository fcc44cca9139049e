/* SPDX-License-Identifier: MIT */
#include "counted_spans.h"

#include <string.h>

static uint8_t *counted_writes;
static uint32_t counted_width;

static void count_and_fill(const fxl_band *band, const fxl_span *span, uint8_t colour)
{
    for (int32_t x = span->x0; x < span->x1; x++) {
        counted_writes[(uint32_t)span->y * counted_width + (uint32_t)x]++;
    }
    fxl_fill_span(band, span, colour);
}

/* The library's source, its functions by other names and its fill counted. */
#define fxl_span_buffer_make  counted_span_buffer_make
#define fxl_span_buffer_begin counted_span_buffer_begin
#define fxl_span_buffer_draw  counted_span_buffer_draw
#define fxl_fill_span         count_and_fill
#include "../../lib/src/span_buffer.c"

static bool paint(fxl_renderer *renderer, const fxl_screen_point *points, uint32_t count,
                  uint8_t colour, const fxl_band *band)
{
    fxl_scan *scan = &renderer->work.scan;
    fxl_span span;
    fxl_scan_outline(points, count, band, scan);
    while (fxl_scan_next(scan, &span)) {
        if (!counted_span_buffer_draw(renderer->paint_room, &span, colour, band)) {
            return false;
        }
    }
    return true;
}

static fxl_painter painter;
static fxl_hidden hidden;
const fxl_hidden *counted_begin(uint8_t *writes, uint32_t width, uint32_t pixels)
{
    counted_writes = writes;
    counted_width = width;
    memset(writes, 0, pixels);
    painter = fxl_painter_spans;
    painter.paint = paint;
    hidden = fxl_hidden_spans;
    hidden.painter = &painter;
    return &hidden;
}
