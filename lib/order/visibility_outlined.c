/* SPDX-License-Identifier: MIT */
#include "../draw/submit.h"
#include "../math/arith.h"
#include "../math/memory.h"
#include "../math/pixel_centre.h"
#include "../raster/draw_outline.h"
#include "fixel/wire.h"

/* An edge with both ends this near to one side of the screen, or beyond it, is where the clipper
 * cut: 1/256 pixel. A clipped vertex is less than 1/512 pixel from the side. */
#define SIDE 256

static uint32_t style_size(const fxl_lens *lens)
{
    (void)lens;
    return (uint32_t)sizeof(fxl_outline_style);
}

/* Another workspace gets the style of the renderer's own. */
static void begin(const fxl_renderer *renderer, fxl_workspace *workspace, const fxl_band *band)
{
    fxl_outline_style *style = (fxl_outline_style *)workspace->target_memory;
    (void)band;
    if (style != renderer->workspace.target_memory) {
        memcpy(style, renderer->workspace.target_memory, sizeof *style);
    }
    style->height = renderer->frame.view.lens.height;
}

static bool are_beside(fxl_q16_16 a, fxl_q16_16 b, int32_t size)
{
    const fxl_q16_16 end = size * 65536 - SIDE;
    return (a < SIDE && b < SIDE) || (a > end && b > end);
}

/* A coordinate in the rows that a polygon reaches: its vertices are at most half a pixel outside of
 * them. Other rows need not be drawn: a band, or a display list, may pass over the polygon there.
 */
static fxl_q16_16 within(fxl_q16_16 y, int32_t first, int32_t end)
{
    return y < first * 65536 ? first * 65536 : y >= end * 65536 ? end * 65536 - 1 : y;
}

/* Requires a polygon that reaches a row. */
static void draw_edges(const fxl_outline_style *style, const fxl_screen_point *points,
                       uint32_t count, const fxl_band *band)
{
    fxl_q16_16 top = points[0].y, bottom = points[0].y;
    for (uint32_t i = 1; i < count; i++) {
        top = points[i].y < top ? points[i].y : top;
        bottom = points[i].y > bottom ? points[i].y : bottom;
    }
    const int32_t first = fxl_first_centre_from(top), end = fxl_first_centre_from(bottom);
    FXL_ASSERT(first < end);
    const fxl_screen_point *a = &points[count - 1];
    for (uint32_t i = 0; i < count; i++) {
        const fxl_screen_point *b = &points[i];
        if (!are_beside(a->x, b->x, band->width) && !are_beside(a->y, b->y, style->height)) {
            const fxl_screen_point from = {a->x, within(a->y, first, end)};
            const fxl_screen_point to = {b->x, within(b->y, first, end)};
            fxl_wire_line(&from, &to, style->line, band);
        }
        a = b;
    }
}

static bool paint(fxl_workspace *workspace, const fxl_screen_point *points, uint32_t count,
                  uint8_t colour, const fxl_band *band)
{
    const fxl_outline_style *style = (const fxl_outline_style *)workspace->target_memory;
    workspace->work.scan.colour = style->keeps_colours ? colour : style->fill;
    (void)fxl_draw_outline(points, count, band, &workspace->work.scan);
    draw_edges(style, points, count, band);
    return true;
}

const fxl_target fxl_palette_outlined = {
    .pixel_bits = 8,
    .draws_outlines = true,
    .fill = fxl_fill_band,
    .memory_size = style_size,
    .begin_band = begin,
    .flat = paint};

const fxl_visibility fxl_visibility_outlined = {.order = &fxl_by_distance,
                                                .target = &fxl_palette_outlined};
