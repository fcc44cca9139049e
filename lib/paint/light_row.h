/* SPDX-License-Identifier: MIT */
/* Neighbouring pixels of a face of one colour, whose light is linear. Light is one word, with 24
 * bits after the point, and a half, as in the gradients.
 *
 * Where the weight is constant, light is linear on the screen. That of column x of row y is at + y
 * down + x along modulo 2^32, where all three are rounded down to 2^-24: it is too small by less
 * than 2048 2^-24 level, and depends on the face and the pixel alone. It is from -128 to 128 in the
 * face: light at three corners is from 0 to 63, and the fourth corner of a parallelogram may be at
 * -63 or 126. Internal. */
#ifndef FXL_LIGHT_ROW_H
#define FXL_LIGHT_ROW_H

#include "../math/arith.h"
#include "paint.h"

/* The weight of such a face, of 64 bits. */
#define FXL_CONSTANT_WEIGHT ((int64_t)1 << 61)

static inline bool fxl_weight_is_constant(const fxl_gradients *gradients)
{
    const fxl_gradient *weight = &gradients->weight;
    return weight->at == FXL_CONSTANT_WEIGHT && (weight->along | weight->down) == 0;
}

typedef struct {
    uint32_t light, step; /* of the first pixel, and what a pixel adds */
} fxl_light_run;

/* The lower word of value / 2^drop, rounded down, for 0 <= drop <= 63, by words: cores have no
 * shift of 64 bits. */
static inline uint32_t fxl_lower_of_shifted(int64_t value, unsigned drop)
{
    const int32_t high = fxl_signed_32((uint32_t)(fxl_bits_64(value) >> 32));
    if (FXL_IS_SMALL) {
        return (uint32_t)(fxl_bits_64(fxl_shifted_down(value, drop)) & UINT32_MAX);
    }
    return drop >= 32
               ? fxl_bits_32(high >> (drop - 32u))
               : (uint32_t)(value & UINT32_MAX) >> drop | fxl_bits_32(high) << 1 << (31u - drop);
}

/* The light of a face on the screen. */
typedef struct {
    uint32_t at, along, down;
} fxl_light_plane;

/* A gradient's upper word is the light times 2^(29 - shift) in 16.16: so 53 - shift of its 64 bits
 * are below the word's. */
static inline fxl_light_plane fxl_light_plane_of(const fxl_gradients *gradients)
{
    const fxl_gradient *light = &gradients->attributes[0];
    const unsigned drop = (unsigned)(53 - gradients->shifts[0]);
    if (drop == 0) {
        const fxl_light_plane words = {fxl_low_32(fxl_bits_64(light->at)),
                                       fxl_low_32(fxl_bits_64(light->along)),
                                       fxl_low_32(fxl_bits_64(light->down))};
        return words;
    }
    const fxl_light_plane plane = {fxl_lower_of_shifted(light->at, drop),
                                   fxl_lower_of_shifted(light->along, drop),
                                   fxl_lower_of_shifted(light->down, drop)};
    return plane;
}

/* From column x0 of row y on. */
static inline fxl_light_run fxl_light_run_of(const fxl_paint *paint, int32_t y, int32_t x0)
{
    const fxl_light_plane plane = fxl_light_plane_of(paint->gradients);
    const fxl_light_run run = {plane.at + (uint32_t)y * plane.down + (uint32_t)x0 * plane.along,
                               plane.along};
    return run;
}

/* Whether the light of all of count pixels is from least on, and less than `range` above it: light
 * is linear, so that of both ends is. */
static inline bool fxl_light_run_is_within(const fxl_light_run *run, int32_t count, uint32_t least,
                                           uint32_t range)
{
    const uint32_t last = run->light + (uint32_t)(count - 1) * run->step;
    return run->light - least < range && last - least < range;
}

#endif
