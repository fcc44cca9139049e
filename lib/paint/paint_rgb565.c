/* SPDX-License-Identifier: MIT */
#include "colour_run.h"
#include "corner_colours.h"
#include "light_row.h"
#include "texel_place.h"
#include "texture_level.h"
#include "../raster/fill.h"
#include "rgb565_colour.h"

/* place sampling: the loops; paint_repeated is that for textures that repeat */
/* place pixel-format: a new file beside it: the pixels of a surface */
/* The colour of a texel. False: it is the key. */
/* beams 6.2, rgb565 1.3 */
static inline bool look_up(const fxl_paint *paint, int32_t i, int32_t j, uint16_t *colour)
{
    const fxl_texture_level *level = &paint->level;
    const fxl_paint_565 *of = &paint->of_565;
    const uint32_t place = fxl_texel_place(level, i, j);
    const bool is_keyed = (level->flags & FXL_TEXTURE_KEYED) != 0;
    if (level->flags & FXL_LEVEL_565) {
        *colour = ((const uint16_t *)(const void *)level->texels)[place];
        return !is_keyed || *colour != of->key;
    }
    const uint8_t index = fxl_texel_index(level, place);
    *colour = of->palette[level->flags & FXL_LEVEL_IN_BEAM ? paint->in_beam[index] : index];
    return !is_keyed || index != level->key;
}

/* place light: RGB565: the part of a colour that light leaves of a lit surface */
/* How much of 256 parts of a colour light leaves. light: in 16.16 levels, and a half. Held within
 * the ramp and with 8 bits after the point it is below 2^14, and 2^24 times the part of a level at
 * most: that is 2^16 / (levels - 1), whose rounding costs 1/8 of 1/256. */
/* rgb565 2.1 */
static inline uint32_t part_of_light(const fxl_paint *paint, int32_t light)
{
    const int32_t most = paint->levels_less_1 << 16;
    const int32_t above = light < 32768 ? 0 : light - 32768;
    const uint32_t level = (uint32_t)(above > most ? most : above) >> 8;
    return (level * paint->of_565.part_of_level + 32768u) >> 16;
}

/* place stipple: what a pixel does, in RGB565 */
/* A pixel whose attributes are known. What blends or adds comes after it: paint_mixed. */
/* surfaces 4.1 */
static inline void paint_pixel(const fxl_paint *paint, const fxl_paint_row *row, int32_t x,
                               const int32_t values[FXL_ATTRIBUTES])
{
    const fxl_paint_565 *of = &paint->of_565;
    uint16_t *pixel = (uint16_t *)(void *)row->pixels + x;
    uint16_t colour = of->palette[paint->colour];
    if (fxl_is_stippled_away(paint->opacity, x, row->y)) {
        return;
    }
    if (paint->level.texels != NULL &&
        !look_up(paint, values[FXL_ATTRIBUTE_U] >> 16, values[FXL_ATTRIBUTE_V] >> 16, &colour)) {
        return;
    }
    if (of->part_of_level != 0) {
        const uint32_t part = part_of_light(
            paint, paint->is_evenly_lit ? paint->light << 8 : values[paint->gradients->count - 1]);
        colour = fxl_mix_565(colour, of->dark, part);
    }
    *pixel = colour;
}

#include "lit_row.h"

#if FXL_IS_SMALL
#include "small_row.h"
#endif

/* Opaque texels of 16 or of 8 bits, repeated and without a key: paint_pixel's colours. The compiler
 * cannot tell pixels from what the loop reads, so it has copies. */
