/* SPDX-License-Identifier: MIT */
#include "smooth_outline.h"

#include "../math/family.h"
#include "../raster/fill.h"
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
    const uint32_t part = (uint32_t)(fxl_multiply_u32(at->light, of->part_of_level) >> 32);
    return fxl_mixed_565(&of->mixture, colour, part);
}

static inline void step(fxl_texel_words *at, const fxl_texel_words *along)
{
    at->code += along->code;
    at->u += along->u;
    at->v += along->v;
    at->light += along->light;
}

/* count pixels of a row, from 1 on, of a face of one octave, near to far. The compiler cannot tell
 * pixels from what the loop reads, so it has copies. */
static inline __attribute__((always_inline)) void paint_near(const fxl_texel_outline *face,
                                                             fxl_texel_words at, uint16_t *cell,
                                                             uint16_t *pixel, uint32_t count,
                                                             bool is_lit, bool is_wide)
{
    const fxl_texel_outline of = *face;
    for (const uint16_t *end = cell + count; cell != end; cell++, pixel++) {
        if (at.code >> 16 > *cell) {
            *cell = (uint16_t)(at.code >> 16);
            *pixel = (uint16_t)colour_of(&of, &at, is_lit, is_wide);
        }
        step(&at, &of.along);
    }
}

/* The same of any face, in any order. */
static inline void paint_any(const fxl_texel_outline *of, fxl_texel_words at, uint16_t *cell,
                             uint16_t *pixel, uint32_t count)
{
    for (const uint16_t *end = cell + count; cell != end; cell++, pixel++) {
        const uint32_t code = at.code < of->border ? 2u * at.code - of->border : at.code;
        if (code >> 16 > *cell || (of->or_equal && code >> 16 == *cell)) {
            *cell = (uint16_t)(code >> 16);
            *pixel = (uint16_t)colour_of(of, &at, of->part_of_level != 0, of->is_wide != 0);
        }
        step(&at, &of->along);
    }
}

static inline fxl_texel_words words_at(const fxl_texel_words *at, const fxl_texel_words *along,
                                       uint32_t count)
{
    const fxl_texel_words there = {at->code + along->code * count, at->u + along->u * count,
                                   at->v + along->v * count, at->light + along->light * count};
    return there;
}

/* --- rows ----------------------------------------------------------------------------------- */

/* Whether rows have a loop for each kind of texels: not where the kernel draws nearly all of them, nor where
 * flash is scarce. */
#define HAS_LOOPS (!FXL_DRAWS_SMOOTH_OUTLINES && !FXL_IS_COMPACT && !FXL_CORE_ARMV6M)

/* How the pixels of rows are painted. */
enum {
    TEXELS,
    WIDE_TEXELS,
    LIT_TEXELS,
    WIDE_LIT_TEXELS,
    ANY
};

/* All rows of a scan. */
static inline __attribute__((always_inline)) void
paint_rows(const fxl_texel_outline *of, const fxl_band *band, fxl_scan *scan, uint32_t kind)
{
    const uint32_t width = band->width, stride = band->stride;
    const fxl_texel_words down = of->down;
    const fxl_trapezoid *trapezoid;
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        const uint32_t row = (uint32_t)(trapezoid->first_row - band->first_row);
        fxl_texel_words at = words_at(&of->at, &down, (uint32_t)trapezoid->first_row);
        uint16_t *cell = of->cells + (size_t)row * width;
        uint16_t *pixel = (uint16_t *)(void *)band->pixels + (size_t)row * stride;
        fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
        for (int32_t rows = trapezoid->end_row - trapezoid->first_row; rows > 0; rows--) {
            const int32_t x0 = a.x < b.x ? a.x : b.x, x1 = a.x < b.x ? b.x : a.x;
            if (x0 < x1) {
                const fxl_texel_words from = words_at(&at, &of->along, (uint32_t)x0);
                const uint32_t count = (uint32_t)(x1 - x0);
                if (kind == ANY) {
                    paint_any(of, from, cell + x0, pixel + x0, count);
                } else {
                    paint_near(of, from, cell + x0, pixel + x0, count, kind >= LIT_TEXELS,
                               (kind & WIDE_TEXELS) != 0);
                }
            }
            fxl_edge_step(&a);
            fxl_edge_step(&b);
            step(&at, &down);
            cell += width;
            pixel += stride;
        }
    }
}

/* A word of a coordinate as it is in a level, scaled: shifted by so many bits, at most 16. What wraps wraps by
 * a whole number of textures. */
static inline uint32_t shifted(int64_t value, uint32_t drop)
{
    return (uint32_t)((int32_t)value >> drop);
}

