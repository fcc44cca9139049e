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
        return fxl_line_code_in_octave(octave, depth, x);
    }
    fxl_depth_octave_of(scale, &face->plane, (int64_t)value, octave);
    face->span = 0;
    if (octave->is_constant) {
        return octave->bias;
    }
    const int32_t low = (int32_t)((octave->low + UINT32_MAX) >> 32);
    const int32_t high = (int32_t)(octave->high >> 32);
    face->first = fxl_bits_32(low);
    face->span = high > low ? fxl_bits_32(high) - fxl_bits_32(low) : 0;
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
    fxl_depth_plane unit; /* its `one`: what depths are counted in */
    int64_t at, step;     /* at the first place, and what a place adds */
    int64_t low, high;    /* the depths of the ends */
    fxl_depth_octave octave;
} fxl_line_depth;

/* lines 3.3 */
static uint32_t fxl_line_code_of_depth(fxl_depth_scale scale, fxl_line_depth *depth)
{
    const int64_t value = depth->at < depth->low    ? depth->low
                          : depth->at > depth->high ? depth->high
                                                    : depth->at;
    fxl_depth_octave *octave = &depth->octave;
    if (!fxl_depth_octave_holds(octave, value)) {
        fxl_depth_octave_of(scale, &depth->unit, value, octave);
    }
    return octave->is_constant ? octave->bias
                               : octave->bias + fxl_depth_shifted(value, octave->drop);
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
    depth->unit.gradient.at = depth->unit.gradient.along = depth->unit.gradient.down = 0;
    depth->unit.one = one;
    depth->low = ends[0] < ends[1] ? ends[0] : ends[1];
    depth->high = ends[0] < ends[1] ? ends[1] : ends[0];
    depth->at = ends[0];
    depth->step = 0;
    depth->octave.low = depth->octave.high = 0; /* holds nothing */
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

/* Sets the depth at the first place of the extent, and its step. The first place of the whole line
 * does not depend on the band, so neither do the depths. A line of at most a pixel has one place. */
/* lines 3.3 */
static void fxl_line_find_depth(const fxl_painted_line *line, const fxl_line_extent *extent,
                                bool upright, const int64_t ends[2], fxl_line_depth *depth)
{
    const int32_t a = upright ? line->ends[0].y : line->ends[0].x;
    const int32_t b = upright ? line->ends[1].y : line->ends[1].x;
    const bool swapped = b < a;
    const uint32_t length = (uint32_t)(swapped ? a - b : b - a); /* below 2^30 */
    const int64_t from = ends[swapped], to = ends[!swapped];
    const uint64_t whole = (uint64_t)(from < to ? to - from : from - to);
    const uint32_t before = (uint32_t)(fxl_centre_of(extent->begin) - (swapped ? b : a));
    const fxl_line_slope slope = fxl_line_slope_of(whole, length);
    const int64_t rise = fxl_line_share(&slope, before);
    const int64_t step =
        length > 65536 && extent->end - extent->begin > 1 ? fxl_line_share(&slope, 65536) : 0;
    depth->step = from < to ? step : -step;
    depth->at = (from < to ? from + rise : from - rise) +
                fxl_multiply_s64(depth->step, extent->first - extent->begin);
}

#endif
