/* SPDX-License-Identifier: MIT */
/* The text of all painters of surfaces. The file that includes this one defines FXL_TARGET,
 * FXL_TARGET_PIXEL_BITS and FXL_TARGET_DEPTH_BITS as for target_text.h, and
 *
 *   FXL_TARGET_SURFACES  the painter's name
 *
 * Internal. */
#ifndef FXL_SURFACES_TEXT_H
#define FXL_SURFACES_TEXT_H

#include "../math/family.h"
#include "../math/memory.h"
#include "../paint/corner_colours.h"
#include "../paint/paint_polygon.h"
#include "../paint/texture_level.h"
#include "../view/model_view.h"
#include "surface_polygon.h"
#include "pixel_row.h"

#if FXL_TARGET_PIXEL_BITS == 8
#define PAINT_PIXELS fxl_paint_pixels
#define PAINT_ROWS   fxl_paint_rows
#define PAINT_RUNS   fxl_paint_runs
#define PAINT_HOLES  fxl_paint_holes
#define FIND_COLOURS NULL
#else
#define PAINT_PIXELS fxl_paint_pixels_565
#define PAINT_ROWS   fxl_paint_rows_565
#define PAINT_RUNS   fxl_paint_runs_565
#define PAINT_HOLES  fxl_paint_holes_565
#define FIND_COLOURS fxl_find_colours
#endif

/* --- a polygon ------------------------------------------------------------------------------ */

#if FXL_TARGET_PIXEL_BITS == 16

/* Requires paint->ramp. */
static inline void mix_light(const fxl_surfaces *surfaces, fxl_paint *paint)
{
    const uint32_t levels = paint->levels_less_1;
    paint->of_565.part_of_level = (65536u + levels / 2) / levels;
    paint->of_565.dark = surfaces->light->settings.dark;
}

static void paint_of(const fxl_surfaces *surfaces, const fxl_surface_polygon *polygon,
                     const fxl_band *band, fxl_paint *paint)
{
    const fxl_surface *surface = &surfaces->set->surfaces[polygon->surface];
    fxl_paint_565 *of = &paint->of_565;
    fxl_surface_paint_of(surfaces, polygon, paint);
    of->palette = band->palette;
    of->part_of_level = 0;
    of->dark = 0;
    if (paint->ramp != NULL) {
        mix_light(surfaces, paint);
    }
    if (paint->is_evenly_lit) {
        paint->ramp = NULL;
    }
    of->key = surface->texture != 0 ? surfaces->set->textures[surface->texture - 1].key_565 : 0;
    of->sixteenths = (uint8_t)((surface->flags & FXL_SURFACE_BLEND) == 0 ? 0
                               : surface->sixteenths == 0                ? 8
                                                                         : surface->sixteenths);
    of->adds = (surface->flags & FXL_SURFACE_ADD) != 0;
    if (paint->in_beam != NULL) {
        paint->level.flags |= FXL_LEVEL_IN_BEAM;
        paint->colour = paint->in_beam[paint->colour];
    }
}

static const fxl_segment_face *segments_of(const fxl_paint *paint, fxl_segment_face *face)
{
    return fxl_segments_find_565(paint, face) ? face : NULL;
}

#else

static void paint_of(const fxl_surfaces *surfaces, const fxl_surface_polygon *polygon,
                     const fxl_band *band, fxl_paint *paint)
{
    (void)band;
    fxl_surface_paint_of(surfaces, polygon, paint);
    if (paint->is_evenly_lit) {
        paint->table = paint->ramp + (paint->light & ~255u);
        paint->ramp = NULL;
    } else if (paint->in_beam != NULL && paint->ramp == NULL) {
        paint->table = paint->in_beam;
        paint->colour = paint->in_beam[paint->colour];
        paint->in_beam = NULL;
    }
    paint->is_replaced = paint->in_beam != NULL || paint->blend != NULL;
}

static const fxl_segment_face *segments_of(const fxl_paint *paint, fxl_segment_face *face)
{
    return fxl_segments_find(paint, face) ? face : NULL;
}

#endif

/* Whether a kernel paints its rows one after the other; compiled for size, none does. */
static inline bool has_plain_rows(const fxl_paint *paint, const fxl_segment_face *segments)
{
    return !FXL_IS_COMPACT && segments != NULL && paint->ramp == NULL &&
           (FXL_TARGET_PIXEL_BITS == 16 ? !paint->is_evenly_lit : paint->in_beam == NULL);
}

#if FXL_TARGET_DEPTH_BITS == 0

