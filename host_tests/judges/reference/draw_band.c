/* SPDX-License-Identifier: MIT */
/* Pixels of a band: the drawn polygons far to near, or by depth. */
#include "reference/depth.h"
#include "reference/scan.h"
#include "reference/render.h"
#include "reference/wire.h"

uint16_t ref_pixel_of(const ref_renderer *renderer, uint8_t colour)
{
    return renderer->rgb565 ? renderer->rgb565->palette[colour] : colour;
}

bool ref_lets_through(const ref_drawn *drawn)
{
    const ref_surface *surface = drawn->look.surface;
    return surface && (ref_surface_mixes(surface) || surface->opacity < REF_OPAQUE ||
                       (drawn->look.texture && drawn->look.texture->is_keyed));
}

uint8_t ref_face_name(uint32_t instance, uint32_t face)
{
    const uint32_t mixed = instance * 2654435761u ^ face * 2246822519u;
    return (uint8_t)(1 + (mixed >> 16) % 255);
}

/* Names are those of what is opaque, and of no line. */
static bool is_left_out(const ref_renderer *renderer, const ref_drawn *drawn)
{
    return (renderer->draws_names && ref_lets_through(drawn)) ||
           (drawn->line.is_line && (renderer->draws_names || renderer->shown));
}

static bool is_plain(const ref_renderer *renderer, const ref_drawn *drawn)
{
    return renderer->draws_names || !drawn->look.surface;
}

static uint16_t plain_colour(const ref_renderer *renderer, const ref_drawn *drawn)
{
    if (renderer->draws_names) {
        return ref_face_name(drawn->instance, drawn->face);
    }
    const uint16_t full = ref_pixel_of(renderer, drawn->polygon.colour);
    return renderer->rgb565 ? ref_rgb565_shown(renderer->rgb565, full, ref_rgb565_flat_part(1 - drawn->shade))
                            : full;
}

/* Notes that a polygon changes pixels first <= x < end of a row. */
static void note_shown(const ref_renderer *renderer, const ref_drawn *drawn, int y, int first,
                       int end)
{
    const size_t number = (size_t)(drawn - renderer->display_list.drawn);
    for (int x = first; x < end && renderer->shown; x++) {
        renderer->shown[y * renderer->lens.width + x] = (uint32_t)number + 1;
    }
}

/* place sampling: who asks the reference */
static void draw_span(const ref_renderer *renderer, const ref_drawn *drawn, const ref_band *band,
                      const ref_span *span)
{
    if (is_plain(renderer, drawn)) {
        ref_fill_span(band, span, plain_colour(renderer, drawn));
        note_shown(renderer, drawn, span->y, span->x0, span->x1);
        return;
    }
    for (int x = span->x0; x < span->x1; x++) {
        const int colour = ref_surface_colour(&drawn->look, &renderer->lens, x, span->y,
                                              ref_pixel(band, x, span->y));
        if (colour != REF_CLEAR) {
            const ref_span pixel = {span->y, x, x + 1};
            ref_fill_span(band, &pixel, (uint16_t)colour);
            note_shown(renderer, drawn, span->y, x, x + 1);
        }
    }
}

/* Pixels of a span that are as near as what was drawn there, or nearer. */
static void draw_near_span(const ref_renderer *renderer, const ref_drawn *drawn,
                           const ref_band *band, const ref_span *span, bool keeps)
{
    double *near_row = renderer->nearness + (ptrdiff_t)span->y * renderer->lens.width;
    for (int x = span->x0; x < span->x1; x++) {
        const double nearness =
            ref_drawn_nearness(drawn, &renderer->lens, x + 0.5, span->y + 0.5);
        const int colour =
            nearness < near_row[x] ? REF_CLEAR
            : is_plain(renderer, drawn)
                ? plain_colour(renderer, drawn)
                : ref_surface_colour(&drawn->look, &renderer->lens, x, span->y,
                                     ref_pixel(band, x, span->y));
        if (colour != REF_CLEAR) {
            const ref_span pixel = {span->y, x, x + 1};
            ref_fill_span(band, &pixel, (uint16_t)colour);
            near_row[x] = keeps ? nearness : near_row[x];
            note_shown(renderer, drawn, span->y, x, x + 1);
        }
    }
}

bool ref_is_blended(const ref_drawn *drawn)
{
    return drawn->look.surface && ref_surface_mixes(drawn->look.surface);
}

static void draw_polygon(const ref_renderer *renderer, const ref_drawn *drawn, const ref_band *band)
{
    ref_scan scan;
    ref_span span;
    ref_scan_begin(&drawn->polygon, band, &scan);
    while (ref_scan_next(&scan, &span)) {
        if (renderer->method.depth_bits != 0) {
            draw_near_span(renderer, drawn, band, &span, !ref_is_blended(drawn));
        } else {
            draw_span(renderer, drawn, band, &span);
        }
    }
}

/* Before the first polygon, everything is infinitely far away. */
static void clear_depth(const ref_renderer *renderer, ref_rows rows)
{
    for (int y = rows.first; y < rows.end; y++) {
        for (int x = 0; x < renderer->lens.width; x++) {
            renderer->nearness[y * renderer->lens.width + x] = 0;
        }
    }
}

/* The pass by depth in which something is drawn. */
static int pass_of(const ref_drawn *drawn)
{
    return ref_is_blended(drawn) ? 2 : drawn->line.is_line;
}

/* By depth in three passes: faces that are opaque, lines, and what is blended over what is behind it. */
void ref_frame_draw(const ref_renderer *renderer, const ref_band *band)
{
    const ref_rows rows = {band->first_row, band->first_row + band->rows};
    const bool by_depth = renderer->method.depth_bits != 0;
    if (by_depth) {
        clear_depth(renderer, rows);
    }
    for (int pass = 0; pass <= (by_depth ? 2 : 0); pass++) {
        const ref_drawn *drawn;
        for (size_t place = 0;
             (drawn = ref_display_list_next(&renderer->display_list, rows, &place)) != NULL;) {
            if (!is_left_out(renderer, drawn) && (!by_depth || pass_of(drawn) == pass)) {
                draw_polygon(renderer, drawn, band);
            }
        }
    }
}