static inline __attribute__((always_inline)) void
paint_repeated(const fxl_paint *paint, const linear_pixels *linear, uint16_t *pixel,
               const uint16_t *end, bool is_wide, bool lit)
{
    const fxl_paint copy = *paint;
    const fxl_texture_level *level = &paint->level;
    const uint8_t *texels = level->texels;
    const uint16_t *wide = (const uint16_t *)(const void *)texels, *palette = paint->of_565.palette;
    const uint32_t columns = level->columns_less_1, rows = level->rows_less_1 << level->log_width;
    const uint32_t row_drop = 16u - level->log_width; /* log_width is at most 8 */
    const fxl_mixture_565 mixture = fxl_mixture_of_565(0, paint->of_565.dark);
    uint32_t u = linear->values[FXL_ATTRIBUTE_U], v = linear->values[FXL_ATTRIBUTE_V];
    uint32_t light = linear->values[FXL_ATTRIBUTES - 1]; /* light follows u and v, or is none */
    if (paint->is_evenly_lit) {
        light = (uint32_t)paint->light << 8;
    }
    const uint32_t u_step = linear->steps[FXL_ATTRIBUTE_U];
    const uint32_t v_step = linear->steps[FXL_ATTRIBUTE_V];
    const uint32_t light_step = linear->steps[FXL_ATTRIBUTES - 1];
    for (; pixel != end; pixel++) {
        const uint32_t place = (v >> row_drop & rows) + (u >> 16 & columns);
        const uint16_t colour = is_wide ? wide[place] : palette[texels[place]];
        *pixel =
            lit ? fxl_mixed_565(&mixture, colour, part_of_light(&copy, (int32_t)light)) : colour;
        u += u_step;
        v += v_step;
        light += light_step;
    }
}

/* Pixels that show texels, in light that is the same everywhere: as of paint_lights, of many colours. */
static void mix_evenly(const fxl_paint *paint, uint16_t *pixel, const uint16_t *end)
{
    const uint32_t dark = paint->of_565.dark, part = part_of_light(paint, paint->light << 8);
    const fxl_mixture_565 mixture = fxl_mixture_of_565(0, dark);
    const uint32_t red_dark = mixture.red_dark + mixture.red_step * part;
    const uint32_t green_dark = mixture.green_dark + mixture.green_step * part;
    for (; pixel != end; pixel++) {
        const uint32_t colour = *pixel;
        const uint32_t red = red_dark + (fxl_red_and_blue_565(colour) >> 8) * part;
        const uint32_t green = green_dark + (colour & FXL_GREEN_565) * part;
        *pixel = (uint16_t)((red >> 16 & FXL_RED_565) | (green >> 8 & FXL_GREEN_565) |
                            (red >> 8 & FXL_BLUE_565));
    }
}

static void paint_linear(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1,
                         const linear_pixels *linear)
{
    if (paint->has_light_rows) {
        const fxl_light_run run = {linear->values[0] << 8, linear->steps[0] << 8};
        paint_lights(paint, row, x0, x1, &run);
        return;
    }
    const uint32_t flags = paint->level.flags;
    if (FXL_IS_COMPACT || paint->opacity < 16 || (flags & ~FXL_LEVEL_565) != 0 ||
        paint->level.texels == NULL || paint->level.colours != NULL) {
        paint_each_linear(paint, row, x0, x1, linear);
        return;
    }
    uint16_t *pixels = (uint16_t *)(void *)row->pixels;
    if (paint->of_565.part_of_level == 0) {
        paint_repeated(paint, linear, pixels + x0, pixels + x1, flags != 0, false);
    } else if (flags != 0) {
        paint_repeated(paint, linear, pixels + x0, pixels + x1, true, true);
    } else {
        paint_repeated(paint, linear, pixels + x0, pixels + x1, false, true);
    }
}

/* Opaque pixels. */
static void paint_opaque(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    uint32_t least[3];
    if (paint->is_light_linear) {
        if (paint->colours != NULL) {
            paint->colours->paint(paint, row, x0, x1);
            return;
        }
        const fxl_light_run run = fxl_light_run_of(paint, row->y, x0);
        paint_lights(paint, row, x0, x1, &run);
        return;
    }
#if FXL_IS_SMALL
    small_column at;
    at.face = NULL;
    at.column = -1;
    fxl_find_least_weights(paint->gradients, paint->division, least);
    while (x0 < x1) {
        const int32_t end = smaller((x0 & ~15) + 16, x1);
        paint_small(paint, row, least, x0, end, &at);
        x0 = end;
    }
#else
    divided_column at;
    least[0] = 0; /* not found yet */
    at.column = -1;
    while (x0 < x1) {
        int32_t end = fxl_segments_end(row, x0, x1);
        if (end > x0) {
            fxl_paint_segments_565(row->segments, row, x0, end);
            if (paint->is_evenly_lit) {
                uint16_t *pixels = (uint16_t *)(void *)row->pixels;
                mix_evenly(paint, pixels + x0, pixels + end);
            }
        } else {
            if (least[0] == 0) {
                fxl_find_least_weights(paint->gradients, paint->division, least);
            }
            end = smaller((x0 & ~15) + 16, x1);
            paint_sixteen(paint, row, least, x0, end, &at);
        }
        x0 = end;
    }
#endif
}

