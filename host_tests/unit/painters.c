/* SPDX-License-Identifier: MIT */
#include "painters.h"

#include "draw/submit.h"
#include "study/study.h"

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

/* place pixel-format: a target of the format */
const fxl_target *painter_under(uint8_t background)
{
    static const fxl_target under = {.pixel_bits = 8,
                                     .near_first = true,
                                     .fill = fxl_fill_band,
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
        .pixel_bits = 8, .fill = fxl_fill_band, .draw_band = fxl_draw_band, .flat = paint_counting};
    painter.times = times;
    painter.width = width;
    painter.colour_max = colour_max;
    return &counting;
}