/* fxl_row_painter. */
static inline __attribute__((always_inline)) void
paint_row(void *with, const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    if (FXL_TARGET_PIXEL_BITS == 8 && !FXL_IS_COMPACT) {
        fxl_paint_simply(with, paint, row, x0, x1);
    } else {
        PAINT_PIXELS(paint, row, x0, x1);
    }
}

/* Returns true if it is known that the polygon reaches a row of the band. */
/* SPEC 10.5, surfaces 4.4 */
static bool paint_surface(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                          const fxl_surface_polygon *polygon, const fxl_screen_point *points,
                          uint32_t count, const fxl_band *band)
{
    fxl_paint paint;
    fxl_segment_face face;
    paint_of(surfaces, polygon, band, &paint);
    const fxl_segment_face *segments = segments_of(&paint, &face);
    if (has_plain_rows(&paint, segments)) {
        fxl_paint_plain_polygon(&paint, segments, points, count, band, FXL_TARGET_PIXEL_BITS / 8,
                                &workspace->work.scan, PAINT_ROWS, PAINT_PIXELS);
    } else if (FXL_IS_COMPACT || FXL_TARGET_PIXEL_BITS == 8 || !paint.has_colours ||
               !fxl_paint_colour_polygon(&paint, points, count, band, &workspace->work.scan)) {
        fxl_paint_polygon(&paint, segments, points, count, band, FXL_TARGET_PIXEL_BITS / 8,
                          &workspace->work.scan, paint_row, NULL);
    }
    return false;
}

#define FIND_DEPTH  NULL
#define FIND_LINEAR NULL

#else

#include "../paint/depth_rows.h"
#include "../paint/smooth_outline.h"

#define SCRATCH  16 /* pixels */

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
        row.pixels = (uint8_t *)(painted[i] - first);
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
 * weights. Not inline: its record would be on the stack of others. */
static __attribute__((noinline)) bool paint_holes_at_once(const surface_row *of, int32_t x0,
                                                          int32_t x1, void *cells,
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
    fxl_depth_paint_row(depth, row->y, x0, x1, FXL_TARGET_DEPTH_BITS, false, paint_run, &of);
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
#if FXL_TARGET_PIXEL_BITS == 8
    if (segments != NULL && paint->ramp != NULL && paint->in_beam == NULL) {
        return fxl_paint_lit_runs;
    }
#endif
    return has_plain_rows(paint, segments) ? PAINT_RUNS : NULL;
}

