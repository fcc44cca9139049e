/* SPDX-License-Identifier: MIT */
#include "light_row.h"
#include "paint_divided.h"
#include "segments.h"
#include "texel_place.h"

/* --- pixels --------------------------------------------------------------------------------- */

/* What a beam and what is beneath make of a colour. */
/* SPEC 9.6, surfaces 4.3 */
static inline uint8_t replaced(const fxl_paint *paint, uint8_t colour, uint8_t beneath)
{
    colour = paint->in_beam != NULL ? paint->in_beam[colour] : colour;
    if (paint->blend == NULL) {
        return colour;
    }
    const uint32_t number = (uint8_t)(colour - paint->blend_first);
    return number < paint->blend_count ? paint->blend[256u * number + beneath] : colour;
}

/* place stipple: what a pixel does, in a palette */
/* place sampling: the loops; paint_repeated is that for textures that repeat */
/* A pixel whose attributes are known. */
/* SPEC 9.6, beams 6.4 */
static inline void paint_pixel(const fxl_paint *paint, const fxl_paint_row *row, int32_t x,
                               const int32_t values[FXL_ATTRIBUTES])
{
    uint8_t colour = paint->colour;
    if (fxl_is_stippled_away(paint->opacity, x, row->y)) {
        return;
    }
    if (paint->level.texels != NULL) {
        const uint32_t place = fxl_texel_place(&paint->level, values[FXL_ATTRIBUTE_U] >> 16,
                                               values[FXL_ATTRIBUTE_V] >> 16);
        colour = fxl_texel_index(&paint->level, place);
        if ((paint->level.flags & FXL_TEXTURE_KEYED) && colour == paint->level.key) {
            return;
        }
        colour = paint->table != NULL ? paint->table[colour] : colour;
    }
    if (paint->ramp != NULL) {
        const int32_t light = values[paint->gradients->count - 1];
        const uint32_t level = fxl_limited(light >> 16, paint->levels_less_1);
        colour = paint->ramp[256u * level + colour];
    }
    row->pixels[x] = paint->is_replaced ? replaced(paint, colour, row->pixels[x]) : colour;
}

#include "paint_row.h"

/* --- neighbouring pixels -------------------------------------------------------------------- */

/* Texels of 8 bits, repeated, in no beam: with or without a key, a table, light, or without light a
 * blend. Any pixel may be a byte of the tables to the compiler, so the loop has copies of all that
 * it needs. */
/* SPEC 9.6, surfaces 4.3 */
static inline __attribute__((always_inline)) void paint_repeated(const fxl_paint *paint,
                                                                 const linear_pixels *of,
                                                                 uint8_t *pixel, const uint8_t *end,
                                                                 bool lit, bool blends)
{
    const uint8_t *blend = paint->blend;
    const uint32_t blend_first = paint->blend_first, blend_count = paint->blend_count;
    const fxl_texture_level *level = &paint->level;
    const uint8_t *texels = level->texels, *ramp = paint->ramp, *table = paint->table;
    const uint32_t key = level->flags & FXL_TEXTURE_KEYED ? level->key : 256u;
    const uint32_t columns = level->columns_less_1, rows = level->rows_less_1 << level->log_width;
    const uint32_t row_drop = 16u - level->log_width; /* log_width is at most 8 */
    const uint32_t last_level = paint->levels_less_1;
    uint32_t u = of->values[FXL_ATTRIBUTE_U], v = of->values[FXL_ATTRIBUTE_V];
    uint32_t light = of->values[FXL_SEGMENT_LIGHT];
    const uint32_t u_step = of->steps[FXL_ATTRIBUTE_U], v_step = of->steps[FXL_ATTRIBUTE_V];
    const uint32_t light_step = of->steps[FXL_SEGMENT_LIGHT];
    for (; pixel != end; pixel++) {
        uint32_t colour = texels[(v >> row_drop & rows) + (u >> 16 & columns)];
        if (colour != key) {
            if (table != NULL) {
                colour = table[colour];
            }
            if (lit) {
                colour = ramp[256u * fxl_limited((int32_t)light >> 16, last_level) + colour];
            }
            const uint32_t number = (uint8_t)(colour - blend_first);
            if (blends && number < blend_count) {
                colour = blend[256u * number + *pixel];
            }
            *pixel = (uint8_t)colour;
        }
        u += u_step;
        v += v_step;
        light += light_step;
    }
}

/* Opaque pixels of the face's colour, lit. Both loops read the ramp only within its levels. */
/* surfaces 5.2 */
static void paint_lights(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1,
                         const fxl_light_run *run)
{
    const uint8_t *ramp = paint->ramp + paint->colour;
    const uint32_t last_level = paint->levels_less_1, step = run->step;
    uint8_t *pixel = row->pixels + x0;
    const uint8_t *end = row->pixels + x1;
    uint32_t light = run->light;
    if (!FXL_IS_COMPACT && fxl_light_run_is_within(run, x1 - x0, 0, (last_level + 1u) << 24)) {
        for (; pixel != end; light += step) {
            *pixel++ = ramp[256u * (light >> 24)];
        }
    } else {
        for (; pixel != end; light += step) {
            *pixel++ = ramp[256u * fxl_limited((int32_t)light >> 24, last_level)];
        }
    }
}

