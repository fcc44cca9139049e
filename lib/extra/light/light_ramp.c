/* SPDX-License-Identifier: MIT */
/* The ramp of a palette. A file of its own: a program that has its ramp in flash does not link it.
 */
#include "fixel/extra/light.h"

/* dark + (full - dark) * level / top, to nearest, halves upward. The quotient's numerator is below
 * 2 * 255 * 63 + 64; its offset makes it positive. */
static int32_t between(int32_t dark, int32_t full, int32_t level, int32_t top)
{
    return (2 * (dark * (top - level) + full * level) + top) / (2 * top);
}

/* The number of the entry of the palette that is nearest to a colour. */
static uint8_t nearest(const uint8_t *palette, const int32_t *colour)
{
    int32_t least = 3 * 255 * 255 + 1;
    uint32_t found = 0;
    for (uint32_t i = 0; i < 256; i++) {
        int32_t distance = 0;
        for (uint32_t k = 0; k < 3; k++) {
            const int32_t difference = palette[3 * i + k] - colour[k];
            distance += difference * difference;
        }
        if (distance < least) { /* bug: ramp-first */
            least = distance;
            found = i;
        }
    }
    return (uint8_t)found;
}

fxl_status fxl_light_make_ramp(const uint8_t *palette, const uint8_t *dark, uint32_t levels,
                               uint8_t *ramp)
{
    if (palette == NULL || dark == NULL || ramp == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (levels < FXL_LIGHT_LEVELS_MIN || levels > FXL_LIGHT_LEVELS_MAX) {
        return FXL_E_COUNT;
    }
    const int32_t top = (int32_t)levels - 1;
    for (uint32_t i = 0; i < 256; i++) {
        for (int32_t level = 0; level < top; level++) {
            int32_t colour[3];
            for (uint32_t k = 0; k < 3; k++) {
                colour[k] = between(dark[k], palette[3 * i + k], level, top);
            }
            ramp[256 * (uint32_t)level + i] = nearest(palette, colour);
        }
        ramp[256 * (uint32_t)top + i] = (uint8_t)i;
    }
    return FXL_OK;
}
