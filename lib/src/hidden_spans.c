/* SPDX-License-Identifier: MIT */
#include "hidden_spans.h"

uint32_t fxl_spans_room(const fxl_lens *lens)
{
    return FXL_SPAN_BUFFER_ROOM_LEAST(lens->width, lens->height);
}

void fxl_spans_begin(fxl_renderer *renderer, const fxl_band *band)
{
    fxl_span_buffer *buffer = fxl_span_buffer_make(renderer->paint_room, renderer->paint_room_size,
                                                   renderer->view.lens.height);
    fxl_span_buffer_begin(buffer, band);
}

static bool paint(fxl_renderer *renderer, const fxl_screen_point *points, uint32_t count,
                  uint8_t colour, const fxl_band *band)
{
    fxl_span_buffer *buffer = fxl_spans_of(renderer);
    fxl_scan *scan = &renderer->work.scan;
    const fxl_trapezoid *trapezoid;
    if (buffer->open_rows == 0) {
        return true;
    }
    fxl_scan_outline(points, count, band, scan);
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        if (!fxl_span_buffer_draw(buffer, trapezoid, colour, band)) {
            return false;
        }
    }
    return true;
}

const fxl_painter fxl_painter_spans = {
    .room = fxl_spans_room,
    .draw = fxl_draw_in_parts,
    .begin = fxl_spans_begin,
    .paint = paint,
};

const fxl_hidden fxl_hidden_spans = {
    .front_to_back = true,
    .walk = fxl_walk_by_distance,
    .painter = &fxl_painter_spans,
};
