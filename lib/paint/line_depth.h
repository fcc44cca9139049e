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

/* The word of a depth. */
static inline uint32_t fxl_line_word_of(uint64_t value)
{
    return (uint32_t)(value >> 32);
}

/* How the codes of an octave go on from pixel to pixel: exact, as no bit below the code's is lost,
 * nor one above it: where they are shifted, mantissas have 12 bits at most, and codes without the
 * bias fewer than 30. */
static inline void fxl_line_find_steps(fxl_line_plane *face, const fxl_depth_octave *octave)
{
    const fxl_gradient *gradient = &face->plane.gradient;
    const int32_t up = octave->drop < 32 ? 32 - octave->drop : 0; /* below 64 */
    face->shift = (uint32_t)(octave->drop > 32 ? octave->drop - 32 : 0);
    face->added = face->shift != 0 ? octave->bias : 0;
    face->start =
        (fxl_bits_64(gradient->at) << up) + ((uint64_t)(octave->bias - face->added) << 32);
    face->steps[0] = (uint64_t)(octave->step << face->shift) << 32;
    face->steps[1] = fxl_bits_64(gradient->down) << up;
}

/* The same of most octaves: that of depths of so many bits. False: it is another one. As
 * fxl_depth_octave_of finds it. */
static inline bool fxl_line_find_most_steps(fxl_depth_scale scale, fxl_line_plane *face,
                                            int32_t length)
{
    const fxl_gradient *gradient = &face->plane.gradient;
    const int32_t drop = length - 17 - scale.mantissa;
    const uint32_t number = (uint32_t)(face->plane.one - length);
    if (number >= scale.octaves || drop < 1 || drop > 31) {
        return false;
    }
    const uint32_t bias = ((scale.octaves - 2u - number) << (scale.mantissa + 16)) + 65536u;
    face->shift = face->added = 0;
    face->start = (fxl_bits_64(gradient->at) << (32 - drop)) + ((uint64_t)bias << 32);
    face->steps[0] = (uint64_t)fxl_depth_shifted(gradient->along, drop) << 32;
    face->steps[1] = fxl_bits_64(gradient->down) << (32 - drop);
    return true;
}

static inline void fxl_line_take_octave(fxl_line_plane *face, const fxl_depth_octave *octave)
{
    fxl_line_find_steps(face, octave);
    if (octave->is_constant) {
        face->start = (uint64_t)octave->bias << 32;
        face->steps[0] = face->steps[1] = face->shift = face->added = 0;
    }
}

/* The octave of a word of a plane in words, which beside the face may be beyond all codes: below the
 * least one, 1, or from 2^16 on. The border is 2^16 times an odd number, and beyond it a code is twice
 * the word less the border. Without a border all lines are held that leave no code, whose words of
 * fxl_line_plane_begin have 12 bits. */
/* lines 3.2 */
static FXL_COLD __attribute__((noinline)) void
fxl_line_find_words(fxl_depth_scale scale, fxl_line_plane *face, int32_t word)
{
    const int32_t border = (int32_t)(fxl_depth_border(scale, &face->plane) >> 16);
    const int32_t least = border > 1 ? (border + 1) / 2 : 1;
    const uint32_t margin = face->margin - FXL_LINE_MARGIN_OF_WORDS;
    int32_t first = INT32_MIN, end = least;
    fxl_depth_octave octave = {0, 0, 0, word < least ? 65536u : UINT32_MAX, 0, true};
    if (word >= 65536) {
        first = 65536;
        end = INT32_MAX;
    } else if (word >= least) {
        const bool is_beyond = word < border;
        first = is_beyond || border < least ? least : border;
        end = is_beyond ? border : 65536;
        octave.drop = is_beyond ? 15 : 16;
        octave.bias = is_beyond ? 0u - (fxl_bits_32(border) << 16) : 0;
        octave.step = fxl_depth_shifted(face->plane.gradient.along, octave.drop);
        octave.is_constant = false;
        if (border == 0 && margin < 2000) {
            face->low = margin + 1u;
            face->held = 4095u - 2u * margin;
        }
    }
    face->first = fxl_bits_32(first);
    face->span = fxl_bits_32(end) - fxl_bits_32(first);
    fxl_line_take_octave(face, &octave);
}

/* The octave of a value. All depths of an upper word are in an octave if its low end, rounded
 * up to 2^32, is not above them, and its high end, rounded down, is. One whose code is constant holds
 * none, but of a plane in words. */
