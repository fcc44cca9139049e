/* SPDX-License-Identifier: MIT */
/* Colours of RGB565 frames (docs/extras/rgb565.md) from their definitions. */
#ifndef REF_RGB565_H
#define REF_RGB565_H

#include "reference/light.h"

enum {
    REF_CHANNELS = 3
};

/* place pixel-format: the definition of its colours */
/* What frames of 16 bits a pixel are drawn with. */
typedef struct {
    uint16_t palette[256];
    uint16_t dark; /* what the lowest level of light leaves */
} ref_rgb565;

/* From a palette of 256 x red, green, blue. */
void ref_rgb565_make(ref_rgb565 *made, const uint8_t *palette, uint16_t dark);

/* Red, green, blue of a colour, and the largest value of each. */
int ref_channel(uint16_t colour, int channel);
int ref_channel_most(int channel);
uint16_t ref_colour_of(const int channels[REF_CHANNELS]);

/* place light: who asks the reference, and the part in RGB565 */
/* The part of a colour that is left at a place of the ramp, in levels, of which the nearest is what
 * is below: 0..1. */
double ref_rgb565_part(const ref_light *light, double level);

/* How far the library's part may be off (docs/extras/rgb565.md, section 2.1). */
double ref_rgb565_part_bound(const ref_light *light);

/* The part that is left of a flat face's colour at a brightness (docs/extras/rgb565.md, section 2.1). */
double ref_rgb565_flat_part(double brightness);

/* How far the library's brightness may be off (docs/extras/light.md, section 2.5). */
#define REF_BRIGHTNESS_BOUND 0x1.Ap-26

/* A channel of a colour of which a part is left, before it is rounded. */
double ref_rgb565_lit(const ref_rgb565 *of, uint16_t colour, int channel, double part);

/* A colour of which a part is left. */
uint16_t ref_rgb565_shown(const ref_rgb565 *of, uint16_t colour, double part);

#endif
