/* SPDX-License-Identifier: MIT */
/* Colours between two others: of 16 bits, and in a palette. Internal. */
#ifndef FXL_RGB565_COLOUR_H
#define FXL_RGB565_COLOUR_H

#include <stdint.h>

#include "../math/core.h"

#ifdef __cplusplus
extern "C" {
#endif

/* place pixel-format: a new file beside it: how light takes a part of a colour, how two are mixed */
/* The channels of a colour, where they are. */
#define FXL_RED_565   0xF800u
#define FXL_GREEN_565 0x07E0u
#define FXL_BLUE_565  0x001Fu

/* Of two colours in a word: channels with zeros between them, blue and red of the lower one and green
 * of the upper one. Each has four bits of room for a product with 16 at most. */
#define FXL_SPREAD_565 0x07E0F81Fu

/* place stipple: a blend: how two colours of RGB565 are mixed */
/* Of the colours that spread channels belong to: (colour * sixteenths + beneath * (16 -
 * sixteenths)) / 16 of each channel, rounded down. The sum is 16 times a channel's largest value at
 * most: in the uppermost place below 63 * 2^25. Requires sixteenths <= 16. */
/* rgb565 2.2 */
static inline uint32_t fxl_blend_spread_565(uint32_t colour, uint32_t beneath, uint32_t sixteenths)
{
    uint32_t channels = FXL_SPREAD_565;
    FXL_HIDE(channels);
    const uint32_t sum =
        (colour & channels) * sixteenths + (beneath & channels) * (16u - sixteenths);
    return sum >> 4 & channels;
}

/* The halves of a word. */
static inline uint32_t fxl_exchanged_565(uint32_t colours)
{
    return colours << 16 | colours >> 16;
}

/* The same of all channels of two colours, one in each half of a word. */
/* rgb565 2.2 */
static inline uint32_t fxl_blend_565(uint32_t colours, uint32_t beneath, uint32_t sixteenths)
{
    const uint32_t others = fxl_blend_spread_565(fxl_exchanged_565(colours),
                                                 fxl_exchanged_565(beneath), sixteenths);
    return fxl_blend_spread_565(colours, beneath, sixteenths) | fxl_exchanged_565(others);
}

/* The lowest and the highest bits of the channels of two colours. */
#define FXL_LOWEST_565  0x08210821u
#define FXL_HIGHEST_565 0x84108410u

/* The sum of each channel, or its largest value, of two colours in each word. Half a sum, rounded
 * down, is what both channels have and half of what one has: it fits a channel. Its highest bit says
 * that the sum does not. Twice such a bit less a 16th of it are 5 bits from it down; the 6th one of
 * green is its 32nd, which of the others is no lowest bit. */
/* rgb565 2.3 */
static inline uint32_t fxl_add_565(uint32_t a, uint32_t b)
{
    uint32_t lowest = FXL_LOWEST_565, highest = FXL_HIGHEST_565;
    FXL_HIDE(lowest);
    FXL_HIDE(highest);
    const uint32_t unlike = a ^ b, half = (a & b) + ((unlike & ~lowest) >> 1);
    const uint32_t carries = half & highest;
    const uint32_t sum = (half ^ carries) << 1 | ((unlike | carries >> 5) & lowest);
    return sum | ((carries << 1) - (carries >> 4));
}

/* One channel of dark + (colour - dark) * part / 256, rounded to nearest, halves upward. Channels
 * are below 2^16 and parts at most 2^8, so the sum is below 2^24 + 2^18. */
/* rgb565 2.1 */
static inline uint32_t fxl_mix_channel_565(uint32_t colour, uint32_t dark, uint32_t part,
                                           uint32_t channel)
{
    const uint32_t lowest = channel & ~(channel - 1u);
    const uint32_t sum = (colour & channel) * part + (dark & channel) * (256u - part);
    return (sum + 128u * lowest) >> 8 & channel;
}

/* Requires part <= 256. */
/* rgb565 3.4 */
static inline uint16_t fxl_mix_565(uint32_t colour, uint32_t dark, uint32_t part)
{
    return (uint16_t)(fxl_mix_channel_565(colour, dark, part, FXL_RED_565) |
                      fxl_mix_channel_565(colour, dark, part, FXL_GREEN_565) |
                      fxl_mix_channel_565(colour, dark, part, FXL_BLUE_565));
}

/* What mixes two colours by parts, in two words: red and blue, whose lowest bits are 27 and 8, and
 * green, whose lowest bit is 13. A channel has 8 bits after the point, and half a unit of the
 * lowest bit that is kept. It is dark, and the parts of a 256th of the difference: between those of
 * the two colours, so fields of one word do not touch. */
typedef struct {
    uint32_t red_dark, red_step, green_dark, green_step;
} fxl_mixture_565;

static inline uint32_t fxl_red_and_blue_565(uint32_t colour)
{
    return (colour & FXL_RED_565) << 16 | (colour & FXL_BLUE_565) << 8;
}

static inline uint32_t fxl_raised_green_565(uint32_t colour)
{
    return (colour & FXL_GREEN_565) << 8;
}

/* fxl_mix_565 of these two and any part. */
static inline fxl_mixture_565 fxl_mixture_of_565(uint32_t colour, uint32_t dark)
{
    const uint32_t red = fxl_red_and_blue_565(dark), green = fxl_raised_green_565(dark);
    const fxl_mixture_565 mixture = {red + (1u << 26 | 1u << 7),
                                     (fxl_red_and_blue_565(colour) >> 8) - (red >> 8),
                                     green + (1u << 12), (colour & FXL_GREEN_565) - (green >> 8)};
    return mixture;
}

/* fxl_mix_565 of a colour and of the dark colour of a mixture of the colour 0. */
static inline uint16_t fxl_mixed_565(const fxl_mixture_565 *mixture, uint32_t colour, uint32_t part)
{
    const uint32_t red =
        mixture->red_dark + (mixture->red_step + (fxl_red_and_blue_565(colour) >> 8)) * part;
    const uint32_t green =
        mixture->green_dark + (mixture->green_step + (colour & FXL_GREEN_565)) * part;
    return (uint16_t)((red >> 16 & FXL_RED_565) | (green >> 8 & FXL_GREEN_565) |
                      (red >> 8 & FXL_BLUE_565));
}

/* light part_of_level / 2^32, rounded down: how much of 256 parts light leaves, which has 24 bits after the
 * point. Requires a product below 2^48; then no sum here is above 2^32. */
static inline uint32_t fxl_part_of_565(uint32_t light, uint32_t part_of_level)
{
#if FXL_HAS_LONG_PRODUCT
    return (uint32_t)(fxl_multiply_u32(light, part_of_level) >> 32);
#else
    return ((light >> 16) * part_of_level + ((light & 0xFFFFu) * part_of_level >> 16)) >> 16;
#endif
}

/* Half of 1/256 of the light of a ramp, in levels with 24 bits after the point: what is added to it
 * so that parts are rounded to nearest. */
static inline uint32_t fxl_half_part_565(uint32_t levels_less_1)
{
    return levels_less_1 << 15;
}

/* --- in a palette -------------------------------------------------------------------------- */

/* The number of the entry of a palette that is nearest to a colour: by the sum of the squared
 * differences; of those at the same distance the first. */
/* light 3.2 */
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

/* place light: fxl_mix_colours: a level of the ramp between dark and full */
/* The number of the entry that is nearest to from + (to - from) * part / whole, each of the three
 * rounded to nearest, halves upward. Requires 0 <= part <= whole, 1 <= whole <= 63. The quotient's
 * numerator is below 2 * 255 * 63 + 64; its offset makes it positive. */
/* light 3.2 */
static inline uint8_t fxl_mix_colours(const uint8_t *palette, const uint8_t *from,
                                      const uint8_t *to, int32_t part, int32_t whole)
{
    int32_t colour[3];
    for (uint32_t k = 0; k < 3; k++) {
        colour[k] = (2 * (from[k] * (whole - part) + to[k] * part) + whole) / (2 * whole);
    }
    return fxl_nearest_colour(palette, colour);
}

#ifdef __cplusplus
}
#endif

#endif
