/* SPDX-License-Identifier: MIT */
/* The rows of a polygon of a surface, in a target with a depth buffer. A part of surfaces_text.h.
 * Internal. */
#ifndef FXL_SURFACE_DEPTH_TEXT_H
#define FXL_SURFACE_DEPTH_TEXT_H

#include "../math/memory.h"
#include "../paint/colour_run.h"
#include "../paint/depth_rows.h"
#include "pixel_row.h"
#include "surface_paint_text.h"

#define SCRATCH 16 /* pixels */

/* A kernel tests the rows of a trapezoid, and another one paints what is visible. */
#define HAS_RUNS (FXL_HAS_DEPTH_ROWS && FXL_TARGET_DEPTH_BITS == 16)

/* Where kernels take less of the stack than rows do, rows are functions of their own. */
#if HAS_RUNS
#define ROWS_APART __attribute__((noinline))
#else
#define ROWS_APART inline __attribute__((always_inline))
#endif

/* A row of a polygon. */
typedef struct {
    const fxl_depth_painting *depth;
    const fxl_paint *paint;
    const fxl_paint_row *row;
} surface_row;

/* Whether a pixel is visible, which is known but of runs that a kernel would have tested. */
static inline bool is_seen(const surface_row *of, const void *cells, int32_t x, uint32_t code)
{
#if HAS_RUNS
    const fxl_depth_rule rule = {false, of->depth->head->or_equal};
    return of->depth->keeps != FXL_DEPTH_TESTED || fxl_depth_passes(cells, x, code, rule);
#else
    (void)of;
    (void)cells;
    (void)x;
    (void)code;
    return true;
#endif
}

/* Pixels of a surface that has holes, of one segment of 16 columns: their depth is kept where they
 * are drawn. They are painted over two backgrounds: a pixel that is the same on both was drawn. */
__attribute__((noinline)) /* what is painted twice would be on the stack of all rows */
static void
paint_holes(const surface_row *of, int32_t x0, int32_t x1, void *cells, fxl_depth_line line)
{
    fxl_pixel painted[2][SCRATCH];
    fxl_pixel *pixels = (fxl_pixel *)(void *)of->row->pixels;
    const int32_t first = x0 & -SCRATCH;
    for (uint32_t i = 0; i < 2; i++) {
        fxl_paint_row row = *of->row;
        memset(painted[i], (int)i, sizeof painted[i]);
        /* Column 0 lies before the array; the columns from x0 to x1 lie in it. */
        row.pixels = (uint8_t *)((uintptr_t)painted[i] - (uint32_t)first * sizeof(fxl_pixel));
        PAINT_PIXELS(of->paint, &row, x0, x1);
    }
    for (int32_t x = x0; x < x1; x++, line.code += line.step) {
        const fxl_pixel colour = painted[0][x - first];
        if (colour == painted[1][x - first] && is_seen(of, cells, x, line.code)) {
            pixels[x] = colour;
            fxl_depth_keep(cells, x, line.code, FXL_TARGET_DEPTH_BITS == 32);
        }
    }
}

#if HAS_RUNS

/* Whether the pixels of a surface that has holes are tested and painted by a kernel. */
static inline bool has_hole_kernel(const fxl_paint *paint, const fxl_segment_face *segments)
{
    return has_plain_rows(paint, segments) && FXL_TEXELS_HAVE_HOLES(segments->kind);
}

/* All pixels of a run by that kernel. Returns false if the face has none, or it does not take their
 * weights. */
static inline bool paint_holes_at_once(const surface_row *of, int32_t x0, int32_t x1, void *cells,
                                       const fxl_depth_line *line)
{
    const fxl_segment_face *segments = of->row->segments;
    if (of->depth->keeps != FXL_DEPTH_TESTED) {
        return false;
    }
    const fxl_hole_depths depths = {line->step, (uint16_t *)cells,
                                    line->code - line->step * (uint32_t)x0,
                                    of->depth->head->or_equal};
    if (segments->kind == FXL_TEXELS_STIPPLED) { /* what is seen through holes is often a hole */
        const uint32_t pattern = segments->stipple >> (4u * ((uint32_t)of->row->y & 3u));
        while (x0 < x1 && (pattern >> (x0 & 3) & 1u) == 0) {
            x0++;
        }
        if (x0 == x1) {
            return true;
        }
    }
    return !PAINT_HOLES(segments, of->row, x0, x1, &depths);
}

