/* SPDX-License-Identifier: MIT */
/* A band with a depth buffer. The visibility methods differ in the size of a cell: `wide` is
 * constant where these functions are called. Internal. */
#ifndef FXL_DEPTH_BAND_H
#define FXL_DEPTH_BAND_H

#include "../math/memory.h"
#include "../raster/fill_row.h"
#include "depth_cells.h"
#include "depth_code.h"

#define FXL_DEPTH_SCRATCH 16 /* pixels */

/* Which polygons are painted. */
enum {
    FXL_DEPTH_ALL = 0,
    FXL_DEPTH_OPAQUE = 1,
    FXL_DEPTH_BLENDED = 2 /* those whose surface is FXL_SURFACE_BLEND */
};

/* The beginning of the raster workspace; the cells follow. */
typedef struct {
    FXL_ALIGN_8 fxl_depth_scale scale;
    uint8_t pass; /* FXL_DEPTH_ALL and so on */
    bool or_equal;
} fxl_depth_head;

FXL_STATIC_ASSERT(sizeof(fxl_depth_head) == 8, "FXL_DEPTH_BYTES");

/* Of which visible pixels the depth is kept. */
enum {
    FXL_DEPTH_KEEPS_ALL = 0,
    FXL_DEPTH_KEEPS_DRAWN = 1, /* of a surface that has holes */
    FXL_DEPTH_KEEPS_NONE = 2   /* of a blended one, so that what it covers can be seen through it */
};

/* A polygon that is painted. */
typedef struct {
    const fxl_depth_plane *plane;
    const fxl_surface_painter *painter; /* null: no surface */
    const fxl_depth_head *head;
    const fxl_band *band;
    uint32_t four;           /* without a surface: the colour in each byte */
    uint8_t keeps;           /* FXL_DEPTH_KEEPS_ALL and so on */
    fxl_depth_octave octave; /* of the pixels painted last */
} fxl_depth_painting;

/* A row of it. */
typedef struct {
    const fxl_paint *paint; /* with a surface */
    const fxl_paint_row *row;
    uint8_t *pixels; /* of column 0 */
    void *cells;     /* of column 0 */
    int64_t depth;   /* the gradient at column 0 */
} fxl_depth_row;

/* --- visible pixels ----------------------------------------------------------------------- */

/* Those of a surface that has holes, of one segment of 16 columns: their depth is kept where they
 * are drawn. They are painted over two backgrounds: a pixel that is the same on both was drawn. */
static inline void fxl_depth_paint_holes(const fxl_depth_painting *of, const fxl_depth_row *at,
                                         int32_t x0, int32_t x1, fxl_depth_line line, bool wide)
{
    uint8_t painted[2][FXL_DEPTH_SCRATCH];
    const int32_t first = x0 & -FXL_DEPTH_SCRATCH;
    for (uint32_t i = 0; i < 2; i++) {
        fxl_paint_row row = *at->row;
        memset(painted[i], (int)i, FXL_DEPTH_SCRATCH);
        row.pixels = painted[i] - first;
        of->painter->pixels(at->paint, &row, x0, x1);
    }
    for (int32_t x = x0; x < x1; x++, line.code += line.step) {
        const uint8_t colour = painted[0][x - first];
        if (colour == painted[1][x - first]) {
            at->pixels[x] = colour;
            fxl_depth_keep(at->cells, x, line.code, wide); /* bug: depth-hole */
        }
    }
}

/* line: the codes from x0 on. */
static inline void fxl_depth_paint_visible(const fxl_depth_painting *of, const fxl_depth_row *at,
                                           int32_t x0, int32_t x1, fxl_depth_line line, bool wide)
{
    if (of->painter == NULL) {
        fxl_fill_row(at->pixels + x0, at->pixels + x1, of->four);
        return;
    }
    if (of->keeps != FXL_DEPTH_KEEPS_DRAWN) {
        of->painter->pixels(at->paint, at->row, x0, x1);
        return;
    }
    while (x0 < x1) {
        const int32_t next = (x0 & -FXL_DEPTH_SCRATCH) + FXL_DEPTH_SCRATCH;
        const int32_t end = next < x1 ? next : x1;
        fxl_depth_paint_holes(of, at, x0, end, line, wide);
        line.code += line.step * (uint32_t)(end - x0);
        x0 = end;
    }
}

