/* SPDX-License-Identifier: MIT */
/* Depth codes: the numbers of a depth buffer. The nearer, the larger; 0 is where nothing was drawn.
 *
 * A depth d of 2^-(o + 1) <= d < 2^-o is in octave o. With e octaves and m bits of mantissa its
 * code, a number with 16 bits after the point, is
 *   (d 2^(o + 1) - 1 + e - 1 - o) 2^m + 1,
 * which grows with d, and within an octave is linear in d, so linear along a row. The code of a
 * pixel in column x is first + x step, where first and step are rounded down to 2^-16: it is too
 * small by less than 1024 2^-16. So it depends on the face and the pixel alone. Internal. */
#ifndef FXL_DEPTH_CODE_H
#define FXL_DEPTH_CODE_H

#include "../math/arith.h"
#include "gradients.h"

/* The plane of a face, as its depth on the screen. */
typedef struct fxl_depth_plane {
    fxl_gradient gradient;
    int32_t one; /* at z = near_z the gradient's 64 bits are 2^one */
} fxl_depth_plane;

/* `one` of a face that lies in one octave as a whole: the lower words of the gradient are the codes
 * of its pixels, modulo 2^32. So they are linear on the screen; rounded down, the steps make a code
 * too small by less than 2048 2^-16. */
#define FXL_DEPTH_IS_LINEAR INT32_MIN

/* `one` of a face that crosses the end of octave o, and no other: FXL_DEPTH_IS_BENT + o. The words
 * are the codes of octave o on the whole face. Beyond its end, whose code is `border`, they are too
 * large: an octave of half the depths has as many codes, so there the code is the word, less as
 * much again as it is below the border. That is the smaller of two linear codes. Rounded down, it
 * is too small by less than 4096 2^-16. */
#define FXL_DEPTH_IS_BENT  (INT32_MIN + 1)
#define FXL_DEPTH_BENT_END (FXL_DEPTH_IS_BENT + 24)

/* What the codes of a lens share. */
typedef struct {
    uint8_t octaves;  /* e: 1..24 */
    uint8_t mantissa; /* m: 11..15 */
} fxl_depth_scale;

/* 257/256 far_z <= 2^e near_z, so that no depth comes near the code 0. far_z is below 2^31, and
 * near_z shifted to the length of the sum is below 2^32. (e << m) + 1 codes are at most 65536. */
/* SPEC 10.3, 10.6 */
static inline fxl_depth_scale fxl_depth_scale_of(const fxl_lens *lens)
{
    const uint32_t far_z = (uint32_t)lens->far_z + ((uint32_t)lens->far_z >> 8) + 1;
    const uint32_t near_z = (uint32_t)lens->near_z;
    uint32_t octaves = fxl_leading_zeros(near_z) - fxl_leading_zeros(far_z);
    octaves += octaves == 0 || near_z << octaves < far_z;
    const fxl_depth_scale scale = {(uint8_t)octaves, (uint8_t)(fxl_leading_zeros(octaves) - 16u)};
    return scale;
}

/* Whether the gradient's lower words are codes. */
static inline bool fxl_depth_is_in_words(const fxl_depth_plane *plane)
{
    return plane->one < FXL_DEPTH_BENT_END;
}

/* Of a plane in words: the code of the end of the octave that it crosses, at most 2^32 - 2^26 +
 * 2^16; 0: it crosses none. */
static inline uint32_t fxl_depth_border_of(fxl_depth_scale scale, int32_t one)
{
    const int32_t number = one - FXL_DEPTH_IS_BENT;
    return number < 0 ? 0
                      : ((uint32_t)(scale.octaves - 1 - number) << (scale.mantissa + 16)) + 65536u;
}

static inline uint32_t fxl_depth_border(fxl_depth_scale scale, const fxl_depth_plane *plane)
{
    return fxl_depth_border_of(scale, plane->one);
}

/* The depths of a stretch of a row that have one octave. */
typedef struct {
    int64_t low, high; /* the gradient's 64 bits, in words 32: low <= value < high */
    int32_t drop;      /* bits, of the gradient's 64, below the code's; may be negative */
    uint32_t bias;     /* added to the code */
    uint32_t step;     /* of the code a pixel */
    bool is_constant;  /* the code is bias: beyond near_z, or at infinity */
} fxl_depth_octave;