/* What a surface that blends or adds makes of two colours in a word. */
/* rgb565 2.2, 2.3 */
static inline uint32_t mixed_of(uint32_t colours, uint32_t beneath, uint32_t sixteenths)
{
    return sixteenths == 0 ? fxl_add_565(colours, beneath)
                           : fxl_blend_565(colours, beneath, sixteenths);
}

/* Mixes words of two colours each into a row. Not in place for both: the compiler would choose in
 * each round. */
static inline __attribute__((always_inline)) void
mix_words(const fxl_word *colours, fxl_word *pixels, const fxl_word *end, uint32_t sixteenths)
{
    for (; pixels != end; pixels++) {
        *pixels = mixed_of(*colours++, *pixels, sixteenths);
    }
}

/* Mixes colours, at least one, into a row. Requires both at the beginning of a word, or neither. */
static inline void mix_row(uint32_t sixteenths, const uint16_t *colours, uint16_t *pixels,
                           uint32_t count)
{
    if (!FXL_IS_COMPACT) {
        if (((uintptr_t)pixels & 2u) != 0) {
            *pixels = (uint16_t)mixed_of(*colours++, *pixels, sixteenths);
            pixels++;
            count--;
        }
        const fxl_word *above = (const fxl_word *)(const void *)colours;
        fxl_word *words = (fxl_word *)(void *)pixels;
        if (sixteenths == 0) {
            mix_words(above, words, words + count / 2, 0);
        } else {
            mix_words(above, words, words + count / 2, sixteenths);
        }
        colours += count & ~1u;
        pixels += count & ~1u;
        count &= 1u;
    }
    for (; count != 0; count--, pixels++) {
        *pixels = (uint16_t)mixed_of(*colours++, *pixels, sixteenths);
    }
}

/* --- what is mixed -------------------------------------------------------------------------- */

#define MIXED 64 /* columns that are mixed at once */
#define LINES 16 /* at once: of 16 columns, or 5 of 64 that are segments */

/* The colours of texels of 16 or of 8 bits, repeated; where they are keyed, of those that are not
 * the key. The compiler cannot tell them from what the loop reads, so it has copies. */
static inline __attribute__((always_inline)) void
show_lines(const fxl_paint *paint, const texel_line *line, const texel_line *last, uint16_t *colour,
           bool is_wide, bool is_keyed)
{
    const fxl_texture_level level = paint->level;
    const uint16_t *palette = paint->of_565.palette;
    const uint16_t *wide = (const uint16_t *)(const void *)level.texels;
    const uint32_t key = is_wide ? paint->of_565.key : level.key;
    const uint32_t columns = level.columns_less_1, rows = level.rows_less_1 << level.log_width;
    const uint32_t row_drop = 16u - level.log_width; /* log_width is at most 8 */
    for (; line != last; line++) {
        const uint16_t *end = colour + line->count;
        const uint32_t u_step = line->u_step, v_step = line->v_step;
        uint32_t u = line->u, v = line->v;
        do {
            const uint32_t place = (v >> row_drop & rows) + (u >> 16 & columns);
            const uint32_t texel = is_wide ? wide[place] : level.texels[place];
            if (!is_keyed || texel != key) {
                *colour = (uint16_t)(is_wide ? texel : palette[texel]);
            }
            u += u_step;
            v += v_step;
        } while (++colour != end);
    }
}

/* The same of any texels. */
static inline void show_any(const fxl_paint *paint, const texel_line *line, const texel_line *last,
                            uint16_t *colour)
{
    for (; line != last; line++) {
        const uint16_t *end = colour + line->count;
        uint32_t u = line->u, v = line->v;
        for (; colour != end; colour++) {
            uint16_t found;
            if (look_up(paint, (int32_t)u >> 16, (int32_t)v >> 16, &found)) {
                *colour = found;
            }
            u += line->u_step;
            v += line->v_step;
        }
    }
}