static void paint_linear(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1,
                         const linear_pixels *of)
{
    uint8_t *pixel = row->pixels + x0;
    const uint8_t *end = row->pixels + x1;
    if (paint->has_light_rows) {
        const fxl_light_run run = {of->values[0] << 8, of->steps[0] << 8};
        paint_lights(paint, row, x0, x1, &run);
        return;
    }
    if (!FXL_IS_COMPACT && paint->opacity == 16 && paint->in_beam == NULL &&
        paint->level.texels != NULL && paint->level.colours == NULL &&
        (paint->level.flags & FXL_TEXTURE_CLAMP) == 0 &&
        (paint->ramp == NULL || paint->blend == NULL)) {
        if (paint->ramp != NULL) {
            paint_repeated(paint, of, pixel, end, true, false);
        } else if (paint->blend != NULL) {
            paint_repeated(paint, of, pixel, end, false, true);
        } else {
            paint_repeated(paint, of, pixel, end, false, false);
        }
        return;
    }
    paint_each_linear(paint, row, x0, x1, of);
}

/* --- the kernel ----------------------------------------------------------------------------- */

/* Pixels that the kernel has painted, in a beam. */
/* beams 6.2, 6.3 */
static void put_in_beam(const uint8_t *in_beam, uint8_t *pixel, const uint8_t *end)
{
    for (; pixel != end; pixel++) {
        *pixel = in_beam[*pixel];
    }
}

/* --- pixels that are each divided ----------------------------------------------------------- */

/* The attributes of a pixel. The numbers of 64 bits are shifted before they are cut to a word, so a
 * small weight, far from the eye, keeps as many bits as a large one. */
static void divide_alone(const fxl_paint *paint, const fxl_paint_row *row, int32_t x,
                         int32_t values[FXL_ATTRIBUTES])
{
    const fxl_gradients *gradients = paint->gradients;
    const int64_t weight = row->weight + gradients->weight.along * x;
    const unsigned zeros =
        fxl_leading_zeros(fxl_row_weight_at(paint, row, x)) - 1u; /* of 31 bits */
    const fxl_reciprocal reciprocal = fxl_reciprocal_of(
        weight >> 32 < 1 ? (uint32_t)1 << 30 : (uint32_t)((uint64_t)weight << zeros >> 32));
    for (uint32_t i = 0; i < gradients->count; i++) {
        const int64_t at = row->attributes[i] + gradients->attributes[i].along * x;
        const uint32_t size = (uint32_t)((at ^ at >> 63) >> 32);
        const unsigned spare = size == 0 ? 31u : fxl_leading_zeros(size) - 1u;
        const unsigned shift = spare < zeros ? spare : zeros;
        values[i] = fxl_attribute_of((int32_t)((uint64_t)at << shift >> 32), &reciprocal,
                                     gradients->shifts[i] + (int)(zeros - shift));
    }
}

/* A row of them. What the kernel does not take goes pixel by pixel. Not inline: the kernel's record
 * would stay on the stack of other faces. */
static __attribute__((noinline)) void
paint_divided(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    fxl_divided_face face;
    const bool is_taken = fxl_divided_find(paint, &face);
    while (x0 < x1) {
        x0 = is_taken ? fxl_paint_divided(&face, row, x0, x1) : x0;
        const int32_t end = smaller((x0 & ~15) + 16, x1);
        for (; x0 < end; x0++) {
            int32_t values[FXL_ATTRIBUTES];
            divide_alone(paint, row, x0, values);
            paint_pixel(paint, row, x0, values);
        }
    }
}

void fxl_paint_pixels(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    divided_column at;
    uint32_t least[3];
    at.column = -1;
    if (paint->is_light_linear) {
        const fxl_light_run run = fxl_light_run_of(paint, row->y, x0);
        paint_lights(paint, row, x0, x1, &run);
        return;
    }
    if (paint->division == FXL_DIVIDE_1) {
        paint_divided(paint, row, x0, x1);
        return;
    }
    fxl_find_least_weights(paint->gradients, paint->division, least);
    while (x0 < x1) {
        int32_t end = fxl_segments_end(row, x0, x1);
        if (end > x0) {
            fxl_paint_segments(row->segments, row, x0, end);
            if (paint->in_beam != NULL) {
                put_in_beam(paint->in_beam, row->pixels + x0, row->pixels + end);
            }
        } else {
            end = smaller((x0 & ~15) + 16, x1);
            paint_sixteen(paint, row, least, x0, end, &at);
        }
        x0 = end;
    }
}