#else

static inline bool has_hole_kernel(const fxl_paint *paint, const fxl_segment_face *segments)
{
    (void)paint;
    (void)segments;
    return false;
}

static inline bool paint_holes_at_once(const surface_row *of, int32_t x0, int32_t x1, void *cells,
                                       const fxl_depth_line *line)
{
    (void)of;
    (void)x0;
    (void)x1;
    (void)cells;
    (void)line;
    return false;
}

#endif

/* fxl_run_painter. */
static inline __attribute__((always_inline)) void
paint_run(const void *with, int32_t x0, int32_t x1, void *cells, fxl_depth_line line)
{
    const surface_row *of = (const surface_row *)with;
    if (of->depth->keeps < FXL_DEPTH_KEEPS_DRAWN) {
        PAINT_PIXELS(of->paint, of->row, x0, x1);
        return;
    }
    if (paint_holes_at_once(of, x0, x1, cells, &line)) {
        return;
    }
    while (x0 < x1) {
        const int32_t next = (x0 & -SCRATCH) + SCRATCH;
        const int32_t end = next < x1 ? next : x1;
        paint_holes(of, x0, end, cells, line);
        line.code += line.step * (uint32_t)(end - x0);
        x0 = end;
    }
}

/* fxl_row_painter. */
static inline __attribute__((always_inline)) void
paint_row(void *with, const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    fxl_depth_painting *depth = (fxl_depth_painting *)with;
    const surface_row of = {depth, paint, row};
    fxl_depth_paint_target_row(depth, row->y, x0, x1, FXL_TARGET_DEPTH_BITS, paint_run, &of);
}

#if HAS_RUNS

#define RUNS (FXL_POLYGON_CAPACITY < 24 ? 26 : 64) /* that are listed before they are painted */

/* Where the runs of a polygon are found and listed. */
typedef struct {
    fxl_depth_rows rows;
    uint32_t list[RUNS];
} run_memory;

/* The active edges of a scan by chains, which has none. */
static inline run_memory *run_memory_of(fxl_scan *scan)
{
    FXL_STATIC_ASSERT(sizeof(run_memory) + 7 <= sizeof scan->active_edges.found,
                      "room for the runs");
    return (run_memory *)(((uintptr_t)scan->active_edges.found + 7u) & ~(uintptr_t)7);
}

/* A kernel of rows: fxl_paint_runs. */
typedef bool run_kernel(fxl_plain_runs *runs);

/* The kernel for the rows of a face; null: none. */
static inline run_kernel *run_kernel_of(const fxl_paint *paint, const fxl_segment_face *segments)
{
    if (!FXL_PIXEL_IS_MIXED && segments != NULL && paint->ramp != NULL && paint->in_beam == NULL) {
        return PAINT_LIT_RUNS;
    }
    return has_plain_rows(paint, segments) ? PAINT_RUNS : NULL;
}

/* Paints runs that no kernel of rows paints, one by one. */
static inline __attribute__((always_inline)) void paint_each_run(const fxl_paint *paint,
                                                                 fxl_plain_runs *runs)
{
    int32_t x0, x1;
    for (; runs->next != runs->end; runs->next++) {
        if (fxl_take_run(paint->gradients, runs, false, &x0, &x1)) {
            PAINT_PIXELS(paint, &runs->row, x0, x1);
        }
    }
}