static inline bool is_keyed(const fxl_paint *paint)
{
    return (paint->level.flags & FXL_TEXTURE_KEYED) != 0;
}

static inline bool has_holes(const fxl_paint *paint)
{
    return paint->opacity < 16 || is_keyed(paint);
}

/* Which of four columns an opacity draws, from a multiple of 4 on. */
static inline uint32_t drawn_of_four(const fxl_paint *paint, int32_t y)
{
    uint32_t drawn = 15;
    for (int32_t x = 0; x < 4; x++) {
        drawn ^= (uint32_t)fxl_is_stippled_away(paint->opacity, x, y) << x;
    }
    return drawn;
}

/* Has the pixels from column x on that are not drawn stay as they are beneath. */
static inline void leave_out(uint32_t drawn, bool adds, int32_t x, const uint16_t *pixels,
                             uint16_t *colours, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        if ((drawn >> (((uint32_t)x + i) & 3u) & 1u) == 0) {
            colours[i] = adds ? 0 : pixels[i];
        }
    }
}

/* Whether neighbouring texels are shown by lines. Boards with an Armv6-M have little flash, so there
 * these are has_plain_lines alone. */
static inline bool has_lines(const fxl_paint *paint)
{
    return !FXL_IS_COMPACT && !FXL_KERNELS_ARMV6M && paint->level.texels != NULL &&
           (paint->of_565.part_of_level == 0 || (paint->is_evenly_lit && !has_holes(paint)));
}

/* Whether texels are of 8 or 16 bits, repeat and are in no beam. */
static inline bool has_plain_texels(const fxl_paint *paint)
{
    const uint32_t clamp = FXL_TEXTURE_CLAMP, others = clamp | FXL_LEVEL_IN_BEAM;
    return paint->level.colours == NULL && (paint->level.flags & others) == 0;
}

/* Requires has_lines, or is_plain: has_plain_lines; and at most MIXED columns. */
static inline __attribute__((always_inline)) void
show_texels(const fxl_paint *paint, const fxl_paint_row *row, uint32_t x0, uint32_t x1,
            uint16_t *colours, bool is_plain)
{
    const bool is_wide = (paint->level.flags & FXL_LEVEL_565) != 0;
    const uint32_t first = x0;
    texel_line lines[LINES];
    while (x0 != x1) {
        const uint32_t next = (x0 & ~15u) + 16u;
        uint32_t end = x1, log = 4, count;
        const bool are_sixteens = has_sixteens(paint, row, x0, x1);
        if (!are_sixteens) {
            end = next < x1 ? next : x1;
            log = log_at(paint, row, x0);
        }
        if (!FXL_KERNELS_ARMV6M && are_sixteens) { /* constant shifts */
            count = find_lines(paint, row, x0, x1, 4, lines);
        } else {
            count = find_lines(paint, row, x0, end, log, lines);
        }
        if (!is_plain && !has_plain_texels(paint)) {
            show_any(paint, lines, lines + count, colours);
        } else if (is_wide && is_keyed(paint)) {
            show_lines(paint, lines, lines + count, colours, true, true);
        } else if (is_keyed(paint)) {
            show_lines(paint, lines, lines + count, colours, false, true);
        } else if (is_wide) {
            show_lines(paint, lines, lines + count, colours, true, false);
        } else {
            show_lines(paint, lines, lines + count, colours, false, false);
        }
        colours += end - x0;
        x0 = end;
    }
    if (!is_plain && paint->is_evenly_lit) {
        mix_evenly(paint, colours - (x1 - first), colours);
    }
}

#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT

/* fxl_columns_kernel of texels that are blended: they are shown, up to MIXED of them at once, then mixed. */
/* surfaces 4.1 */
static int32_t paint_blended_columns(fxl_lit_run *run, uint16_t *pixels, int32_t x0, int32_t x1)
{
    FXL_ALIGN_8 uint16_t words[MIXED + 1];
    int32_t end, painted;
    do {
        end = smaller((x0 & ~15) + MIXED, x1);
        uint16_t *colours = words + ((uintptr_t)(pixels + x0) >> 1 & 1u);
        const uintptr_t column_0 = (uintptr_t)colours - 2u * (uint32_t)x0;
        painted = fxl_paint_unlit_columns(run, (uint16_t *)column_0, x0, end);
        if (painted != x0) {
            mix_row(run->sixteenths, colours, pixels + x0, (uint32_t)(painted - x0));
        }
        x0 = end;
    } while (painted == end && end != x1);
    return painted;
}