static inline void set_words(const fxl_paint *paint, const fxl_depth_plane *depth,
                             fxl_texel_outline *of)
{
    const fxl_gradients *gradients = paint->gradients;
    const fxl_gradient *u = &gradients->attributes[FXL_ATTRIBUTE_U];
    const fxl_gradient *v = &gradients->attributes[FXL_ATTRIBUTE_V];
    const uint32_t u_drop = (uint32_t)(FXL_SHIFT_OF_TEXELS - gradients->shifts[FXL_ATTRIBUTE_U]);
    const uint32_t v_drop = (uint32_t)(FXL_SHIFT_OF_TEXELS - gradients->shifts[FXL_ATTRIBUTE_V]) +
                            8u - paint->level.log_width;
    of->at.code = (uint32_t)depth->gradient.at;
    of->down.code = (uint32_t)depth->gradient.down;
    of->along.code = (uint32_t)depth->gradient.along;
    of->at.u = shifted(u->at, u_drop);
    of->down.u = shifted(u->down, u_drop);
    of->along.u = shifted(u->along, u_drop);
    of->at.v = shifted(v->at, v_drop);
    of->down.v = shifted(v->down, v_drop);
    of->along.v = shifted(v->along, v_drop);
    of->at.light = paint->is_evenly_lit ? (uint32_t)paint->light << 16 : 0;
    of->down.light = of->along.light = 0;
    if (gradients->count > FXL_SEGMENT_LIGHT) {
        const fxl_gradient *light = &gradients->attributes[FXL_SEGMENT_LIGHT];
        of->at.light = (uint32_t)light->at;
        of->down.light = (uint32_t)light->down;
        of->along.light = (uint32_t)light->along;
    }
}

static inline void set_texels(const fxl_paint *paint, const fxl_depth_head *head,
                              const fxl_depth_plane *depth, fxl_texel_outline *of)
{
    const fxl_texture_level *level = &paint->level;
    const fxl_paint_565 *colours = &paint->of_565;
    of->cells = (uint16_t *)(uintptr_t)(head + 1);
    of->texels = level->texels;
    of->palette = colours->palette;
    of->columns_mask = level->columns_less_1;
    of->rows_mask = level->rows_less_1 << level->log_width;
    of->border = fxl_depth_border(head->scale, depth);
    of->or_equal = head->or_equal;
    of->is_wide = (level->flags & FXL_LEVEL_565) != 0;
    of->part_of_level = colours->part_of_level;
    of->mixture.red_dark = of->mixture.red_step = 0;
    of->mixture.green_dark = of->mixture.green_step = 0;
    if (of->part_of_level != 0) {
        of->mixture = fxl_mixture_of_565(0, colours->dark);
        of->at.light += fxl_half_part_565(paint->levels_less_1) - (1u << 23);
    }
}

#if FXL_DRAWS_SMOOTH_OUTLINES

/* A row of cells is `cells` pixels along. */
static inline void count_cells(uint32_t *at, uint32_t *down, uint32_t along, uint32_t cells,
                               uint32_t first_row)
{
    const uint32_t row = cells * along;
    *down -= row;
    *at += first_row * row - *down;
}

/* The same by the kernel. False: it cannot scan the polygon, and nothing is drawn. */
static inline bool draw_by_kernel(const fxl_texel_outline *of, const void *memory,
                                  const fxl_screen_point *points, uint32_t count,
                                  const fxl_band *band, bool *reaches)
{
    const fxl_depth_head *head = (const fxl_depth_head *)memory;
    if (of->border != 0 || !fxl_depth_outline_can_draw(head, band, 2)) {
        return false;
    }
    const uint32_t cells = band->width, first = band->first_row;
    fxl_texel_outline kernel = *of;
    count_cells(&kernel.at.code, &kernel.down.code, of->along.code, cells, first);
    count_cells(&kernel.at.u, &kernel.down.u, of->along.u, cells, first);
    count_cells(&kernel.at.v, &kernel.down.v, of->along.v, cells, first);
    count_cells(&kernel.at.light, &kernel.down.light, of->along.light, cells, first);
    kernel.pixels = fxl_depth_outline_pixels(head, band, 2) - 2u;
    const fxl_depth_drawn drawn = fxl_draw_texel_outline(points, count, band, &kernel);
    *reaches = drawn == FXL_DEPTH_DRAWN;
    return drawn != FXL_DEPTH_NOT_DRAWN;
}

#else

static inline bool draw_by_kernel(const fxl_texel_outline *of, const void *memory,
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

bool fxl_draw_texels(const fxl_paint *paint, const fxl_depth_plane *depth, const void *memory,
                     const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                     fxl_scan *scan)
{
    const uint32_t lit = paint->of_565.part_of_level != 0 ? LIT_TEXELS : TEXELS;
    fxl_texel_outline of;
    bool reaches;
    set_words(paint, depth, &of);
    set_texels(paint, (const fxl_depth_head *)memory, depth, &of);
    if (draw_by_kernel(&of, memory, points, count, band, &reaches)) {
        return reaches;
    }
    fxl_scan_outline(points, count, band, scan);
    if (!fxl_scan_reaches(scan, band)) {
        return false;
    }
    if (!HAS_LOOPS || of.or_equal || of.border != 0) {
        paint_rows(&of, band, scan, ANY);
    } else if (lit == TEXELS) {
        if (of.is_wide) {
            paint_rows(&of, band, scan, WIDE_TEXELS);
        } else {
            paint_rows(&of, band, scan, TEXELS);
        }
    } else if (of.is_wide) {
        paint_rows(&of, band, scan, WIDE_LIT_TEXELS);
    } else {
        paint_rows(&of, band, scan, LIT_TEXELS);
    }
    return true;
}
