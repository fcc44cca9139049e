/* SPDX-License-Identifier: MIT */
/* The depth of a line from pixel to pixel: its own, or those of the faces on which it lies. A part of
 * line_paint.c. */
#ifndef FXL_LINE_DEPTH_H
#define FXL_LINE_DEPTH_H

#include "../math/arith.h"
#include "../math/pixel_centre.h"
#include "../raster/draw_outline.h"
#include "line_paint.h"

static inline bool fxl_line_holds(const fxl_line_plane *face, uint32_t word)
{
    return word - face->first < face->span;
}

/* The word of a depth: the upper one of this. */
static inline uint64_t fxl_line_worded(const fxl_line_plane *face, int64_t value)
{
    return fxl_depth_is_in_words(&face->plane) ? fxl_bits_64(value) << 32 : fxl_bits_64(value);
}

static inline uint32_t fxl_line_word_of(uint64_t value)
{
    return (uint32_t)(value >> 32);
}

/* The code of column x of a row where the gradient in column 0 is `depth`, in the octave. */
static inline uint32_t fxl_line_code_in_octave(const fxl_depth_octave *octave, int64_t depth,
                                               int32_t x)
{
    return octave->bias + fxl_depth_shifted(depth, octave->drop) + octave->step * (uint32_t)x;
}

/* How the codes of an octave go on from row to row: exact, as no bit below the code's is lost, nor
 * one above it: where they are shifted, mantissas have 12 bits at most, and codes without the bias
 * fewer than 30. */
static inline void fxl_line_find_rows(fxl_line_plane *face)
{
    const fxl_gradient *gradient = &face->plane.gradient;
    const fxl_depth_octave *octave = &face->octave;
    const int32_t up = octave->drop < 32 ? 32 - octave->drop : 0; /* below 64 */
    face->shift = (uint8_t)(octave->drop > 32 ? octave->drop - 32 : 0);
    face->added = face->shift != 0 ? octave->bias : 0;
    face->right = (int32_t)fxl_line_word_of(fxl_line_worded(face, gradient->along));
    face->down = (int32_t)fxl_line_word_of(fxl_line_worded(face, gradient->down));
    face->row = fxl_bits_64(gradient->down) << up;
    face->start =
        (fxl_bits_64(gradient->at) << up) + ((uint64_t)(octave->bias - face->added) << 32);
}

/* The same of a worded value that the octave that was found last does not hold: finds another one. All
 * depths of an upper word are in an octave if its low end, rounded up to 2^32, is not above them, and
 * its high end, rounded down, is. One whose code is constant holds none. */
static __attribute__((noinline)) uint32_t fxl_line_code_in_other(fxl_depth_scale scale,
                                                                 fxl_line_plane *face,
                                                                 int64_t depth, uint64_t value,
                                                                 int32_t x)
{
    fxl_depth_octave *octave = &face->octave;
    if (fxl_depth_is_in_words(&face->plane)) {
        fxl_depth_octave_of_word(scale, &face->plane, fxl_line_word_of(value), octave);
        face->first = (uint32_t)octave->low;
        face->span = (uint32_t)(octave->high - octave->low - 1); /* from 65535 on */
        fxl_line_find_rows(face);
        return fxl_line_code_in_octave(octave, depth, x);
    }
    face->span = 0;
    const uint32_t upper = fxl_line_word_of(value);
    const int32_t length = 64 - (int32_t)fxl_leading_zeros(upper | 1u);
    const uint32_t number = (uint32_t)(face->plane.one - length);
    if (!FXL_IS_COMPACT && length > 33 && length < 64 && number < scale.octaves) {
        octave->drop = length - 17 - scale.mantissa; /* 2..34: as fxl_depth_octave_of finds it */
        octave->bias = ((scale.octaves - 2u - number) << (scale.mantissa + 16)) + 65536u;
        octave->step = fxl_depth_shifted(face->plane.gradient.along, octave->drop);
        octave->is_constant = false;
        face->first = face->span = (uint32_t)1 << (length - 33);
        fxl_line_find_rows(face);
        return fxl_line_code_in_octave(octave, depth, x);
    }
    fxl_depth_octave_of(scale, &face->plane, (int64_t)value, octave);
    if (octave->is_constant) {
        return octave->bias;
    }
    const int32_t low = (int32_t)((octave->low + UINT32_MAX) >> 32);
    const int32_t high = (int32_t)(octave->high >> 32);
    face->first = fxl_bits_32(low);
    face->span = high > low ? fxl_bits_32(high) - fxl_bits_32(low) : 0;
    fxl_line_find_rows(face);
    return fxl_line_code_in_octave(octave, depth, x);
}

/* The code that a face has at the centre of a pixel. */
/* lines 3.2 */
static uint32_t fxl_line_code_of_face(fxl_depth_scale scale, fxl_line_plane *face, int32_t x,
                                      int32_t y)
{
    const fxl_gradient *gradient = &face->plane.gradient;
    const int64_t depth = gradient->at + fxl_multiply_s64_u16(gradient->down, (uint32_t)y);
    const uint64_t value =
        fxl_line_worded(face, depth + fxl_multiply_s64_u16(gradient->along, (uint32_t)x));
    return fxl_line_holds(face, fxl_line_word_of(value))
               ? fxl_line_code_in_octave(&face->octave, depth, x)
               : fxl_line_code_in_other(scale, face, depth, value, x);
}

/* The depth of a line without planes from place to place along its major axis. */
typedef struct {
    int32_t one;       /* as that of a fxl_depth_plane: what depths are counted in */
    int64_t at, step;  /* at the first place, and what a place adds */
    int64_t low, high; /* the depths of the ends */
} fxl_line_depth;

