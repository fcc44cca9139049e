/* SPDX-License-Identifier: MIT */
/* The pixels of a face with colours at its corners. A run of them is linear. Its channels have 11
 * bits after the point, rounded down at a column that is the same for all runs of a row: so a pixel
 * depends on the face and its place alone. */
#include "../raster/fill.h"
#include "colour_run.h"
#include "corner_colours.h"
#include "rgb565_colour.h"
#include "texel_place.h"

#define FRACTION 11u
#define SEGMENT  16

/* The channels of the first pixel, and what a pixel adds. */
typedef struct {
    int32_t channels[3], steps[3];
} colour_run;

/* A channel of the run from `skipped` columns after one whose word is given. Words have drop bits
 * more after the point than channels, which round to nearest; sums are modulo 2^32, and of a pixel
 * of the face the result is within its bits. */
/* SPEC 9.8 */
static inline void begin_channel(colour_run *run, uint32_t k, uint32_t word, uint32_t step,
                                 uint32_t drop, uint32_t skipped)
{
    const uint32_t of_step = (uint32_t)((int32_t)step >> drop) + (step >> (drop - 1u) & 1u);
    const uint32_t channel = (word >> drop) + (word >> (drop - 1u) & 1u) + skipped * of_step;
    run->channels[k] = (int32_t)(channel << drop) >> drop;
    run->steps[k] = (int32_t)of_step;
}

/* Whether the first and the last pixel are within what a pixel shows; then all are. Steps are below
 * 2^27, and a run of such steps has one pixel. */
static inline bool is_within(const colour_run *run, int32_t count)
{
    uint32_t ends[3];
    for (uint32_t k = 0; k < 3; k++) {
        const uint32_t first = (uint32_t)run->channels[k];
        ends[k] = first | (first + (uint32_t)(count - 1) * (uint32_t)run->steps[k]);
    }
    return ((ends[0] | ends[2] | ends[1] >> 1) >> (FRACTION + 5)) == 0;
}

/* rgb565 2.4 */
static inline uint32_t hold(int32_t channel, int32_t most)
{
    return (uint32_t)(channel < 0 ? 0 : channel > most ? most : channel) >> FRACTION;
}

/* place stipple: what a pixel does of a face with colours at its corners */
/* The colour of any channels with FRACTION bits. Not inline: few faces have
 * such pixels, and it takes many bytes. */
/* rgb565 2.4 */
static __attribute__((noinline)) void show(const fxl_paint *paint, const fxl_paint_row *row,
                                           int32_t x, const int32_t channels[3])
{
    uint16_t *pixel = (uint16_t *)(void *)row->pixels + x;
    if (fxl_is_stippled_away(paint->opacity, x, row->y)) {
        return;
    }
    *pixel = (uint16_t)(hold(channels[0], (32 << FRACTION) - 1) << 11 |
                        hold(channels[1], (64 << FRACTION) - 1) << 5 |
                        hold(channels[2], (32 << FRACTION) - 1));
}

/* A pixel that is divided by itself: its channels in 16.16. */
static inline void paint_pixel(const fxl_paint *paint, const fxl_paint_row *row, int32_t x,
                               const int32_t values[FXL_ATTRIBUTES])
{
    const int32_t channels[3] = {values[0] >> (16u - FRACTION), values[1] >> (16u - FRACTION),
                                 values[2] >> (16u - FRACTION)};
    show(paint, row, x, channels);
}

#include "paint_row.h"

static inline fxl_colour_words words_of(const colour_run *run)
{
    const unsigned up = 32u - FRACTION - 6u;
    const fxl_colour_words words = {((uint32_t)run->channels[2] << 16) + (uint32_t)run->channels[0],
                                    (uint32_t)run->channels[1] << up,
                                    ((uint32_t)run->steps[2] << 16) + (uint32_t)run->steps[0],
                                    (uint32_t)run->steps[1] << up};
    return words;
}

