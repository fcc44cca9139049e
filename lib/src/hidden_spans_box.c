/* SPDX-License-Identifier: MIT */
#include "fixel/scan_box.h"
#include "hidden_spans.h"

static bool paint(fxl_renderer *renderer, const fxl_screen_point *points, uint32_t count,
                  uint8_t colour, const fxl_band *band)
{
    fxl_span_buffer *buffer = fxl_spans_of(renderer);
    fxl_scan_box scan;
    fxl_span span;
    if (buffer->open_rows == 0) {
        return true;
    }
    fxl_scan_box_begin(points, count, band, &scan);
    while (fxl_scan_box_next(&scan, &span)) {
        const fxl_trapezoid row = fxl_trapezoid_of_span(&span);
        if (!fxl_span_buffer_draw(buffer, &row, colour, band)) {
            return false;
        }
    }
    return true;
}

const fxl_painter fxl_painter_spans_box = {
    .room = fxl_spans_room,
    .draw = fxl_draw_in_parts,
    .begin = fxl_spans_begin,
    .paint = paint,
};

const fxl_hidden fxl_hidden_spans_box = {
    .front_to_back = true,
    .walk = fxl_walk_by_distance,
    .painter = &fxl_painter_spans_box,
};