/* lines 3.3 */
static inline uint32_t fxl_line_code_of_depth(fxl_depth_scale scale, const fxl_line_depth *depth)
{
    const int64_t value = depth->at < depth->low    ? depth->low
                          : depth->at > depth->high ? depth->high
                                                    : depth->at;
    const fxl_depth_plane unit = {{0, 0, 0}, depth->one};
    return fxl_depth_code_at(scale, &unit, value, 0);
}

/* near_z / distance as mantissa * 2^-one, off by less than 2^-28 of it, is what the canvas then has.
 * near_z has units of 2^-16 and the distance of 2^-46. */
static void fxl_line_find_end(fxl_line_canvas *canvas, fxl_q18_46 distance)
{
    if (distance != canvas->distance) {
        const fxl_real near_real = fxl_real_of((uint32_t)canvas->near_z, 0);
        const fxl_real divisor = fxl_real_of((uint64_t)distance, 0);
        canvas->distance = distance;
        canvas->one = divisor.exponent - near_real.exponent + 1;
        canvas->mantissa = fxl_mantissa_ratio(&near_real, &divisor);
    }
}

/* mantissa 2^shift, rounded down. A mantissa is below 2^32, and a shift at most 29. */
static int64_t fxl_line_scaled(uint32_t mantissa, int32_t shift)
{
    return shift >= 0 ? (int64_t)((uint64_t)mantissa << shift)
                      : (int64_t)(shift > -32 ? mantissa >> -shift : 0);
}

/* The depths of both ends in one unit, in which the nearer one is below 2^61. */
static void fxl_line_find_ends(fxl_line_canvas *canvas, const fxl_painted_line *line,
                               int64_t ends[2], fxl_line_depth *depth)
{
    fxl_line_find_end(canvas, line->distances[0]);
    const uint32_t first = canvas->mantissa;
    const int32_t first_one = canvas->one;
    fxl_line_find_end(canvas, line->distances[1]);
    const uint32_t second = canvas->mantissa;
    const int32_t second_one = canvas->one;
    const int32_t one = (first_one < second_one ? first_one : second_one) + 29;
    ends[0] = fxl_line_scaled(first, one - first_one);
    ends[1] = fxl_line_scaled(second, one - second_one);
    depth->one = one;
    depth->low = ends[0] < ends[1] ? ends[0] : ends[1];
    depth->high = ends[0] < ends[1] ? ends[1] : ends[0];
    depth->at = ends[0];
    depth->step = 0;
}

/* whole / length of a depth and a length on the screen. */
typedef struct {
    int64_t quotient;
    uint32_t remainder, length;
} fxl_line_slope;

/* Requires whole < 2^61 and 0 < length < 2^30. */
static fxl_line_slope fxl_line_slope_of(uint64_t whole, uint32_t length)
{
    fxl_line_slope slope;
    uint32_t remainder;
    const uint32_t high = fxl_divide_u64(whole >> 32, length, &remainder);
    const uint32_t low =
        fxl_divide_u64((uint64_t)remainder << 32 | fxl_low_32(whole), length, &slope.remainder);
    slope.quotient = (int64_t)((uint64_t)high << 32 | low);
    slope.length = length;
    return slope;
}

/* whole * part / length, off by less than 2. Requires part <= length, or part = 65536 < length:
 * products of the quotient are at most whole, and those of the remainder are below 2^60. */
static int64_t fxl_line_share(const fxl_line_slope *slope, uint32_t part)
{
    uint32_t remainder;
    const uint32_t rest =
        fxl_divide_u64(fxl_multiply_u32(slope->remainder, part), slope->length, &remainder);
    return fxl_multiply_s64(slope->quotient, part) + rest;
}

/* A line from place to place: the pixel across is exact, as is fxl_line_pixels, whose parts are
 * multiples of 2^16 but for the last 16 bits of what is left. These stay as they are and decide no
 * comparison: they are left out. Where the line falls, what is left is that to the pixel's other
 * edge, so that it never becomes negative. */
typedef struct {
    int32_t first, end;         /* places along */
    int32_t across;             /* at the first one */
    int32_t change;             /* of the pixel across, where it changes: -1 or 1 */
    uint32_t left, pixel, step; /* left < pixel < 2^30, step <= pixel */
    bool upright;
} fxl_line_places;

/* Sets the depth at the first place, and its step; begin: the first place of the whole line. The first place of the whole line
 * does not depend on the band, so neither do the depths. A line of at most a pixel has one place. */
/* lines 3.3 */
static void fxl_line_find_depth(const fxl_painted_line *line, const fxl_line_places *places,
                                int32_t begin, const int64_t ends[2], fxl_line_depth *depth)
{
    const bool upright = places->upright;
    const int32_t a = upright ? line->ends[0].y : line->ends[0].x;
    const int32_t b = upright ? line->ends[1].y : line->ends[1].x;
    const bool swapped = b < a;
    const uint32_t length = (uint32_t)(swapped ? a - b : b - a); /* below 2^30 */
    const int64_t from = ends[swapped], to = ends[!swapped];
    const uint64_t whole = (uint64_t)(from < to ? to - from : from - to);
    const uint32_t before = (uint32_t)(fxl_centre_of(begin) - (swapped ? b : a));
    const fxl_line_slope slope = fxl_line_slope_of(whole, length);
    const int64_t rise = fxl_line_share(&slope, before);
    const int64_t step =
        length > 65536 && places->end - begin > 1 ? fxl_line_share(&slope, 65536) : 0;
    depth->step = from < to ? step : -step;
    depth->at = (from < to ? from + rise : from - rise) +
                fxl_multiply_s64(depth->step, places->first - begin);
}

#endif
