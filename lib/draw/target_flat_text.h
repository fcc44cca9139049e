/* SPDX-License-Identifier: MIT */
/* The rows of a polygon of one colour, in a target with a depth buffer. A part of target_text.h.
 * Internal. */
#ifndef FXL_TARGET_FLAT_TEXT_H
#define FXL_TARGET_FLAT_TEXT_H

#include "../paint/depth_outline.h"
#include "../raster/fill.h"
#include "../raster/scan.h"
#include "depth_plane.h"
#include "pixel_row.h"
#include "renderer.h"
#include "surface_polygon.h"

/* Paints the pixels x0 <= x < x1 of row y; with: the painter's own. */
typedef void flat_row_painter(void *with, fxl_pixel *pixels, int32_t y, int32_t x0, int32_t x1);

/* The rows of an outline. pixels: of column 0. */
static inline __attribute__((always_inline)) void paint_rows(const fxl_screen_point *points,
                                                             uint32_t count, const fxl_band *band,
                                                             fxl_scan *scan,
                                                             flat_row_painter *paint, void *with)
{
    const fxl_trapezoid *trapezoid;
    fxl_scan_outline(points, count, band, scan);
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
        fxl_pixel *pixels = fxl_pixels_of_row(band, (uint32_t)trapezoid->first_row);
        for (int32_t y = trapezoid->first_row; y < trapezoid->end_row; y++) {
            const int32_t x0 = a.x < b.x ? a.x : b.x, x1 = a.x < b.x ? b.x : a.x;
            if (x0 < x1) {
                paint(with, pixels, y, x0, x1);
            }
            fxl_edge_step(&a);
            fxl_edge_step(&b);
            pixels += band->stride;
        }
    }
}

/* A polygon of one colour, and its depth. */
typedef struct {
    fxl_depth_painting depth;
    fxl_filling filling;
} flat_painting;

/* A run of visible pixels of a row. */
typedef struct {
    fxl_pixel *pixels;
    fxl_filling filling;
} flat_row;

static inline __attribute__((always_inline)) void
paint_run(const void *with, int32_t x0, int32_t x1, void *cells, fxl_depth_line line)
{
    const flat_row *row = (const flat_row *)with;
    (void)cells;
    (void)line;
    fxl_fill_pixels(row->pixels + x0, row->pixels + x1, row->filling);
}

static inline __attribute__((always_inline)) void paint_row(void *with, fxl_pixel *pixels,
                                                            int32_t y, int32_t x0, int32_t x1)
{
    flat_painting *of = (flat_painting *)with;
    const flat_row row = {pixels, of->filling};
    fxl_depth_paint_target_row(&of->depth, y, x0, x1, FXL_TARGET_DEPTH_BITS, paint_run, &row);
}

/* A plane, where the kernel of outlines takes it, if there is one. */
#if FXL_DRAWS_DEPTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16
typedef fxl_depth_outline flat_outline;
#else
typedef struct {
    fxl_depth_plane plane;
} flat_outline;
#endif

/* Draws a polygon by the kernel of outlines, where there is one and it can. */
static inline fxl_depth_drawn draw_outline(fxl_workspace *workspace, flat_outline *outline,
                                           const fxl_screen_point *points, uint32_t count,
                                           uint8_t colour, uint8_t shade, const fxl_band *band)
{
#if FXL_DRAWS_DEPTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16
    if (!workspace->draws_outlines ||
        !fxl_depth_outline_begin(workspace->target_memory, band, FXL_PIXEL_BITS / 8, outline)) {
        return FXL_DEPTH_NOT_DRAWN;
    }
    outline->filling = fxl_filling_word(fxl_filling_of(band, colour, shade, workspace->dark));
#if !FXL_KERNELS_ARMV7M
    outline->scan = &workspace->work.scan;
#endif
    return FXL_DRAW_DEPTH_OUTLINE(points, count, band, outline);
#else
    (void)workspace;
    (void)outline;
    (void)points;
    (void)count;
    (void)colour;
    (void)shade;
    (void)band;
    return FXL_DEPTH_NOT_DRAWN;
#endif
}

/* Not inline: what it has would stay on the stack while the kernel draws. */
static __attribute__((noinline)) void paint_by_rows(fxl_workspace *workspace,
                                                    const fxl_depth_plane *plane,
                                                    const fxl_screen_point *points, uint32_t count,
                                                    uint8_t colour, uint8_t shade,
                                                    const fxl_band *band)
{
    flat_painting of;
    fxl_depth_begin(&of.depth, workspace->target_memory, plane, band);
    if (of.depth.head->pass != FXL_DEPTH_BLENDED) {
        of.filling = fxl_filling_of(band, colour, shade, workspace->dark);
        paint_rows(points, count, band, &workspace->work.scan, paint_row, &of);
    }
}

/* Returns true if it is known that the polygon reaches a row. */
static inline __attribute__((always_inline)) bool
paint_flat_here(fxl_workspace *workspace, flat_outline *outline, const fxl_screen_point *points,
                uint32_t count, uint8_t colour, uint8_t shade, const fxl_band *band)
{
    fxl_depth_clear_rest(workspace, band, &FXL_TARGET);
    const fxl_depth_drawn drawn =
        draw_outline(workspace, outline, points, count, colour, shade, band);
    if (drawn == FXL_DEPTH_NOT_DRAWN) {
        paint_by_rows(workspace, &outline->plane, points, count, colour, shade, band);
    }
    return drawn == FXL_DEPTH_DRAWN;
}

static __attribute__((noinline)) bool
paint_flat(fxl_workspace *workspace, const fxl_depth_plane *plane, const fxl_screen_point *points,
           uint32_t count, uint8_t colour, uint8_t shade, const fxl_band *band)
{
    flat_outline outline;
    outline.plane = *plane;
    return paint_flat_here(workspace, &outline, points, count, colour, shade, band);
}

#endif
