/* SPDX-License-Identifier: MIT */
#include "colour_run.h"

#include "../math/family.h"

#if !FXL_KERNELS_ARMV7M

void fxl_paint_colour_run(const fxl_colour_words *words, uint16_t *pixels, uint32_t count)
{
    const uint32_t step = words->step, green_step = words->green_step;
    uint32_t both = words->both, green = words->green;
    for (uint16_t *const end = pixels + count; pixels != end; pixels++) {
        const uint32_t red_and_green = both >> 27 << 6 | green >> 26;
        *pixels = (uint16_t)(red_and_green << 5 | (both >> 11 & 31u));
        both += step;
        green += green_step;
    }
}

#endif