/* Paints what is listed, and empties the list. kernel: of such rows; null: none. */
static inline __attribute__((always_inline)) void
paint_runs(const fxl_paint *paint, run_kernel *kernel, run_memory *memory, fxl_plain_runs *runs)
{
    runs->next = memory->list;
    runs->end = memory->rows.runs;
    memory->rows.runs = memory->list;
#if FXL_PIXEL_IS_MIXED
    if (paint->colours != NULL && paint->opacity == 16 && !fxl_is_mixed_565(paint) &&
        !fxl_has_colour_words(paint->gradients)) {
        paint->colours->runs(paint, runs);
        return;
    }
    if (fxl_has_texel_runs(paint)) {
        fxl_paint_texel_runs(paint, runs);
        return;
    }
#endif
    if (kernel == NULL) {
        paint_each_run(paint, runs);
        return;
    }
    while (kernel(runs)) {
        const uint32_t run = runs->next[-1];
        PAINT_PIXELS(paint, &runs->row, (int32_t)(run & 0xFFFFu),
                     (int32_t)((run & ~FXL_RUN_BELOW) >> 16));
    }
}

/* The trapezoids of a polygon whose depths are all kept, or none is. Returns whether it has one, so reaches a
 * row of the band. A trapezoid right below the one before goes on with the same list. Requires a
 * scan by chains. Not inline: its rows would be on the stack of others. */
static __attribute__((noinline)) bool paint_plain(const fxl_paint *paint,
                                                  const fxl_segment_face *segments,
                                                  const fxl_depth_painting *depth,
                                                  const fxl_band *band, fxl_scan *scan)
{
    const fxl_gradients *gradients = paint->gradients;
    const fxl_trapezoid *trapezoid;
    run_memory *memory = run_memory_of(scan);
    const bool keeps = depth->keeps == FXL_DEPTH_KEEPS_ALL;
    run_kernel *const kernel = keeps ? run_kernel_of(paint, segments) : NULL;
    fxl_depth_rows *rows = &memory->rows;
    fxl_plain_runs runs;
    int32_t y = -1; /* of the row that comes next */
    runs.row.segments = segments;
    runs.stride = band->stride * (FXL_PIXEL_BITS / 8);
    fxl_find_downs(gradients, runs.downs);
    runs.downs[3] = gradients->attributes[FXL_SEGMENT_LIGHT].down;
    fxl_depth_rows_begin(depth, rows);
    rows->runs = memory->list;
    rows->runs_end = memory->list + RUNS;
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        rows->rows = (uint32_t)(trapezoid->end_row - trapezoid->first_row);
        if (trapezoid->first_row == y) {
            rows->rows |= FXL_RUN_BELOW;
        } else {
            if (rows->runs != memory->list) {
                paint_runs(paint, kernel, memory, &runs);
            }
            runs.row.pixels =
                band->pixels + (size_t)(trapezoid->first_row - band->first_row) * runs.stride;
            fxl_begin_row(gradients, trapezoid->first_row, &runs.row);
            fxl_depth_rows_go(depth, trapezoid->first_row, rows);
        }
        y = trapezoid->end_row;
        rows->edges[0] = trapezoid->edges[0];
        rows->edges[1] = trapezoid->edges[1];
        while (keeps ? fxl_find_depth_runs(rows) : fxl_find_visible_runs(rows)) {
            paint_runs(paint, kernel, memory, &runs);
        }
        if (rows->runs == rows->runs_end) {
            paint_runs(paint, kernel, memory, &runs);
        }
    }
    if (rows->runs != memory->list) {
        paint_runs(paint, kernel, memory, &runs);
    }
    return y >= 0;
}

#endif

/* Clears the cells of the rows of a polygon. */
static void clear_under(fxl_workspace *workspace, const fxl_screen_point *points, uint32_t count,
                        const fxl_band *band)
{
    const fxl_rows rows =
        fxl_rows_of_points(points, count, (uint16_t)(band->first_row + band->rows));
    fxl_depth_clear(workspace, band, rows.first, rows.end, &FXL_TARGET);
}

/* A polygon whose texels are in words, which is opaque. What it needs of a paint is found here alone.
 * Not inline: what it has would be on the stack of others. */
#if FXL_PIXEL_IS_MIXED && FXL_TARGET_DEPTH_BITS == 16

#define DRAWS_TEXELS 1

