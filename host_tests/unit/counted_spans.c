/* SPDX-License-Identifier: MIT */
#include "choices.h"
#include "counted_spans.h"
#include "raster/fill.h"
#include "raster/scan.h"

#include <string.h>

static const uint8_t *counted_pixels;
static uint8_t *counted_writes;

static void count_and_fill(uint8_t *pixel, uint8_t *end, uint32_t four)
{
    for (const uint8_t *at = pixel; at < end; at++) {
        counted_writes[at - counted_pixels]++;
    }
    fxl_fill_row(pixel, end, four);
}

/* The library's source, its functions by other names and its fill counted. */
#define fxl_span_buffer_make  counted_span_buffer_make
#define fxl_span_buffer_begin counted_span_buffer_begin
#define fxl_span_buffer_draw  counted_span_buffer_draw
#define fxl_fill_row          count_and_fill
#include "../../lib/study/span_buffer.c"
#include "study/targets.h"
#include "study/span_buffer.h"

static bool paint(fxl_workspace *workspace, const fxl_screen_polygon *polygon, const fxl_band *band)
{
    fxl_scan *scan = &workspace->work.scan;
    const fxl_trapezoid *trapezoid;
    fxl_scan_outline(polygon->points, polygon->count, band, scan);
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        if (!counted_span_buffer_draw(workspace->target_memory, trapezoid, polygon->colour, band)) {
            return false;
        }
    }
    return true;
}

static fxl_target painter;
static choice counted;
const choice *counted_begin(uint8_t *writes, const uint8_t *pixels, uint32_t count)
{
    counted_writes = writes;
    counted_pixels = pixels;
    memset(writes, 0, count);
    painter = fxl_palette_spans;
    painter.flat = paint;
    counted = choice_spans;
    counted.target = &painter;
    return &counted;
}