/* --- a row ---------------------------------------------------------------------------------- */

/* Pixels of one octave. */
static inline void fxl_depth_paint_line(const fxl_depth_painting *of, const fxl_depth_row *at,
                                        int32_t x0, int32_t x1, fxl_depth_line line,
                                        fxl_depth_rule rule)
{
    while (x0 < x1) {
        const fxl_depth_line from = line;
        const int32_t end = of->keeps == FXL_DEPTH_KEEPS_ALL
                                ? fxl_depth_visible_end(at->cells, x0, x1, &line, true, rule)
                                : fxl_depth_visible_end(at->cells, x0, x1, &line, false, rule);
        if (x0 < end) {
            fxl_depth_paint_visible(of, at, x0, end, from, rule.wide);
        }
        x0 = end < x1 ? fxl_depth_hidden_end(at->cells, end, x1, &line, rule) : x1;
    }
}

/* Sets the octave of column x0. Returns how far it goes: all of the columns x0 to the one before
 * have it; x1 at most. It is found by halving, as depth is linear along a row. */
static inline int32_t fxl_depth_octave_end(fxl_depth_painting *of, const fxl_depth_row *at,
                                           int32_t x0, int32_t x1)
{
    const int64_t along = of->plane->gradient.along;
    const int64_t value = at->depth + along * x0;
    if (!fxl_depth_octave_holds(&of->octave, value)) {
        fxl_depth_octave_of(of->head->scale, of->plane, value, &of->octave);
    }
    int32_t inside = x0, outside = x1;
    if (fxl_depth_octave_holds(&of->octave, at->depth + along * (x1 - 1))) {
        return x1;
    }
    while (outside - inside > 1) {
        const int32_t middle = (inside + outside) / 2;
        if (fxl_depth_octave_holds(&of->octave, at->depth + along * middle)) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    return outside;
}

/* The pixels x0 <= x < x1 of row y. */
static inline void fxl_depth_paint_row(fxl_depth_painting *of, fxl_depth_row *at, int32_t y,
                                       int32_t x0, int32_t x1, bool wide)
{
    const fxl_gradient *gradient = &of->plane->gradient;
    const size_t row_bytes = (size_t)of->band->width * (wide ? 4u : 2u);
    at->cells =
        (uint8_t *)(uintptr_t)(of->head + 1) + (size_t)(y - of->band->first_row) * row_bytes;
    at->depth = gradient->at + gradient->down * y;
    while (x0 < x1) {
        const int32_t end = fxl_depth_octave_end(of, at, x0, x1);
        const fxl_depth_octave *octave = &of->octave;
        fxl_depth_line line = {octave->bias, octave->step};
        if (!octave->is_constant) {
            line.code += fxl_depth_shifted(at->depth, octave->drop) + line.step * (uint32_t)x0;
        }
        if (of->head->or_equal) {
            const fxl_depth_rule rule = {wide, true};
            fxl_depth_paint_line(of, at, x0, end, line, rule);
        } else {
            const fxl_depth_rule rule = {wide, false};
            fxl_depth_paint_line(of, at, x0, end, line, rule);
        }
        x0 = end;
    }
}

/* fxl_row_painter, with a painting. */
static inline void fxl_depth_paint_surface_row(void *with, const fxl_paint *paint,
                                               const fxl_paint_row *row, int32_t x0, int32_t x1,
                                               bool wide)
{
    fxl_depth_row at = {paint, row, row->pixels, NULL, 0};
    fxl_depth_paint_row((fxl_depth_painting *)with, &at, row->y, x0, x1, wide);
}

/* --- a polygon ------------------------------------------------------------------------------ */

static inline void fxl_depth_begin(fxl_depth_painting *of, const fxl_workspace *workspace,
                                   const fxl_depth_plane *plane, const fxl_band *band)
{
    of->plane = plane;
    of->painter = NULL;
    of->head = (const fxl_depth_head *)workspace->raster_workspace;
    of->band = band;
    of->keeps = FXL_DEPTH_KEEPS_ALL;
    fxl_depth_octave_of(of->head->scale, plane, 0, &of->octave);
}

/* A polygon of one colour. */
static inline void fxl_depth_paint_flat(fxl_depth_painting *of, const fxl_screen_point *points,
                                        uint32_t count, uint8_t colour, fxl_scan *scan, bool wide)
{
    const fxl_band *band = of->band;
    const fxl_trapezoid *trapezoid;
    of->four = colour * 0x01010101u;
    fxl_scan_outline(points, count, band, scan);
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
        fxl_depth_row at;
        at.pixels = band->pixels + (size_t)(trapezoid->first_row - band->first_row) * band->stride;
        for (int32_t y = trapezoid->first_row; y < trapezoid->end_row; y++) {
            fxl_depth_paint_row(of, &at, y, a.x < b.x ? a.x : b.x, a.x < b.x ? b.x : a.x, wide);
            fxl_edge_step(&a);
            fxl_edge_step(&b);
            at.pixels += band->stride;
        }
    }
}