/* Paints runs that no kernel of rows paints, one by one. */
static inline __attribute__((always_inline)) void paint_each_run(const fxl_paint *paint,
                                                                 fxl_plain_runs *runs)
{
    for (; runs->next != runs->end; runs->next++) {
        const uint32_t run = *runs->next;
        const int32_t x0 = (int32_t)(run & 0xFFFFu), x1 = (int32_t)((run & ~FXL_RUN_BELOW) >> 16);
        if (run & FXL_RUN_BELOW) {
            runs->row.pixels += runs->stride;
            fxl_next_row(paint->gradients, &runs->row);
        }
        if (x0 < x1) {
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

/* The trapezoids of a polygon whose depths are all kept. Returns whether it has one, so reaches a
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
    run_kernel *const kernel = run_kernel_of(paint, segments);
    fxl_depth_rows *rows = &memory->rows;
    fxl_plain_runs runs;
    int32_t y = -1; /* of the row that comes next */
    runs.row.segments = segments;
    runs.stride = band->stride * (FXL_TARGET_PIXEL_BITS / 8);
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
        while (fxl_find_depth_runs(rows)) {
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

static inline bool is_blended(const fxl_surface *surface)
{
    return (surface->flags & (FXL_SURFACE_BLEND | FXL_SURFACE_ADD)) != 0;
}

/* Clears the cells of the rows of a polygon. */
static void clear_under(fxl_workspace *workspace, const fxl_screen_point *points, uint32_t count,
                        const fxl_band *band)
{
    const fxl_rows rows =
        fxl_rows_of_points(points, count, (uint16_t)(band->first_row + band->rows));
    fxl_depth_clear(workspace, band, rows.first, rows.end, FXL_TARGET_DEPTH_BITS / 8);
}

#if FXL_DRAWS_DEPTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16

#if FXL_TARGET_PIXEL_BITS == 16
#define DRAW_SMOOTH fxl_draw_smooth_outline_16
#else
#define DRAW_SMOOTH fxl_draw_smooth_outline_8
#endif

/* Draws a polygon by the kernel of smooth outlines: an opaque one that is lit and in no beam, whose
 * planes are in words, where the kernel can draw. What it needs of a paint is found here alone. Not
 * inline: what it has would stay on the stack of others. */
static __attribute__((noinline)) fxl_depth_drawn
draw_words(const fxl_surfaces *surfaces, fxl_workspace *workspace,
           const fxl_surface_polygon *polygon, uint8_t colour, const fxl_screen_point *points,
           uint32_t count, const fxl_band *band)
{
    fxl_smooth_outline smooth;
    fxl_paint paint;
    fxl_surface_light_of(surfaces, &paint);
    paint.gradients = &polygon->gradients;
    paint.colour = colour;
#if FXL_TARGET_PIXEL_BITS == 16
    paint.of_565.palette = band->palette;
    mix_light(surfaces, &paint);
#endif
    fxl_smooth_outline_set((const fxl_depth_head *)workspace->target_memory, &polygon->depth,
                           &paint, band, FXL_TARGET_PIXEL_BITS / 8, &smooth);
    return DRAW_SMOOTH(points, count, band, &smooth);
}

/* The same, whether the cells of its rows are cleared or not. */
static inline fxl_depth_drawn clear_and_draw_words(const fxl_surfaces *surfaces,
                                                   fxl_workspace *workspace,
                                                   const fxl_surface_polygon *polygon,
                                                   uint8_t colour, const fxl_screen_point *points,
                                                   uint32_t count, const fxl_band *band)
{
    const fxl_depth_drawn drawn =
        draw_words(surfaces, workspace, polygon, colour, points, count, band);
    if (drawn != FXL_DEPTH_NOT_CLEAR) {
        return drawn;
    }
    clear_under(workspace, points, count, band);
    return draw_words(surfaces, workspace, polygon, colour, points, count, band);
}

/* Whether the kernel of smooth outlines can draw into a band. */
static inline bool can_draw_smooth(const fxl_workspace *workspace, const fxl_band *band)
{
    return fxl_depth_outline_can_draw((const fxl_depth_head *)workspace->target_memory, band,
                                      FXL_TARGET_PIXEL_BITS / 8);
}

/* Draws any polygon in words by that kernel, where it can. */
static inline fxl_depth_drawn draw_smooth(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                                          const fxl_surface_polygon *polygon,
                                          const fxl_screen_point *points, uint32_t count,
                                          const fxl_band *band)
{
    const fxl_surface *surface = &surfaces->set->surfaces[polygon->surface];
    if (surface->opacity != 16 || is_blended(surface) || polygon->is_in_beam ||
        !fxl_surface_is_lit(surfaces, surface) || !can_draw_smooth(workspace, band)) {
        return FXL_DEPTH_NOT_DRAWN;
    }
    return clear_and_draw_words(surfaces, workspace, polygon, polygon->colour, points, count, band);
}

#else

static inline fxl_depth_drawn draw_smooth(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                                          const fxl_surface_polygon *polygon,
                                          const fxl_screen_point *points, uint32_t count,
                                          const fxl_band *band)
{
    (void)surfaces;
    (void)workspace;
    (void)polygon;
    (void)points;
    (void)count;
    (void)band;
    return FXL_DEPTH_NOT_DRAWN;
}

#endif

/* A polygon row by row. */
static ROWS_APART void paint_each_row(fxl_depth_painting *depth, const fxl_paint *paint,
                                      const fxl_segment_face *segments,
                                      const fxl_screen_point *points, uint32_t count,
                                      const fxl_band *band, fxl_scan *scan)
{
    fxl_paint_polygon(paint, segments, points, count, band, FXL_TARGET_PIXEL_BITS / 8, scan,
                      paint_row, depth);
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
    fxl_depth_begin(&depth, workspace->target_memory, &polygon->depth, band);
    if (is_blended(surface)) {
        depth.keeps = FXL_DEPTH_KEEPS_NONE;
    } else if (paint.opacity < 16 || (paint.level.flags & FXL_TEXTURE_KEYED)) {
        depth.keeps = FXL_DEPTH_KEEPS_DRAWN;
    }
    const fxl_segment_face *segments = segments_of(&paint, &face);
    if (depth.keeps == FXL_DEPTH_KEEPS_DRAWN && has_hole_kernel(&paint, segments)) {
        depth.keeps = FXL_DEPTH_TESTED;
    }
#if HAS_RUNS
    if (depth.keeps == FXL_DEPTH_KEEPS_ALL && fxl_depth_rows_take(&depth)) {
        fxl_scan_outline(points, count, band, &workspace->work.scan);
        if (workspace->work.scan.by_chains) {
            return paint_plain(&paint, segments, &depth, band, &workspace->work.scan);
        }
    }
#endif
    paint_each_row(&depth, &paint, segments, points, count, band, &workspace->work.scan);
    return false;
}

/* Returns true if it is known that the polygon reaches a row of the band. What clears has little of
 * others on the stack below it. */
static bool paint_surface(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                          const fxl_surface_polygon *polygon, const fxl_screen_point *points,
                          uint32_t count, const fxl_band *band)
{
    const fxl_surface *surface = &surfaces->set->surfaces[polygon->surface];
    if (fxl_depth_is_in_words(&polygon->depth)) {
        const fxl_depth_drawn drawn =
            draw_smooth(surfaces, workspace, polygon, points, count, band);
        if (drawn != FXL_DEPTH_NOT_DRAWN) {
            return drawn == FXL_DEPTH_DRAWN;
        }
    }
    if (((const fxl_depth_head *)workspace->target_memory)->pass ==
        (is_blended(surface) ? FXL_DEPTH_OPAQUE : FXL_DEPTH_BLENDED)) {
        return false;
    }
    if (polygon->gradients.count == 1) {
        clear_under(workspace, points, count, band);
    } else {
        fxl_depth_clear_rest(workspace, band, FXL_TARGET_DEPTH_BITS / 8);
    }
    return paint_by_rows(surfaces, workspace, polygon, points, count, band);
}

#if FXL_TARGET_DEPTH_BITS == 32
#define FIND_DEPTH  fxl_find_exact_depth
#define FIND_LINEAR NULL
#else
#define FIND_DEPTH  fxl_find_depth
#define FIND_LINEAR fxl_find_smooth_planes
#endif

#endif

/* --- a face --------------------------------------------------------------------------------- */

/* fxl_polygon_finder. */
static inline __attribute__((always_inline)) void
find(const void *what, const fxl_model_view *model_view, const fxl_face *face,
     const fxl_traversal *traversal, fxl_surface_polygon *polygon)
{
    const fxl_mapped_surface *of = (const fxl_mapped_surface *)what;
    fxl_surface_find(of->surfaces, of->mapped, model_view, face, traversal, FIND_DEPTH, FIND_LINEAR,
                     polygon);
}

/* fxl_polygon_painter. */
static inline __attribute__((always_inline)) bool
paint_polygon(const void *what, fxl_workspace *workspace, const fxl_surface_polygon *polygon,
              const fxl_screen_point *points, uint32_t count, const fxl_tiny *tiny,
              const fxl_band *band)
{
    (void)tiny;
    return paint_surface(((const fxl_mapped_surface *)what)->surfaces, workspace, polygon, points,
                         count, band);
}

/* The same for a piece of a face: its texels, light and depth are those of the whole face. Not
 * inline: the view of the whole face would stay on the stack while the piece is painted. */
static __attribute__((noinline)) void find_whole(const void *what, const fxl_model_view *model_view,
                                                 const fxl_face *face,
                                                 const fxl_traversal *traversal,
                                                 fxl_surface_polygon *polygon)
{
    const fxl_pieces *pieces = ((const fxl_mapped_surface *)what)->pieces;
    FXL_ALIGN_8 fxl_turned_view view;
    (void)model_view;
    (void)face;
    find(what, fxl_surfaces_view(traversal, pieces->instance, &view), pieces->face, traversal,
         polygon);
}

/* The polygons of a face, or of a piece of one, by what finds what they have. */
FXL_ONCE fxl_outcome submit_polygons(const fxl_model_view *model_view, const fxl_face *face,
                                     const fxl_traversal *traversal, fxl_polygon_finder *finder,
                                     const fxl_mapped_surface *of, fxl_surface_polygon *polygon,
                                     bool found)
{
    return fxl_submit_found_polygons(model_view, face, traversal, finder, paint_polygon, of,
                                     polygon, found);
}

/* fxl_painter.submit_piece. */
static fxl_outcome submit_piece(const fxl_mapped_surface *of, const fxl_model_view *model_view,
                                const fxl_face *piece, const fxl_traversal *traversal)
{
    return submit_polygons(model_view, piece, traversal, find_whole, of, of->polygon, of->is_found);
}

/* A mapped face that no beam reaches. Not inline: what its polygons have would stay on the stack
 * while a face is split. */
static __attribute__((noinline)) bool submit_mapped(const fxl_model_view *model_view,
                                                    const fxl_face *face,
                                                    const fxl_traversal *traversal,
                                                    const fxl_mapped_surface *of)
{
    const uint32_t used = traversal->renderer->frame.display_list.used;
    fxl_surface_polygon polygon;
    return fxl_count_outcome(
        traversal, submit_polygons(model_view, face, traversal, find, of, &polygon, false), used);
}

#if FXL_DRAWS_DEPTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16

/* Whether what the clipper leaves of a mapped face is drawn at once, as one polygon, by the kernel
 * of smooth outlines if its planes are in words. */
static inline bool may_be_smooth(const fxl_surfaces *surfaces, const fxl_mapped_face *mapped,
                                 const fxl_traversal *traversal)
{
    return surfaces->light != NULL &&
           fxl_has_light_alone(surfaces, &surfaces->set->surfaces[mapped->surface]) &&
           traversal->display_list == NULL && traversal->mode != FXL_SUBMIT_MEASURE &&
           traversal->clipper->next == NULL &&
           can_draw_smooth(traversal->workspace, traversal->band);
}

/* Such a face, from its corners to its pixels. False if its planes are no words, or the kernel
 * cannot scan it: then nothing is drawn or counted. */
static __attribute__((noinline)) bool draw_smooth_face(const fxl_surfaces *surfaces,
                                                       const fxl_mapped_face *mapped,
                                                       const fxl_model_view *model_view,
                                                       const fxl_face *face,
                                                       const fxl_traversal *traversal)
{
    fxl_workspace *workspace = traversal->workspace;
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_screen_polygon *screen = &workspace->screen;
    fxl_counters *counters = traversal->counters;
    const fxl_clip_result cut = fxl_first_polygon(model_view, face, traversal);
    fxl_surface_polygon polygon;
    fxl_screen_corners corners;
    int32_t light[3];
    if (cut > FXL_CLIP_CUT) {
        return fxl_count_outcome(traversal, (fxl_outcome)1 << cut, 0);
    }
    if (!fxl_find_screen_corners(model_view, face, mapped->vertices, traversal, &corners)) {
        return false;
    }
    surfaces->light_code->light_corners(surfaces, renderer, model_view->instance, mapped, light);
    if (!FIND_LINEAR(&corners, &model_view->view->lens, light, &polygon.gradients,
                     &polygon.depth)) {
        return false;
    }
    const fxl_depth_drawn drawn =
        clear_and_draw_words(surfaces, workspace, &polygon, face->material, screen->points,
                             screen->count, traversal->band);
    if (drawn == FXL_DEPTH_NOT_DRAWN) {
        return false;
    }
    if (drawn == FXL_DEPTH_DRAWN ||
        fxl_outline_has_rows(screen, renderer->frame.view.lens.height)) {
        counters->spilled += 1;
    }
    counters->drawn += 1;
    if (cut == FXL_CLIP_CUT) {
        counters->clipped += 1;
    }
    return true;
}

#endif

/* fxl_shader_code.face. */
static bool submit(const fxl_model_view *model_view, const fxl_face *face,
                   const fxl_traversal *traversal, const fxl_shader *shader)
{
    const fxl_surfaces *surfaces = (const fxl_surfaces *)(const void *)shader;
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_mapped_face *mapped;
    const fxl_surface_set *set = surfaces->set;
    uint32_t number = 0;
    if (surfaces->beams == NULL && renderer->target == &FXL_TARGET) {
        number = set->face_map[face - renderer->scene->faces];
    }
    if (number != 0) {
        mapped = &set->faces[number - 1];
#if FXL_DRAWS_DEPTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16
        if (may_be_smooth(surfaces, mapped, traversal) &&
            draw_smooth_face(surfaces, mapped, model_view, face, traversal)) {
            return true;
        }
#endif
    } else {
        bool fitted;
        mapped = fxl_surfaces_take(surfaces, model_view, face, traversal, &fitted);
        if (mapped == NULL) {
            return fitted;
        }
    }
    const fxl_mapped_surface of = {surfaces, mapped, NULL, NULL, false};
    return submit_mapped(model_view, face, traversal, &of);
}

static void draw(const fxl_surfaces *surfaces, fxl_workspace *workspace,
                 const fxl_screen_polygon *record, const fxl_band *band)
{
    fxl_surface_polygon polygon;
    const uint32_t count = fxl_surface_polygon_read(record, &polygon);
    (void)paint_surface(surfaces, workspace, &polygon, record->points, count, band);
}

static const fxl_shader_code code = {fxl_surfaces_reach, submit, fxl_surfaces_split, NULL, NULL,
                                     fxl_surfaces_map};

const fxl_painter FXL_TARGET_SURFACES = {&FXL_TARGET,  &code,      draw,
                                         submit_piece, find_whole, FIND_COLOURS};

#endif
