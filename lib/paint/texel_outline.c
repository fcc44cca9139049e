/* SPDX-License-Identifier: MIT */
#include "smooth_outline.h"

#include "../math/family.h"
#include "outline_rows.h"
#include "rgb565_colour.h"
#include "segments.h"
#include "texture_level.h"

/* place sampling: texels by words, of textures that repeat */
/* place light: RGB565: the part of a colour that light leaves of a triangle in words */
/* place pixel-format: the pixels of triangles in words */
/* SPEC 9.5 */
static inline uint32_t colour_of(const fxl_texel_outline *of, const fxl_texel_words *at,
                                 bool is_lit, bool is_wide)
{
    const uint32_t place = (at->v >> 16 & of->rows_mask) + (at->u >> 24 & of->columns_mask);
    const uint32_t colour = is_wide ? ((const uint16_t *)(const void *)of->texels)[place]
                                    : of->palette[of->texels[place]];
    if (!is_lit) {
        return colour;
    }
    return fxl_mixed_565(&of->mixture, colour, fxl_part_of_565(at->light, of->part_of_level));
}

static inline void step(fxl_texel_words *at, const fxl_texel_words *along)
{
    at->code += along->code;
    at->u += along->u;
    at->v += along->v;
    at->light += along->light;
}

/* Pixels of a row of a face of one octave, near to far. The compiler cannot tell pixels from what the
 * loop reads, so it has copies. */
static inline __attribute__((always_inline)) void paint_near(const fxl_texel_outline *face,
                                                             fxl_texel_words at,
                                                             const fxl_outline_row *row,
                                                             bool is_lit, bool is_wide)
{
    const fxl_texel_outline of = *face;
    const uint16_t *end = row->cell + row->count;
    uint16_t *pixel = (uint16_t *)(void *)row->pixel;
    for (uint16_t *cell = row->cell; cell != end; cell++, pixel++) {
        if (fxl_keep_nearer(cell, at.code)) {
            *pixel = (uint16_t)colour_of(&of, &at, is_lit, is_wide);
        }
        step(&at, &of.planes.along);
    }
}

/* The same of any face, in any order. */
static inline void paint_any(const fxl_texel_outline *of, fxl_texel_words at,
                             const fxl_outline_row *row)
{
    const uint16_t *end = row->cell + row->count;
    uint16_t *pixel = (uint16_t *)(void *)row->pixel;
    for (uint16_t *cell = row->cell; cell != end; cell++, pixel++) {
        const uint32_t code = at.code < of->border ? 2u * at.code - of->border : at.code;
        if (code >> 16 > *cell || (of->or_equal && code >> 16 == *cell)) {
            *cell = (uint16_t)(code >> 16);
            *pixel = (uint16_t)colour_of(of, &at, (of->kind & FXL_TEXELS_LIT) != 0,
                                         (of->kind & FXL_TEXELS_WIDE) != 0);
        }
        step(&at, &of->planes.along);
    }
}

/* --- rows ----------------------------------------------------------------------------------- */

/* Whether rows have a loop for each kind of texels: not where the kernel draws nearly all of them, nor where
 * flash is scarce. */
#define HAS_LOOPS (!FXL_DRAWS_SMOOTH_OUTLINES && !FXL_IS_COMPACT && !FXL_CORE_ARMV6M)

/* As kind, beside FXL_TEXELS_WIDE and _LIT: pixels of any kind, in any order. */
#define ANY FXL_TEXELS_BENT

static inline fxl_texel_words words_of(const fxl_texel_planes *of, const fxl_outline_row *row)
{
    const uint32_t x = row->x, y = row->y;
    const fxl_texel_words words = {of->at.code + of->down.code * y + of->along.code * x,
                                   of->at.u + of->down.u * y + of->along.u * x,
                                   of->at.v + of->down.v * y + of->along.v * x,
                                   of->at.light + of->down.light * y + of->along.light * x};
    return words;
}

/* fxl_outline_row_painter. */
static inline __attribute__((always_inline)) void paint_row(const void *with, uint32_t kind,
                                                            fxl_outline_row row)
{
    const fxl_texel_outline *of = (const fxl_texel_outline *)with;
    const fxl_texel_words at = words_of(&of->planes, &row);
    if (kind == ANY) {
        paint_any(of, at, &row);
    } else {
        paint_near(of, at, &row, (kind & FXL_TEXELS_LIT) != 0, (kind & FXL_TEXELS_WIDE) != 0);
    }
}

/* All rows of a scan. */
static inline __attribute__((always_inline)) void
paint_rows(const fxl_texel_outline *of, const fxl_band *band, fxl_scan *scan, uint32_t kind)
{
    fxl_paint_outline_rows(band, of->cells, 2, scan, paint_row, of, kind);
}

#if FXL_DRAWS_SMOOTH_OUTLINES