static __attribute__((noinline)) void fxl_line_find_other(fxl_depth_scale scale,
                                                          fxl_line_plane *face, uint64_t value)
{
    const uint32_t word = fxl_line_word_of(value);
    const int32_t length = 64 - (int32_t)fxl_leading_zeros(word | 1u);
    face->held = 0;
    if (fxl_depth_is_in_words(&face->plane)) {
        fxl_line_find_words(scale, face, fxl_signed_32(word));
    } else if (length > 33 && length < 64 && fxl_line_find_most_steps(scale, face, length)) {
        face->first = face->span = (uint32_t)1 << (length - 33);
    } else {
        fxl_depth_octave octave;
        fxl_depth_octave_of(scale, &face->plane, (int64_t)value, &octave);
        const int32_t low = (int32_t)((octave.low + UINT32_MAX) >> 32);
        const int32_t high = (int32_t)(octave.high >> 32);
        face->first = fxl_bits_32(low);
        face->span = !octave.is_constant && high > low ? fxl_bits_32(high) - fxl_bits_32(low) : 0;
        fxl_line_take_octave(face, &octave);
    }
}

/* The value of a face at the centre of a pixel. */
static inline uint64_t fxl_line_value_of(const fxl_line_plane *face, int32_t x, int32_t y)
{
    const fxl_gradient *gradient = &face->plane.gradient;
    return fxl_bits_64(gradient->at + fxl_multiply_s64_u16(gradient->down, (uint32_t)y) +
                       fxl_multiply_s64_u16(gradient->along, (uint32_t)x));
}

/* The code that a face has at the centre of a pixel. */
/* lines 3.2 */
static uint32_t fxl_line_code_of_face(fxl_depth_scale scale, fxl_line_plane *face, int32_t x,
                                      int32_t y)
{
    const uint64_t value = fxl_line_value_of(face, x, y);
    if (!fxl_line_holds(face, fxl_line_word_of(value))) {
        fxl_line_find_other(scale, face, value);
    }
    const uint64_t code = face->start + face->steps[0] * (uint32_t)x + face->steps[1] * (uint32_t)y;
    return face->added + (fxl_line_word_of(code) >> face->shift);
}

static inline bool fxl_line_has_words(const fxl_line_plane *face, uint32_t first, uint32_t last)
{
    return first - face->low < face->held && last - face->low < face->held;
}

/* The octave of a line on a face whose ends have these words: that of the first one. False: it may not
 * hold all pixels. */
static __attribute__((noinline)) bool
fxl_line_find_octave(fxl_depth_scale scale, fxl_line_plane *face, uint32_t first, uint32_t last)
{
    const int32_t bits = 32 - (int32_t)fxl_leading_zeros(first | 1u);
    const uint32_t size = (uint32_t)1 << (bits - 1);
    if (bits > 31 || size / 2u <= face->margin ||
        !fxl_line_find_most_steps(scale, face, bits + face->drop + 16)) {
        return false;
    }
    face->low = size + face->margin;
    face->held = size - 2u * face->margin;
    face->span = 0;
    return fxl_line_has_words(face, first, last);
}

/* The depth of a line without planes from place to place along its major axis. */
typedef struct {
    int32_t one;      /* as that of a fxl_depth_plane: what depths are counted in */
    int64_t at, step; /* at the first place, and what a place adds */
} fxl_line_depth;

/* lines 3.3 */
static inline uint32_t fxl_line_code_of_depth(fxl_depth_scale scale, const fxl_line_depth *depth)
{
    const fxl_depth_plane unit = {{0, 0, 0}, depth->one};
    return fxl_depth_code_at(scale, &unit, depth->at, 0);
}

/* The same without the lower 16 bits, as a cell of 16 bits has it: of most depths the upper word has
 * them all. */
static inline uint32_t fxl_line_cell_of_depth(fxl_depth_scale scale, const fxl_line_depth *depth)
{
    const uint32_t upper = fxl_line_word_of(fxl_bits_64(depth->at));
    const int32_t zeros = (int32_t)fxl_leading_zeros(upper | 1u), bits = 31 - zeros;
    const uint32_t number = (uint32_t)(depth->one - 33 - bits);
    return bits >= scale.mantissa && number < scale.octaves
               ? ((scale.octaves - 2u - number) << scale.mantissa) + 1u +
                     (upper >> (bits - scale.mantissa))
               : fxl_line_code_of_depth(scale, depth) >> 16;
}

/* The ratio of two mantissas, times 2^31 and off by less than 2^-27 of it: part / 2 by two digits of 16
 * bits, as fxl_mantissa_ratio by exact ones. The first is too small by 2 at most, so what is left is
 * below 2^34. The second is off by less than 2^-15 of it, too large if `more` is 0, or too small if it
 * is 1, and rounded down by less than 5. */
