/* SPDX-License-Identifier: MIT */
#include "colour_run.h"

#include "../math/family.h"

#if !FXL_KERNELS_ARMV7M

void fxl_paint_colour_run(const fxl_colour_words *words, uint16_t *pixels, uint32_t count)
{
    const uint32_t step = words->step, green_step = words->green_step;
    uint32_t both = words->both, green = words->green;
    for (uint16_t *const end = pixels + count; pixels != end; pixels++) {
        *pixels = (uint16_t)((both & 0xF800u) | green >> 26 << 5 | both >> 27);
        both += step;
        green += green_step;
    }
}

#endif
