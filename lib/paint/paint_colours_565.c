/* SPDX-License-Identifier: MIT */
/* The pixels of a face with colours at its corners. A run of them is linear. Its channels have 11
 * bits after the point, rounded down at a column that is the same for all runs of a row: so a pixel
 * depends on the face and its place alone. */
#include "../raster/fill.h"
#include "colour_run.h"
#include "corner_colours.h"
#include "depth_rows.h"
#include "paint_polygon.h"
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
    const uint32_t more = (uint32_t)(count - 1);
    const uint32_t red = (uint32_t)run->channels[0], green = (uint32_t)run->channels[1];
    const uint32_t blue = (uint32_t)run->channels[2];
    const uint32_t red_and_blue = red | blue | (red + more * (uint32_t)run->steps[0]) |
                                  (blue + more * (uint32_t)run->steps[2]);
    const uint32_t of_green = green | (green + more * (uint32_t)run->steps[1]);
    return ((red_and_blue | of_green >> 1) >> (FRACTION + 5)) == 0;
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

/* --- in perspective --------------------------------------------------------------------------- */

/* A channel of a face in perspective: fxl_attribute_of. */
static inline int32_t channel_at(const fxl_paint *paint, const fxl_paint_row *row, uint32_t column,
                                 uint32_t k)
{
    return upper_32(sum_64(row->attributes[k],
                           fxl_multiply_s64_u16(paint->gradients->attributes[k].along, column)));
}

/* divide_at of three channels, of a column below 2^16. Mostly products drop
 * less than 32 bits of their upper words. */
static __attribute__((noinline)) void divide_channels(const fxl_paint *paint,
                                                      const fxl_paint_row *row, uint32_t column,
                                                      int32_t channels[3])
{
    const uint32_t weight = weight_after(paint, row, column);
    const int8_t *shifts = paint->gradients->shifts;
    const fxl_reciprocal reciprocal = fxl_reciprocal_of(weight);
    const int32_t most = 30 - (int32_t)reciprocal.zeros;
    const int32_t drops[3] = {most - shifts[0], most - shifts[1], most - shifts[2]};
    if (fxl_bits_32(drops[0] | drops[1] | drops[2]) < 32u) {
        const int32_t factor = reciprocal.value;
        channels[0] =
            upper_32(fxl_multiply_s32(channel_at(paint, row, column, 0), factor)) >> drops[0];
        channels[1] =
            upper_32(fxl_multiply_s32(channel_at(paint, row, column, 1), factor)) >> drops[1];
        channels[2] =
            upper_32(fxl_multiply_s32(channel_at(paint, row, column, 2), factor)) >> drops[2];
        return;
    }
    fxl_divide_row_at(paint, row, (int32_t)column, channels);
}

/* One segment of 2^log columns from `begin` on, whose channels are given at both ends. */
static __attribute__((noinline)) void paint_between(const fxl_paint *paint,
                                                    const fxl_paint_row *row, int32_t begin,
                                                    uint32_t log, const int32_t from[3],
                                                    const int32_t to[3], int32_t x0, int32_t x1)
{
    const uint32_t before = (uint32_t)begin & (SEGMENT - 1u),
                   skipped = (uint32_t)x0 & (SEGMENT - 1u);
    const uint32_t steps[3] = {(uint32_t)((int32_t)((uint32_t)to[0] - (uint32_t)from[0]) >> log),
                               (uint32_t)((int32_t)((uint32_t)to[1] - (uint32_t)from[1]) >> log),
                               (uint32_t)((int32_t)((uint32_t)to[2] - (uint32_t)from[2]) >> log)};
    colour_run run;
    begin_channel(&run, 0, (uint32_t)from[0] - before * steps[0], steps[0], 16u - FRACTION,
                  skipped);
    begin_channel(&run, 1, (uint32_t)from[1] - before * steps[1], steps[1], 16u - FRACTION,
                  skipped);
    begin_channel(&run, 2, (uint32_t)from[2] - before * steps[2], steps[2], 16u - FRACTION,
                  skipped);
    paint_run(paint, row, x0, x1, &run);
}

/* The pixels x0 <= x < x1, in segments: those of paint_sixteen. least: of fxl_find_least_weights. */
static void paint_divided(const fxl_paint *paint, const fxl_paint_row *row, const uint32_t least[3],
                          int32_t x0, int32_t x1)
{
    int32_t ends[2][3], column = -1; /* that ends[at] is of */
    uint32_t at = 0;
    while (x0 < x1) {
        const int32_t first = x0 & -SEGMENT, end = smaller(first + SEGMENT, x1);
        const uint32_t log = fxl_segment_log(least, weight_after(paint, row, (uint32_t)first),
                                             weight_after(paint, row, (uint32_t)first + SEGMENT));
        if (log == 0) {
            divide_each(paint, row, x0, end);
            x0 = end;
        }
        while (x0 < end) {
            const int32_t begin = x0 & -(1 << log), next = begin + (1 << log);
            const int32_t until = smaller(next, x1);
            if (column != begin) {
                divide_channels(paint, row, (uint32_t)begin, ends[at]);
            }
            divide_channels(paint, row, (uint32_t)next, ends[at ^ 1u]);
            paint_between(paint, row, begin, log, ends[at], ends[at ^ 1u], x0, until);
            at ^= 1u;
            column = next;
            x0 = until;
        }
    }
}

void fxl_paint_colours_565(const fxl_paint *paint, const fxl_paint_row *row, int32_t x0, int32_t x1)
{
    uint32_t least[3];
    if (fxl_has_colour_words(paint->gradients)) {
        paint_words(paint, row, x0, x1);
        return;
    }
    fxl_find_least_weights(paint->gradients, paint->division, least);
    paint_divided(paint, row, least, x0, x1);
}

#if FXL_HAS_DEPTH_ROWS

void fxl_paint_colour_runs(const fxl_paint *paint, fxl_plain_runs *runs)
{
    int32_t x0, x1;
    uint32_t least[3];
    fxl_find_least_weights(paint->gradients, paint->division, least);
    for (; runs->next != runs->end; runs->next++) {
        if (fxl_take_run(paint->gradients, runs, true, &x0, &x1)) {
            paint_divided(paint, &runs->row, least, x0, x1);
        }
    }
}

#endif
