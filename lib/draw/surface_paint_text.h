/* SPDX-License-Identifier: MIT */
/* How a polygon of a surface is painted in the format of a target (pixel_row.h): its paint, and the
 * kernels for its pixels. No other part of surfaces_text.h names a format. Internal. */
#ifndef FXL_SURFACE_PAINT_TEXT_H
#define FXL_SURFACE_PAINT_TEXT_H

#include "../math/family.h"
#include "../paint/corner_colours.h"
#include "../paint/paint_polygon.h"
#include "../paint/texture_level.h"
#include "pixel_row.h"
#include "surface_polygon.h"

/* place pixel-format: how surfaces are painted in a format */
#if FXL_TARGET_FORMAT == FXL_RGB565_PIXELS

#define PAINT_PIXELS   fxl_paint_pixels_565
#define PAINT_ROWS     (FXL_IS_SMALL ? NULL : fxl_paint_rows_565) /* small_row.h has none */
#define PAINT_RUNS     fxl_paint_runs_565
#define PAINT_LIT_RUNS NULL
#define PAINT_HOLES    fxl_paint_holes_565
#define FIND_COLOURS   fxl_find_colours
#define COLOURS        (&colours)

static const fxl_colours_code colours = {
    fxl_paint_colours_565,
#if !FXL_IS_COMPACT
    fxl_paint_colour_polygon,
#else
    NULL,
#endif
#if FXL_HAS_DEPTH_ROWS
    fxl_paint_colour_runs,
#else
    NULL,
#endif
#if FXL_DRAWS_SMOOTH_OUTLINES && FXL_TARGET_DEPTH_BITS == 16
    FXL_DRAW_COLOURS,
#else
    NULL,
#endif
};

/* place light: RGB565: the part of a colour that light leaves of a lit surface */
/* What a paint of colours needs to show light. Requires paint->ramp. */
static inline void mix_light(const fxl_surfaces *surfaces, const fxl_band *band, fxl_paint *paint)
{
    const uint32_t levels = paint->levels_less_1;
    paint->of_565.palette = band->palette;
    paint->of_565.part_of_level = (65536u + levels / 2) / levels;
    paint->of_565.dark = surfaces->light->settings.dark;
}

/* place stipple: a blend: what a surface says of it, in RGB565 */
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
        mix_light(surfaces, band, paint);
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

#define PAINT_PIXELS   fxl_paint_pixels
#define PAINT_ROWS     fxl_paint_rows
#define PAINT_RUNS     fxl_paint_runs
#define PAINT_LIT_RUNS fxl_paint_lit_runs
#define PAINT_HOLES    fxl_paint_holes
#define FIND_COLOURS   NULL
#define COLOURS        NULL

static inline void mix_light(const fxl_surfaces *surfaces, const fxl_band *band, fxl_paint *paint)
{
    (void)surfaces;
    (void)band;
    (void)paint;
}

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
           (FXL_PIXEL_IS_MIXED ? !paint->is_evenly_lit : paint->in_beam == NULL);
}

#endif
