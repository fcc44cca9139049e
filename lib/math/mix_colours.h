/* SPDX-License-Identifier: MIT */
/* Colours between two others, in a palette. Internal. */
#ifndef FXL_MIX_COLOURS_H
#define FXL_MIX_COLOURS_H

#include <stdint.h>

/* The number of the entry of a palette that is nearest to a colour: by the sum of the squared
 * differences; of those at the same distance the first. */
static inline uint8_t fxl_nearest_colour(const uint8_t *palette, const int32_t *colour)
{
    int32_t least = 3 * 255 * 255 + 1;
    uint32_t found = 0;
    for (uint32_t i = 0; i < 256; i++) {
        int32_t distance = 0;
        for (uint32_t k = 0; k < 3; k++) {
            const int32_t difference = palette[3 * i + k] - colour[k];
            distance += difference * difference;
        }
        if (distance < least) {
            least = distance;
            found = i;
        }
    }
    return (uint8_t)found;
}

/* The number of the entry that is nearest to from + (to - from) * part / whole, each of the three
 * rounded to nearest, halves upward. Requires 0 <= part <= whole, 1 <= whole <= 63. The quotient's
 * numerator is below 2 * 255 * 63 + 64; its offset makes it positive. */
static inline uint8_t fxl_mix_colours(const uint8_t *palette, const uint8_t *from,
                                      const uint8_t *to, int32_t part, int32_t whole)
{
    int32_t colour[3];
    for (uint32_t k = 0; k < 3; k++) {
        colour[k] = (2 * (from[k] * (whole - part) + to[k] * part) + whole) / (2 * whole);
    }
    return fxl_nearest_colour(palette, colour);
}

#endif