static void paint_run(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1,
                      const colour_run *run)
{
    uint16_t *pixels = (uint16_t *)(void *)row->pixels;
    if (paint->opacity == 16 && is_within(run, x1 - x0)) {
        const fxl_colour_words words = words_of(run);
        fxl_paint_colour_run(&words, pixels + x0, (uint32_t)(x1 - x0));
        return;
    }
    colour_run next = *run;
    for (int32_t x = x0; x < x1; x++) {
        show(paint, row, x, next.channels);
        for (uint32_t k = 0; k < 3; k++) {
            next.channels[k] = (int32_t)((uint32_t)next.channels[k] + (uint32_t)next.steps[k]);
        }
    }
}

/* Segments begin at columns that are multiples of 4, 8 or 16. */
static void paint_linear(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1,
                         const linear_pixels *of)
{
    const uint32_t skipped = (uint32_t)x0 & (SEGMENT - 1u);
    colour_run run;
    for (uint32_t k = 0; k < 3; k++) {
        begin_channel(&run, k, of->values[k] - skipped * of->steps[k], of->steps[k], 16u - FRACTION,
                      skipped);
    }
    paint_run(paint, row, x0, x1, &run);
}

/* --- words ---------------------------------------------------------------------------------- */

/* The channels of a face in words in one row, at its column, and what a row adds. */
typedef struct {
    uint32_t red, green, blue;
} word_row;

static inline uint32_t upper(int64_t words)
{
    return (uint32_t)((uint64_t)words >> 32);
}

static inline word_row down_of(const fxl_gradient *attributes)
{
    const word_row down = {(uint32_t)attributes[0].down, upper(attributes[0].down),
                           (uint32_t)attributes[1].down};
    return down;
}

static inline word_row row_of(const fxl_gradient *attributes, int32_t y)
{
    const word_row down = down_of(attributes);
    const word_row row = {(uint32_t)attributes[0].at + (uint32_t)y * down.red,
                          (uint32_t)attributes[1].at + (uint32_t)y * down.green,
                          upper(attributes[1].at) + (uint32_t)y * down.blue};
    return row;
}

/* How far a run may be from the column whose words it begins with: red and blue are off by less
 * than 1/4096 level a column, and 1/2048, so by less than 1/31. Beyond 0 and 32 they would mix; at
 * the corners they are 1/16 away from these. */
#define RUN_MAX 128

static inline void find_word_steps(const fxl_gradient *attributes, fxl_colour_words *words)
{
    words->step = (uint32_t)attributes[0].along;
    words->green_step = upper(attributes[0].along);
}

/* The words of a column that is so far from the face's. is_near: it is known to be within RUN_MAX.
 * Returns how far the first column is that begins with others. */
static inline int32_t words_at(const fxl_gradient *attributes, const word_row *row,
                               int32_t distance, bool is_near, fxl_colour_words *words)
{
    uint32_t red = row->red, blue = row->blue;
    int32_t begin = 0, end = RUN_MAX + 1;
    if (!is_near && (distance < -RUN_MAX || distance > RUN_MAX)) {
        const bool is_left = distance < 0;
        const int32_t size = ((is_left ? -distance : distance) - 1) & -RUN_MAX;
        begin = is_left ? -size : size;
        end = is_left ? begin : begin + RUN_MAX + 1;
        red += (uint32_t)begin * (uint32_t)attributes[1].along;
        blue += (uint32_t)begin * upper(attributes[1].along);
    }
    words->both =
        fxl_colours_both((int32_t)red, (int32_t)blue) + (uint32_t)(distance - begin) * words->step;
    words->green = (row->green << 4) + (uint32_t)distance * words->green_step;
    return end;
}

