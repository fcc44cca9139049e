/* SPDX-License-Identifier: MIT */
#include "painters.h"

#include <string.h>

#include "draw/submit.h"
#include "raster/fill.h"
#include "raster/scan.h"
#include "study/study.h"
#include "study/targets.h"

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

static bool paint_counted(fxl_workspace *workspace, const fxl_screen_polygon *polygon,
                          const fxl_band *band)
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

static fxl_target counting_spans;
static choice counted;
const choice *counted_begin(uint8_t *writes, const uint8_t *pixels, uint32_t count)
{
    counted_writes = writes;
    counted_pixels = pixels;
    memset(writes, 0, count);
    counting_spans = fxl_palette_spans;
    counting_spans.flat = paint_counted;
    counted = choice_spans;
    counted.target = &counting_spans;
    return &counted;
}

static struct {
    uint8_t background;
    uint8_t *times;
    uint32_t width;
    uint8_t colour_max;
} painter;

typedef void paint_span(const fxl_span *span, uint8_t colour, const fxl_band *band);

static bool paint(paint_span *one, const fxl_screen_polygon *polygon, const fxl_band *band)
{
    fxl_scan_box scan;
    fxl_span span;
    fxl_scan_box_begin(polygon->points, polygon->count, band, &scan);
    while (fxl_scan_box_next(&scan, &span)) {
        one(&span, polygon->colour, band);
    }
    return true;
}

static void span_under(const fxl_span *span, uint8_t colour, const fxl_band *band)
{
    uint8_t *row = &band->pixels[(span->y - band->first_row) * band->stride];
    for (int32_t x = span->x0; x < span->x1; x++) {
        row[x] = row[x] == painter.background ? colour : row[x];
    }
}

static bool paint_under(fxl_workspace *workspace, const fxl_screen_polygon *polygon,
                        const fxl_band *band)
{
    (void)workspace;
    return paint(span_under, polygon, band);
}

const fxl_target *painter_under(uint8_t background)
{
    static const fxl_target under = {.pixel_bits = 8,
                                     .near_first = true,
                                     .fill = fxl_fill_band_palette,
                                     .draw_band = fxl_draw_band,
                                     .flat = paint_under};
    painter.background = background;
    return &under;
}

static void count_span(const fxl_span *span, uint8_t colour, const fxl_band *band)
{
    uint8_t *row = &painter.times[(uint32_t)span->y * painter.width];
    (void)band;
    for (int32_t x = span->x0; x < span->x1; x++) {
        row[x] = (uint8_t)(row[x] + (colour <= painter.colour_max));
    }
}

static bool paint_counting(fxl_workspace *workspace, const fxl_screen_polygon *polygon,
                           const fxl_band *band)
{
    (void)workspace;
    return paint(count_span, polygon, band);
}

const fxl_target *painter_counting(uint8_t *times, uint32_t width, uint8_t colour_max)
{
    static const fxl_target counting = {
        .pixel_bits = 8, .fill = fxl_fill_band_palette, .draw_band = fxl_draw_band, .flat = paint_counting};
    painter.times = times;
    painter.width = width;
    painter.colour_max = colour_max;
    return &counting;
}