static inline int64_t fxl_power_of_2(int32_t exponent)
{
    return exponent < 0 ? 1 : exponent > 62 ? INT64_MAX : (int64_t)1 << exponent;
}

/* The 32 lowest bits of floor(value / 2^drop). Requires -32 < drop < 64. */
static inline uint32_t fxl_depth_shifted(int64_t value, int32_t drop)
{
    const uint32_t low = fxl_low_32(fxl_bits_64(value));
    const int32_t high = (int32_t)(value >> 32);
    return drop >= 32 ? fxl_bits_32(high >> (drop - 32))
           : drop > 0 ? low >> drop | fxl_bits_32(high) << (32 - drop)
                      : low << -drop;
}

/* The octave of a word of a face. */
static inline void fxl_depth_octave_of_word(fxl_depth_scale scale, const fxl_depth_plane *plane,
                                            uint32_t value, fxl_depth_octave *octave)
{
    const uint32_t border = fxl_depth_border(scale, plane);
    const bool is_beyond = value < border;
    octave->low = is_beyond ? 0 : border;
    octave->high = is_beyond ? border : (int64_t)UINT32_MAX + 1;
    octave->drop = is_beyond ? -1 : 0;
    octave->bias = is_beyond ? 0u - border : 0;
    octave->step = fxl_low_32(fxl_bits_64(plane->gradient.along)) << (is_beyond ? 1 : 0);
    octave->is_constant = false;
}

/* The octave of a value of a face whose plane is not in words. */
/* SPEC 10.2, 10.3 */
static inline void fxl_depth_octave_of(fxl_depth_scale scale, const fxl_depth_plane *plane,
                                       int64_t value, fxl_depth_octave *octave)
{
    const int32_t length = value > 0 ? (int32_t)fxl_bit_length((uint64_t)value) : 0;
    const int32_t one = plane->one, number = one - length;
    octave->is_constant = true;
    octave->drop = 0;
    octave->step = 0;
    if (length == 0 || number >= scale.octaves) {
        octave->low = INT64_MIN;
        octave->high = fxl_power_of_2(one - scale.octaves);
        octave->bias = 65536u;
    } else if (number < 0) {
        octave->low = fxl_power_of_2(one);
        octave->high = INT64_MAX;
        octave->bias = UINT32_MAX;
    } else {
        octave->low = fxl_power_of_2(length - 1);
        octave->high = fxl_power_of_2(length);
        octave->drop = length - 17 - scale.mantissa; /* -31..34 */
        octave->bias = (fxl_bits_32(scale.octaves - 2 - number) << (scale.mantissa + 16)) + 65536u;
        octave->step = fxl_depth_shifted(plane->gradient.along, octave->drop);
        octave->is_constant = false;
    }
}

/* The code of the pixel in column x, below 2^16, of a face whose plane is not in words, of a row
 * where the gradient in column 0 is `depth`. */
/* billboards 4.2 */
static inline uint32_t fxl_depth_code_at(fxl_depth_scale scale, const fxl_depth_plane *plane,
                                         int64_t depth, int32_t x)
{
    const int64_t along = plane->gradient.along;
    const int64_t value = depth + fxl_multiply_s64_u16(along, (uint32_t)x);
    const int32_t upper = (int32_t)(value >> 32);
    fxl_depth_octave octave;
    if (!FXL_IS_COMPACT && upper > 0) { /* and not beyond an end: as fxl_depth_octave_of finds it */
        const int32_t length = 64 - (int32_t)fxl_leading_zeros((uint32_t)upper);
        const uint32_t number = (uint32_t)(plane->one - length);
        if (number < scale.octaves) {
            const int32_t drop = length - 17 - scale.mantissa; /* 1..36 */
            return ((scale.octaves - 2 - number) << (scale.mantissa + 16)) + 65536u +
                   fxl_depth_shifted(depth, drop) + fxl_depth_shifted(along, drop) * (uint32_t)x;
        }
    }
    fxl_depth_octave_of(scale, plane, value, &octave);
    return octave.is_constant
               ? octave.bias
               : octave.bias + fxl_depth_shifted(depth, octave.drop) + octave.step * (uint32_t)x;
}

static inline bool fxl_depth_octave_holds(const fxl_depth_octave *octave, int64_t value)
{
    return value >= octave->low && value < octave->high;
}

#endif
