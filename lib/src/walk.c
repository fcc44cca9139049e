/* SPDX-License-Identifier: MIT */
#include "walk_face.h"

#include "fixel/fill.h"

/* scan -> fill, for a scan that was begun. */
static void paint(fxl_scan *scan, uint8_t colour, const fxl_band *band)
{
    if (FXL_IS_SMALL) {
        fxl_span span;
        while (fxl_scan_next(scan, &span)) {
            fxl_fill_span(band, &span, colour);
        }
        return;
    }
    const fxl_trapezoid *trapezoid = fxl_scan_next_trapezoid(scan);
    while (trapezoid != NULL) {
        fxl_fill_trapezoid(band, trapezoid, colour);
        trapezoid = fxl_scan_is_over(scan) ? NULL : fxl_scan_next_trapezoid(scan);
    }
}

/* The same for what most faces are when a frame is drawn at one go: one polygon at most,
 * painted over what is there. */
static bool paint_face(const fxl_walk *on, const fxl_placed *placed, const fxl_face *face)
{
    fxl_renderer *renderer = on->renderer;
    const fxl_screen_polygon *screen = &renderer->screen;
    fxl_counters *counters = on->counters;
    fxl_clip_result cut =
        renderer->clipper->clip(placed, face, &renderer->work.clip, &renderer->screen);
    if (cut == FXL_CLIP_BETWEEN) {
        counters->drawn += 1;
        return true;
    }
    if (cut != FXL_CLIP_INSIDE && cut != FXL_CLIP_CUT) {
        return fxl_walk_account(on, (fxl_fate)1 << cut, 0);
    }
    fxl_scan *scan = &renderer->work.scan;
    fxl_scan_outline(screen->points, screen->count, on->band, scan);
    if (fxl_scan_is_on_screen(scan, renderer->view.lens.height)) {
        counters->spilled += 1;
        paint(scan, screen->colour, on->band);
    }
    counters->drawn += 1;
    counters->clipped += cut == FXL_CLIP_CUT;
    return true;
}

fxl_face_taker fxl_walk_taker(const fxl_renderer *renderer, const fxl_band *band)
{
    return !FXL_IS_SMALL && band != NULL && renderer->hidden->painter == &fxl_painter_over &&
                   renderer->clipper->next == NULL
               ? paint_face
               : take_face;
}

static bool paint_over(fxl_renderer *renderer, const fxl_screen_point *points, uint32_t count,
                       uint8_t colour, const fxl_band *band)
{
    fxl_scan_outline(points, count, band, &renderer->work.scan);
    paint(&renderer->work.scan, colour, band);
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
