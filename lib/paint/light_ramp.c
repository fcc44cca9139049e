/* SPDX-License-Identifier: MIT */
/* The ramp of a palette. A file of its own: a program that has its ramp in flash does not link it.
 */
#include "../math/mix_colours.h"
#include "fixel/light.h"

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
            ramp[256 * (uint32_t)level + i] =
                fxl_mix_colours(palette, dark, &palette[3 * i], level, top);
        }
        ramp[256 * (uint32_t)top + i] = (uint8_t)i;
    }
    return FXL_OK;
}