/* The same by the kernel. False: it cannot scan the polygon, and nothing is drawn. */
static inline bool draw_by_kernel(fxl_texel_outline *of, const void *memory,
                                  const fxl_screen_point *points, uint32_t count,
                                  const fxl_band *band, bool *reaches)
{
    const fxl_depth_head *head = (const fxl_depth_head *)memory;
    if (!fxl_depth_outline_can_draw(head, band, 2)) {
        return false;
    }
    of->pixels = fxl_depth_outline_pixels(head, band, 2) - 2u;
    const fxl_depth_drawn drawn = fxl_draw_texel_outline(points, count, band, of);
    *reaches = drawn == FXL_DEPTH_DRAWN;
    return drawn != FXL_DEPTH_NOT_DRAWN;
}

#else

static inline bool draw_by_kernel(fxl_texel_outline *of, const void *memory,
                                  const fxl_screen_point *points, uint32_t count,
                                  const fxl_band *band, bool *reaches)
{
    (void)of;
    (void)memory;
    (void)points;
    (void)count;
    (void)band;
    (void)reaches;
    return false;
}

#endif

bool fxl_draw_texel_words(fxl_texel_outline *of, const void *memory,
                          const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                          fxl_scan *scan)
{
    bool reaches;
    if (draw_by_kernel(of, memory, points, count, band, &reaches)) {
        return reaches;
    }
    fxl_scan_outline(points, count, band, scan);
    if (!fxl_scan_reaches(scan, band)) {
        return false;
    }
    switch (HAS_LOOPS && !of->or_equal ? of->kind : ANY) {
    case 0:
        paint_rows(of, band, scan, 0);
        break;
    case FXL_TEXELS_WIDE:
        paint_rows(of, band, scan, FXL_TEXELS_WIDE);
        break;
    case FXL_TEXELS_LIT:
        paint_rows(of, band, scan, FXL_TEXELS_LIT);
        break;
    case FXL_TEXELS_LIT | FXL_TEXELS_WIDE:
        paint_rows(of, band, scan, FXL_TEXELS_LIT | FXL_TEXELS_WIDE);
        break;
    default:
        paint_rows(of, band, scan, ANY);
        break;
    }
    return true;
}

/* --- what an outline is drawn by -------------------------------------------------------------- */

void fxl_texel_outline_of_surface(const fxl_depth_head *head, const fxl_paint *paint,
                                  fxl_texel_outline *of)
{
    const fxl_texture_level *level = &paint->level;
    const fxl_paint_565 *colours = &paint->of_565;
    of->cells = (uint16_t *)(uintptr_t)(head + 1);
    of->texels = level->texels;
    of->palette = colours->palette;
    of->columns_mask = level->columns_less_1;
    of->rows_mask = level->rows_less_1 << level->log_width;
    of->or_equal = head->or_equal;
    of->part_of_level = colours->part_of_level;
    of->kind = ((level->flags & FXL_LEVEL_565) != 0 ? FXL_TEXELS_WIDE : 0u) |
               (of->part_of_level != 0 ? FXL_TEXELS_LIT : 0u);
    of->mixture.red_dark = of->mixture.red_step = 0;
    of->mixture.green_dark = of->mixture.green_step = 0;
    if (of->part_of_level != 0) {
        of->mixture = fxl_mixture_of_565(0, colours->dark);
    }
}

void fxl_texel_outline_of_face(const fxl_depth_head *head, const fxl_paint *paint, int32_t one,
                               fxl_texel_outline *of)
{
    const bool is_lit = of->part_of_level != 0;
    of->border = fxl_depth_border_of(head->scale, one);
    of->kind = (of->kind & (FXL_TEXELS_WIDE | FXL_TEXELS_LIT)) |
               (of->border != 0 ? FXL_TEXELS_BENT : 0u);
#if FXL_DRAWS_SMOOTH_OUTLINES
    if (is_lit && paint->of_565.dark == 0) {
        of->kind |= FXL_TEXELS_BLACK;
    }
#endif
    if (paint->is_evenly_lit || !is_lit) {
        of->planes.at.light = paint->is_evenly_lit ? (uint32_t)paint->light << 16 : 0;
        of->planes.down.light = of->planes.along.light = 0;
    }
    if (is_lit) {
        of->planes.at.light += fxl_texel_light_more(paint->levels_less_1);
    }
}

bool fxl_draw_texels(const fxl_paint *paint, const fxl_depth_plane *depth, const void *memory,
                     const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                     fxl_scan *scan)
{
    const int8_t *shifts = paint->gradients->shifts;
    const uint32_t u_drop = (uint32_t)(FXL_SHIFT_OF_TEXELS - shifts[FXL_ATTRIBUTE_U]);
    const uint32_t v_drop = (uint32_t)(FXL_SHIFT_OF_TEXELS - shifts[FXL_ATTRIBUTE_V]) + 8u -
                            paint->level.log_width;
    fxl_texel_outline of;
    fxl_texel_words_of(paint->gradients, depth, &of.planes);
    fxl_texel_planes_scale(&of.planes, u_drop, v_drop);
    fxl_texel_outline_of_surface((const fxl_depth_head *)memory, paint, &of);
    fxl_texel_outline_of_face((const fxl_depth_head *)memory, paint, depth->one, &of);
    return fxl_draw_texel_words(&of, memory, points, count, band, scan);
}
