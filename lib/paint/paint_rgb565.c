/* SPDX-License-Identifier: MIT */
#include "corner_colours.h"
#include "light_row.h"
#include "texel_place.h"
#include "texture_level.h"
#include "rgb565_colour.h"

/* place sampling: the loops; paint_repeated is that for textures that repeat */
/* place pixel-format: fxl_paint_565 and fxl_paint_pixels_565: the pixels of a surface */
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
/* A pixel whose attributes are known. */
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
    if (of->sixteenths != 0) {
        colour = fxl_blend_565(colour, *pixel, of->sixteenths);
    } else if (of->adds) {
        colour = fxl_add_565(colour, *pixel);
    }
    *pixel = colour;
}

#include "paint_row.h"

/* Opaque texels of 16 bits, repeated and without a key: paint_pixel's colours. The compiler cannot
 * tell pixels from what the loop reads, so it has copies. */
static inline void paint_repeated(const fxl_paint *paint, const linear_pixels *linear,
                                  uint16_t *pixel, const uint16_t *end, bool lit)
{
    const fxl_paint copy = *paint;
    const fxl_texture_level *level = &paint->level;
    const uint16_t *texels = (const uint16_t *)(const void *)level->texels;
    const uint32_t columns = level->columns_less_1, rows = level->rows_less_1 << level->log_width;
    const uint32_t row_drop = 16u - level->log_width; /* log_width is at most 8 */
    uint32_t u = linear->values[FXL_ATTRIBUTE_U], v = linear->values[FXL_ATTRIBUTE_V];
    uint32_t light = linear->values[FXL_ATTRIBUTES - 1]; /* light follows u and v, or is none */
    if (paint->is_evenly_lit) {
        light = (uint32_t)paint->light << 8;
    }
    const uint32_t u_step = linear->steps[FXL_ATTRIBUTE_U];
    const uint32_t v_step = linear->steps[FXL_ATTRIBUTE_V];
    const uint32_t light_step = linear->steps[FXL_ATTRIBUTES - 1];
    for (; pixel != end; pixel++) {
        const uint16_t colour = texels[(v >> row_drop & rows) + (u >> 16 & columns)];
        *pixel = lit ? fxl_mix_565(colour, copy.of_565.dark, part_of_light(&copy, (int32_t)light))
                     : colour;
        u += u_step;
        v += v_step;
        light += light_step;
    }
}

/* Of 256 parts, those that light in 8.24 leaves, rounded down; light has half a part more:
 * fxl_half_part_565. That is at most 63 2^24 + 63 2^15, so its upper half is below 2^14; a part of
 * a level is at most 2^16. */
static inline uint32_t part_of(uint32_t light, uint32_t part_of_level)
{
    return ((light >> 16) * part_of_level + ((light & 0xFFFFu) * part_of_level >> 16)) >> 16;
}

/* Opaque pixels of one colour, lit: those of fxl_mix_565. light: as of part_of. */
static inline __attribute__((always_inline)) void
paint_lit_colour(const fxl_paint_565 *of, uint32_t colour, uint32_t most, bool is_within,
                 uint32_t light, uint32_t step, uint16_t *pixel, const uint16_t *end)
{
    const uint32_t part_of_level = of->part_of_level;
    const fxl_mixture_565 mixture = fxl_mixture_of_565(colour, of->dark);
    for (; pixel != end; light += step) {
        uint32_t held = light;
        if (!is_within) {
            held = (int32_t)light < 0 ? 0 : light > most ? most : light;
        }
        const uint32_t part = part_of(held, part_of_level);
        const uint32_t red = mixture.red_dark + mixture.red_step * part;
        const uint32_t green = mixture.green_dark + mixture.green_step * part;
        *pixel++ = (uint16_t)((red >> 16 & FXL_RED_565) | (green >> 8 & FXL_GREEN_565) |
                              (red >> 8 & FXL_BLUE_565));
    }
}

static void paint_lights(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1,
                         const fxl_light_run *run)
{
    const fxl_paint_565 *of = &paint->of_565;
    const uint32_t half = 1u << 23, range = (uint32_t)paint->levels_less_1 << 24;
    const uint32_t half_part = fxl_half_part_565(paint->levels_less_1), most = range + half_part;
    const uint32_t colour = of->palette[paint->colour], light = run->light - half + half_part;
    uint16_t *pixels = (uint16_t *)(void *)row->pixels;
    if (!FXL_IS_COMPACT && fxl_light_run_is_within(run, x1 - x0, half, range + 1u)) {
        paint_lit_colour(of, colour, most, true, light, run->step, pixels + x0, pixels + x1);
    } else {
        paint_lit_colour(of, colour, most, false, light, run->step, pixels + x0, pixels + x1);
    }
}

/* Pixels that show texels, in light that is the same everywhere: as above, of many colours. */
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
    const fxl_paint_565 *of = &paint->of_565;
    if (paint->has_light_rows) {
        const fxl_light_run run = {linear->values[0] << 8, linear->steps[0] << 8};
        paint_lights(paint, row, x0, x1, &run);
        return;
    }
    if (FXL_IS_COMPACT || paint->opacity < 16 || of->sixteenths != 0 || of->adds ||
        paint->level.flags != FXL_LEVEL_565) {
        paint_each_linear(paint, row, x0, x1, linear);
        return;
    }
    uint16_t *pixels = (uint16_t *)(void *)row->pixels;
    if (of->part_of_level != 0) {
        paint_repeated(paint, linear, pixels + x0, pixels + x1, true);
    } else {
        paint_repeated(paint, linear, pixels + x0, pixels + x1, false);
    }
}

void fxl_paint_pixels_565(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    divided_column at;
    uint32_t least[3];
    least[0] = 0; /* not found yet */
    at.column = -1;
    if (paint->is_light_linear) {
        if (paint->has_colours) {
            fxl_paint_colours_565(paint, row, x0, x1);
            return;
        }
        const fxl_light_run run = fxl_light_run_of(paint, row->y, x0);
        paint_lights(paint, row, x0, x1, &run);
        return;
    }
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
}