static inline void paint_texels_of(const fxl_surfaces *surfaces, const fxl_surface *surface,
                                   const fxl_band *band, fxl_paint *paint)
{
    paint->of_565.palette = band->palette;
    paint->of_565.part_of_level = 0;
    paint->of_565.dark = 0;
    paint->levels_less_1 = 0;
    if (fxl_surface_is_lit(surfaces, surface)) {
        fxl_surface_light_of(surfaces, paint);
        mix_light(surfaces, band, paint);
    }
}

static __attribute__((noinline)) bool draw_texels(const fxl_surfaces *surfaces,
                                                  fxl_workspace *workspace,
                                                  const fxl_surface_polygon *polygon,
                                                  const fxl_screen_point *points, uint32_t count,
                                                  const fxl_band *band)
{
    const fxl_surface *surface = &surfaces->set->surfaces[polygon->surface];
    fxl_paint paint;
    if (((const fxl_depth_head *)workspace->target_memory)->pass == FXL_DEPTH_BLENDED) {
        return false;
    }
    fxl_depth_clear_rest(workspace, band, &FXL_TARGET);
    paint.gradients = &polygon->gradients;
    fxl_texture_level_find(&surfaces->set->textures[surface->texture - 1], polygon->level,
                           &paint.level);
    paint.is_evenly_lit = polygon->is_evenly_lit;
    paint.light = polygon->light;
    paint_texels_of(surfaces, surface, band, &paint);
    return fxl_draw_texels(&paint, &polygon->depth, workspace->target_memory, points, count, band,
                           &workspace->work.scan);
}

#else

#define DRAWS_TEXELS 0

static inline bool draw_texels(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                               const fxl_surface_polygon *polygon, const fxl_screen_point *points,
                               uint32_t count, const fxl_band *band)
{
    (void)surfaces;
    (void)workspace;
    (void)polygon;
    (void)points;
    (void)count;
    (void)band;
    return false;
}

#endif

/* A polygon row by row. */
static ROWS_APART void paint_each_row(fxl_depth_painting *depth, const fxl_paint *paint,
                                      const fxl_segment_face *segments,
                                      const fxl_screen_point *points, uint32_t count,
                                      const fxl_band *band, fxl_scan *scan)
{
    fxl_paint_polygon(paint, segments, points, count, band, FXL_PIXEL_BITS / 8, scan, paint_row,
                      depth);
}

/* The rows of a polygon, whose cells are cleared. */
static ROWS_APART bool paint_by_rows(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                                     const fxl_surface_polygon *polygon,
                                     const fxl_screen_point *points, uint32_t count,
                                     const fxl_band *band)
{
    const fxl_surface *surface = &surfaces->set->surfaces[polygon->surface];
    fxl_depth_painting depth;
    fxl_paint paint;
    fxl_segment_face face;
    paint_of(surfaces, polygon, band, &paint);
    uint8_t keeps = FXL_DEPTH_KEEPS_ALL;
    if (fxl_surface_is_blended(surface)) {
        keeps = FXL_DEPTH_KEEPS_NONE;
    } else if (paint.opacity < 16 || (paint.level.flags & FXL_TEXTURE_KEYED)) {
        keeps = FXL_DEPTH_KEEPS_DRAWN;
    }
    const fxl_segment_face *segments = segments_of(&paint, &face);
    if (keeps == FXL_DEPTH_KEEPS_DRAWN && has_hole_kernel(&paint, segments)) {
        keeps = FXL_DEPTH_TESTED;
    }
#if HAS_RUNS
    depth.plane = &polygon->depth; /* the kernel finds octaves itself */
    depth.head = (const fxl_depth_head *)workspace->target_memory;
    depth.band = band;
    depth.keeps = keeps;
    if (fxl_depth_rows_take(&depth)) {
        fxl_scan_outline(points, count, band, &workspace->work.scan);
        if (workspace->work.scan.by_chains) {
            return paint_plain(&paint, segments, &depth, band, &workspace->work.scan);
        }
    }
#endif
    fxl_depth_begin(&depth, workspace->target_memory, &polygon->depth, band);
    depth.keeps = keeps;
    paint_each_row(&depth, &paint, segments, points, count, band, &workspace->work.scan);
    return false;
}

#endif
