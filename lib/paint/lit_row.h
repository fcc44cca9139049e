/* SPDX-License-Identifier: MIT */
/* Lit pixels of RGB565 whose light is an attribute: those of one colour, and on Armv7-M runs of
 * texels. A part of paint_rgb565.c, which defines paint_pixel before it. Internal. */
#ifndef FXL_LIT_ROW_H
#define FXL_LIT_ROW_H

#include "colour_run.h"
#include "light_row.h"
#include "paint_polygon.h"
#include "paint_row.h"
#include "rgb565_colour.h"

/* place light: RGB565: lit pixels of one colour, and runs of lit texels */
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

#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT

/* What the runs of a face share. */
typedef struct {
    fxl_lit_run run;
    uint32_t least[3];
    uint32_t log_of_steps;
    bool is_lit;
} lit_face;

static void paint_mixed(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1);
static fxl_columns_kernel paint_blended_columns;

/* What segments of 2^log columns add. */
static inline void find_steps(const fxl_gradients *gradients, uint32_t log, lit_face *face)
{
    int64_t *steps = face->run.steps;
    steps[0] = shifted_left(gradients->weight.along, log);
    for (uint32_t i = 0; i < FXL_ATTRIBUTES && i < gradients->count; i++) {
        steps[1 + i] = shifted_left(gradients->attributes[i].along, log);
    }
    face->log_of_steps = log;
}

/* place sampling: the kernel's masks */
static inline void set_lit_face(const fxl_paint *paint, lit_face *face)
{
    fxl_lit_run *run = &face->run;
    const fxl_texture_level *level = &paint->level;
    for (uint32_t i = 0; i < FXL_ATTRIBUTES && i < paint->gradients->count; i++) {
        run->lefts[i] = 30 - paint->gradients->shifts[i];
    }
    run->log = 0;
    run->begin = 0;
    run->end_of_light = ((uint32_t)paint->levels_less_1 << 16) + 1u;
    run->columns_mask = level->columns_less_1;
    run->rows_mask = level->rows_less_1 << level->log_width;
    run->log_width = level->log_width;
    run->texels = level->texels;
    run->palette = level->flags & FXL_LEVEL_565 ? NULL : paint->of_565.palette;
    run->part_of_level = paint->of_565.part_of_level;
    run->mixture = fxl_mixture_of_565(0, paint->of_565.dark);
    fxl_find_least_weights(paint->gradients, paint->division, face->least);
    run->least = face->least[0];
    face->is_lit = run->part_of_level != 0;
    run->sixteenths = paint->of_565.sixteenths;
/* place stipple: a blend: which kernel of runs mixes it, and what is added */
    run->lowest = paint->of_565.adds ? FXL_LOWEST_565 : 0;
    run->paint = face->is_lit           ? fxl_paint_lit_columns
                 : run->sixteenths != 0 ? paint_blended_columns
                                        : fxl_paint_unlit_columns;
    find_steps(paint->gradients, 4, face);
}

/* A number of the row at column `begin`, less a step. */
static inline int64_t number_before(int64_t first, const fxl_gradient *gradient, int32_t begin,
                                    int64_t step)
{
    const int64_t there = sum_64(first, fxl_multiply_s64_u16(gradient->along, (uint32_t)begin));
    return fxl_signed_64(fxl_bits_64(there) - fxl_bits_64(step));
}

/* Segments of 2^log columns, from that of x0 on. The numbers are those of the segment before it. */
static inline void begin_lit_run(const fxl_paint *paint, const fxl_paint_row *row, uint32_t log,
                                 int32_t x0, lit_face *face)
{
    const fxl_gradients *gradients = paint->gradients;
    const fxl_gradient *of = gradients->attributes;
    const int32_t begin = x0 >> log << log;
    fxl_lit_run *run = &face->run;
    if (log != face->log_of_steps) {
        find_steps(gradients, log, face);
    }
    run->numbers[0] = number_before(row->weight, &gradients->weight, begin, run->steps[0]);
    run->numbers[1] = number_before(row->attributes[0], &of[0], begin, run->steps[1]);
    run->numbers[2] = number_before(row->attributes[1], &of[1], begin, run->steps[2]);
    if (face->is_lit) {
        run->numbers[3] = number_before(row->attributes[2], &of[2], begin, run->steps[3]);
    }
    run->log = log;
    run->begin = begin - (1 << log);
}

/* All of a run, by the kernel but for segments that it does not paint. */
/* surfaces 2.2 */
static inline void paint_lit_run(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0,
                                 int32_t x1, lit_face *face)
{
    const uint32_t *least = face->least;
    fxl_lit_run *run = &face->run;
    divided_column at;
    at.column = -1;
    run->log = 0;
    while (x0 < x1) {
        const uint32_t first = (uint32_t)x0 & ~15u;
        const uint32_t log = fxl_segment_log(least, weight_after(paint, row, first),
                                             weight_after(paint, row, first + 16u));
        int32_t end = smaller((int32_t)first + 16, x1);
        if (log == 4 && weight_after(paint, row, ((uint32_t)x1 + 15u) & ~15u) >= least[0]) {
            end = x1; /* the weight is linear */
        }
        if (log != 0) {
            if (log != run->log || x0 != run->begin) {
                begin_lit_run(paint, row, log, x0, face);
            }
            x0 = run->paint(run, (uint16_t *)(void *)row->pixels, x0, end);
        }
        if (x0 < end) {
            end = smaller((x0 & ~15) + 16, end);
            if (face->is_lit) {
                paint_sixteen(paint, row, least, x0, end, &at);
            } else {
                paint_mixed(paint, row, x0, end);
            }
            run->log = 0;
            x0 = end;
        }
    }
}

void fxl_paint_texel_runs(const fxl_paint *paint, fxl_plain_runs *runs)
{
    lit_face face;
    int32_t x0;
    set_lit_face(paint, &face);
    while ((x0 = fxl_paint_texel_list(&face.run, runs)) >= 0) {
        const int32_t x1 = (int32_t)((runs->next[-1] & ~FXL_RUN_BELOW) >> 16);
        paint_lit_run(paint, &runs->row, x0, x1, &face);
        if (face.log_of_steps != 4) {
            find_steps(paint->gradients, 4, &face);
        }
    }
}

/* One run. Not inline: its list would be on the stack of others. */
static __attribute__((noinline)) void paint_texels(const fxl_paint *paint, const fxl_paint_row *row,
                                                   int32_t x0, int32_t x1)
{
    const uint32_t run = (uint32_t)x0 | (uint32_t)x1 << 16;
    fxl_plain_runs runs;
    runs.row = *row;
    runs.next = &run;
    runs.end = &run + 1;
    fxl_paint_texel_runs(paint, &runs);
}

#endif

#endif