#else

/* Whether all that is shown are such texels, or the key. */
static inline bool has_plain_lines(const fxl_paint *paint)
{
    return !FXL_IS_COMPACT && paint->opacity == 16 && paint->level.texels != NULL &&
           paint->of_565.part_of_level == 0 && has_plain_texels(paint);
}

/* paint_mixed of most textures. */
/* surfaces 4.1 */
static __attribute__((noinline)) void paint_mixed_lines(const fxl_paint *paint,
                                                        const fxl_paint_row *row, int32_t x0,
                                                        int32_t x1)
{
    const uint32_t sixteenths = paint->of_565.sixteenths;
    FXL_ALIGN_8 uint16_t words[MIXED + 1];
    while (x0 < x1) {
        const int32_t end = smaller(x0 + MIXED, x1);
        uint16_t *pixels = (uint16_t *)(void *)row->pixels + x0;
        uint16_t *colours = words + ((uintptr_t)pixels >> 1 & 1u);
        const uint32_t count = (uint32_t)(end - x0);
        if (is_keyed(paint)) {
            leave_out(0, sixteenths == 0, x0, pixels, colours, count);
        }
        show_texels(paint, row, (uint32_t)x0, (uint32_t)end, colours, true);
        mix_row(sixteenths, colours, pixels, count);
        x0 = end;
    }
}

#endif

/* Pixels that are blended with what is beneath, or added to it, or have holes: opaque ones, which
 * are then mixed into the row. A pixel that is not drawn stays as it is beneath: blended with itself
 * a colour is the same, and so is one to which 0 is added. Not inline: what it has would be on the
 * stack of others. */
/* surfaces 4.1 */
static __attribute__((noinline)) void paint_mixed(const fxl_paint *paint, const fxl_paint_row *row,
                                                  int32_t x0, int32_t x1)
{
    const fxl_paint_565 *of = &paint->of_565;
    const uint32_t sixteenths = fxl_is_mixed_565(paint) ? of->sixteenths : 16;
    const bool shows_lines = has_lines(paint), is_stippled = paint->opacity < 16;
    const bool is_in_place = !fxl_is_mixed_565(paint) && !is_stippled;
    const bool begins_beneath = !is_in_place && (shows_lines ? is_keyed(paint) : has_holes(paint));
    FXL_ALIGN_8 uint16_t words[MIXED + 1];
    while (x0 < x1) {
        const int32_t end = smaller(x0 + MIXED, x1);
        uint16_t *pixels = (uint16_t *)(void *)row->pixels + x0;
        uint16_t *colours = is_in_place ? pixels : words + ((uintptr_t)pixels >> 1 & 1u);
        const uint32_t count = (uint32_t)(end - x0);
        if (begins_beneath) {
            leave_out(0, sixteenths == 0, x0, pixels, colours, count);
        }
        if (shows_lines) {
            show_texels(paint, row, (uint32_t)x0, (uint32_t)end, colours, false);
        } else {
            const uintptr_t column_0 = (uintptr_t)colours - 2u * (uint32_t)x0;
            fxl_paint_row drawn = *row;
            drawn.pixels = (uint8_t *)column_0;
            paint_opaque(paint, &drawn, x0, end);
        }
        if (shows_lines && is_stippled) {
            leave_out(drawn_of_four(paint, row->y), sixteenths == 0, x0, pixels, colours, count);
        }
        if (!is_in_place) {
            mix_row(sixteenths, colours, pixels, count);
        }
        x0 = end;
    }
}

void fxl_paint_pixels_565(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT
    if (fxl_has_texel_runs(paint)) {
        paint_texels(paint, row, x0, x1);
        return;
    }
#else
    if (fxl_is_mixed_565(paint) && has_plain_lines(paint)) {
        paint_mixed_lines(paint, row, x0, x1);
        return;
    }
#endif
    if (fxl_is_mixed_565(paint) ||
        (row->segments == NULL && has_holes(paint) && has_lines(paint))) {
        paint_mixed(paint, row, x0, x1);
    } else {
        paint_opaque(paint, row, x0, x1);
    }
}