/* A part of a row. */
static __attribute__((noinline)) void paint_words(const fxl_paint *paint, const fxl_paint_row *row,
                                                  int32_t x0, int32_t x1)
{
    const fxl_gradient *attributes = paint->gradients->attributes;
    const word_row at = row_of(attributes, row->y);
    const int32_t column = (int32_t)upper(attributes[0].at);
    fxl_colour_words words;
    find_word_steps(attributes, &words);
    if (paint->opacity == 16) {
        uint16_t *pixels = (uint16_t *)(void *)row->pixels;
        do {
            const int32_t next = words_at(attributes, &at, x0 - column, false, &words);
            const int32_t end = smaller(next + column, x1);
            fxl_paint_colour_run(&words, pixels + x0, (uint32_t)(end - x0));
            x0 = end;
        } while (x0 < x1);
        return;
    }
    while (x0 < x1) {
        const int32_t next = words_at(attributes, &at, x0 - column, false, &words);
        for (const int32_t end = smaller(next + column, x1); x0 < end; x0++) {
            const int32_t channels[3] = {(int32_t)(words.both & 0xFFFFu),
                                         (int32_t)(words.green >> (32u - 6u - FRACTION)),
                                         (int32_t)(words.both >> 16)};
            show(paint, row, x0, channels);
            words.both += words.step;
            words.green += words.green_step;
        }
    }
}

bool fxl_paint_colour_polygon(const fxl_paint *paint, const fxl_screen_point *points,
                              uint32_t count, const fxl_band *band, fxl_scan *scan)
{
    const fxl_gradient *attributes = paint->gradients->attributes;
    const fxl_trapezoid *trapezoid;
    fxl_colour_words words;
    fxl_paint_row far; /* what paint_words reads of it */
    if (!fxl_has_colour_words(paint->gradients) || paint->opacity < 16 || fxl_is_mixed_565(paint)) {
        return false;
    }
    const int32_t column = (int32_t)upper(attributes[0].at);
    bool is_near = true; /* places are below 2^27: on the screen, or beside it */
    for (uint32_t i = 0; i < count; i++) {
        const int32_t distance = (points[i].x >> 16) - column;
        is_near = is_near && distance >= -RUN_MAX && distance <= RUN_MAX;
    }
    const word_row down = down_of(attributes);
    find_word_steps(attributes, &words);
    fxl_scan_outline(points, count, band, scan);
    while ((trapezoid = fxl_scan_next_trapezoid(scan)) != NULL) {
        fxl_edge a = trapezoid->edges[0], b = trapezoid->edges[1];
        int32_t y = trapezoid->first_row;
        word_row row = row_of(attributes, y);
        uint16_t *pixels =
            (uint16_t *)(void *)band->pixels + (size_t)(y - band->first_row) * band->stride;
        for (; y < trapezoid->end_row; y++) {
            const int32_t x0 = a.x <= b.x ? a.x : b.x, x1 = a.x <= b.x ? b.x : a.x;
            if (x0 < x1 && is_near) {
                (void)words_at(attributes, &row, x0 - column, true, &words);
                fxl_paint_colour_run(&words, pixels + x0, (uint32_t)(x1 - x0));
            } else if (x0 < x1) {
                far.pixels = (uint8_t *)(void *)pixels;
                far.y = y;
                paint_words(paint, &far, x0, x1);
            }
            fxl_edge_step(&a);
            fxl_edge_step(&b);
            pixels += band->stride;
            row.red += down.red;
            row.green += down.green;
            row.blue += down.blue;
        }
    }
    return true;
}

void fxl_paint_colours_565(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    const fxl_gradients *gradients = paint->gradients;
    divided_column at;
    uint32_t least[3];
    if (fxl_has_colour_words(gradients)) {
        paint_words(paint, row, x0, x1);
        return;
    }
    at.column = -1;
    fxl_find_least_weights(gradients, paint->division, least);
    while (x0 < x1) {
        const int32_t end = smaller((x0 & ~15) + 16, x1);
        paint_sixteen(paint, row, least, x0, end, &at);
        x0 = end;
    }
}
