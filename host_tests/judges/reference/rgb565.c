/* SPDX-License-Identifier: MIT */
#include "reference/rgb565.h"

#include <math.h>

static const struct {
    int first_bit, most;
} channels[REF_CHANNELS] = {{11, 31}, {5, 63}, {0, 31}};

int ref_channel(uint16_t colour, int channel)
{
    return colour >> channels[channel].first_bit & channels[channel].most;
}

int ref_channel_most(int channel)
{
    return channels[channel].most;
}

uint16_t ref_colour_of(const int values[REF_CHANNELS])
{
    int colour = 0;
    for (int i = 0; i < REF_CHANNELS; i++) {
        colour += values[i] << channels[i].first_bit;
    }
    return (uint16_t)colour;
}

/* place pixel-format: the definition of its colours */
void ref_rgb565_make(ref_rgb565 *made, const uint8_t *palette, uint16_t dark)
{
    for (int i = 0; i < 256; i++) {
        const int values[REF_CHANNELS] = {palette[3 * i] / 8, palette[3 * i + 1] / 4,
                                          palette[3 * i + 2] / 8};
        made->palette[i] = ref_colour_of(values);
    }
    made->dark = dark;
}

/* place light: who asks the reference, and the part in RGB565 */
double ref_rgb565_part(const ref_light *light, double level)
{
    const double most = light->levels - 1;
    return most > 0 ? fmin(fmax(level - 0.5, 0), most) / most : 1;
}

double ref_rgb565_part_bound(const ref_light *light)
{
    return (0.5 + 0.125 + 1.0 / (light->levels - 1)) / 256;
}

double ref_rgb565_flat_part(double brightness)
{
    return floor(256 * brightness + 0.5) / 256;
}

double ref_rgb565_lit(const ref_rgb565 *of, uint16_t colour, int channel, double part)
{
    const int lit = ref_channel(colour, channel), dark = ref_channel(of->dark, channel);
    return dark + (lit - dark) * part;
}

uint16_t ref_rgb565_shown(const ref_rgb565 *of, uint16_t colour, double part)
{
    int values[REF_CHANNELS];
    for (int i = 0; i < REF_CHANNELS; i++) {
        values[i] = (int)floor(ref_rgb565_lit(of, colour, i, part) + 0.5);
    }
    return ref_colour_of(values);
}
