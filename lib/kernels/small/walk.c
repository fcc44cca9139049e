/* SPDX-License-Identifier: MIT */
/* One way for every face, whatever painter and clipper. */
#include "walk_face.h"

#include "fixel/fill.h"

fxl_face_taker fxl_walk_taker(const fxl_renderer *renderer, const fxl_band *band)
{
    (void)renderer;
    (void)band;
    return take_face;
}

static bool paint_over(fxl_renderer *renderer, const fxl_screen_point *points, uint32_t count,
                       uint8_t colour, const fxl_band *band)
{
    fxl_span span;
    fxl_scan *scan = &renderer->work.scan;
    fxl_scan_outline(points, count, band, scan);
    while (fxl_scan_next(scan, &span)) {
        fxl_fill_span(band, &span, colour);
    }
    return true;
}

const fxl_painter fxl_painter_over = {.paint = paint_over};

bool fxl_walk_list(const fxl_walk *on)
{
    fxl_renderer *renderer = on->renderer;
    const fxl_band *band = on->band;
    const fxl_rows wanted = {band->first_row, (uint16_t)(band->first_row + band->rows)};
    fxl_list_record record;
    uint32_t place = 0;
    while (fxl_list_next(&renderer->list, wanted, &place, &record)) {
        if (!renderer->hidden->painter->paint(renderer, record.points, record.count, record.colour,
                                              band)) {
            return false;
        }
    }
    return true;
}