static inline uint32_t fxl_line_ratio(uint32_t part, uint32_t whole, uint32_t more)
{
    const uint32_t half = part >> 1, upper = whole >> 16;
    uint32_t rest;
    const uint32_t high = fxl_divide_u32(half, upper + 1u, &rest);
    const uint64_t left = ((uint64_t)half << 16) - fxl_multiply_u32(high, whole);
    return (high << 16) + (fxl_divide_u32((uint32_t)(left >> 2), upper + more, &rest) << 2);
}

/* near_z / distance as mantissa * 2^-one, off by less than 2^-27 of it, is what the canvas then has.
 * near_z has units of 2^-16 and the distance of 2^-46. */
static void fxl_line_find_end(fxl_line_canvas *canvas, fxl_q18_46 distance)
{
    if (distance != canvas->distance) {
        const fxl_real divisor = fxl_real_of((uint64_t)distance, 0);
        canvas->distance = distance;
        canvas->one = divisor.exponent - canvas->near_real.exponent + 1;
        canvas->mantissa = fxl_line_ratio(canvas->near_real.mantissa, divisor.mantissa, 0);
    }
}

/* The depths of both ends in one unit, in which the nearer one is below 2^61. */
typedef struct {
    int32_t one;
    int64_t first, second;
} fxl_line_end_depths;

/* mantissa 2^(29 - drop), rounded down. */
static inline int64_t fxl_line_scaled(uint32_t mantissa, int32_t drop)
{
    const uint64_t scaled = (uint64_t)mantissa << 29;
    return drop == 0 ? (int64_t)scaled : drop < 64 ? (int64_t)(scaled >> drop) : 0;
}

static inline fxl_line_end_depths fxl_line_find_ends(fxl_line_canvas *canvas,
                                                     const fxl_q18_46 distances[2])
{
    fxl_line_end_depths ends;
    fxl_line_find_end(canvas, distances[0]);
    const uint32_t first = canvas->mantissa;
    const int32_t first_one = canvas->one;
    fxl_line_find_end(canvas, distances[1]);
    const int32_t least = first_one < canvas->one ? first_one : canvas->one;
    ends.one = least + 29;
    ends.first = fxl_line_scaled(first, first_one - least);
    ends.second = fxl_line_scaled(canvas->mantissa, canvas->one - least);
    return ends;
}

/* A line between its ends, as they are along and across: the lower end, and how far the other one is
 * from it. */
typedef struct {
    fxl_q16_16 from, side, length, rise; /* |rise| <= length < 2^30 */
} fxl_line_ends;

/* value 2^shift, rounded down. Requires a shift above -64, and a result below 2^63. */
static inline int64_t fxl_line_shifted(uint64_t value, int32_t shift)
{
    return (int64_t)(shift >= 0 ? value << shift : value >> -shift);
}

/* The depth of a line at place `first`, and its step; swapped: its first end is not the lower one. The
 * first place of the whole line does not depend on the band, so neither do the depths. What the depth of
 * a place is more than that of the more distant end is too small by 2^-27 of it, as the ratio is, and by
 * a unit for each of two numbers that are rounded down. So it is from 0 to the whole, and this is below
 * 2^61. */
/* lines 3.3 */
static inline void fxl_line_find_depth(fxl_line_canvas *canvas, const fxl_painted_line *line,
                                       const fxl_line_ends *ends, bool swapped, int32_t first,
                                       fxl_line_depth *depth)
{
    const fxl_line_end_depths depths = fxl_line_find_ends(canvas, line->distances);
    const int64_t more = depths.second - depths.first;
    depth->one = depths.one;
    depth->at = more < 0 ? depths.second : depths.first;
    depth->step = 0;
    if (more != 0) {
        const bool rises = (more > 0) != swapped;
        /* place fill-rule: the first place of a line's depth */
        const int32_t begin = (ends->from + 32767) >> 16;
        const uint32_t length = (uint32_t)ends->length;
        const uint32_t before = (uint32_t)(fxl_centre_of(begin) - ends->from);
        const fxl_real whole = fxl_real_of((uint64_t)(more < 0 ? -more : more), 0);
        const fxl_real divisor = fxl_real_of(length, 0);
        const uint32_t ratio = fxl_line_ratio(whole.mantissa, divisor.mantissa, 1);
        const int32_t shift = whole.exponent - divisor.exponent - 31; /* from -61 on */
        const uint32_t part = rises ? before : length - before;
        depth->at += fxl_line_shifted(fxl_multiply_u32(ratio, part), shift);
        if (length - before > 65536) {
            const int64_t step = fxl_line_shifted(ratio, shift + 16);
            depth->step = rises ? step : -step;
            if (first != begin) {
                depth->at += fxl_multiply_s64(depth->step, first - begin);
            }
        }
    }
}

#endif