/* fxl_surface_backend.paint; paint_row: fxl_depth_paint_surface_row. */
static inline void fxl_depth_paint(const fxl_renderer *renderer, fxl_workspace *workspace,
                                   const fxl_surface_polygon *polygon,
                                   const fxl_screen_point *points, uint32_t count,
                                   const fxl_band *band, fxl_row_painter *paint_row, bool wide)
{
    fxl_scan *scan = &workspace->work.scan;
    fxl_depth_painting of;
    fxl_depth_begin(&of, workspace, &polygon->depth, band);
    if (polygon->surface == FXL_NO_SURFACE) {
        if (of.head->pass != FXL_DEPTH_BLENDED) {
            fxl_depth_paint_flat(&of, points, count, polygon->colour, scan, wide);
        }
        return;
    }
    const fxl_surfaces *surfaces = fxl_surfaces_of(renderer);
    const fxl_surface *surface = &surfaces->set->surfaces[polygon->surface];
    const bool is_blended = (surface->flags & FXL_SURFACE_BLEND) != 0;
    if (of.head->pass == (is_blended ? FXL_DEPTH_OPAQUE : FXL_DEPTH_BLENDED)) {
        return; /* bug: depth-pass */
    }
    fxl_paint paint;
    of.painter = surfaces->painter;
    of.painter->paint_of(surfaces, polygon, &paint);
    if (is_blended) {
        of.keeps = FXL_DEPTH_KEEPS_NONE;
    } else if (paint.opacity < 16 || (paint.level.flags & FXL_TEXTURE_KEYED)) {
        of.keeps = FXL_DEPTH_KEEPS_DRAWN;
    }
    of.painter->polygon(&paint, points, count, band, scan, paint_row, &of);
}

/* fxl_raster_backend.draw_polygon: one that has no depth is at infinity. Front to back, the first
 * of these to cover a pixel is seen, as in a span buffer; far to near, the last one. */
static inline void fxl_depth_draw_polygon(fxl_workspace *workspace, const fxl_screen_point *points,
                                          uint32_t count, uint8_t colour, const fxl_band *band,
                                          bool wide)
{
    static const fxl_depth_plane infinity = {{0, 0, 0}, 0};
    fxl_depth_painting of;
    fxl_depth_begin(&of, workspace, &infinity, band);
    if (of.head->pass != FXL_DEPTH_BLENDED) {
        fxl_depth_paint_flat(&of, points, count, colour, &workspace->work.scan, wide);
    }
}

#endif
