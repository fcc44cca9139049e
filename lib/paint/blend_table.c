/* SPDX-License-Identifier: MIT */
/* The blend table of a palette. A file of its own: a program that has its table in flash does not
 * link it. */
#include "rgb565_colour.h"
#include "fixel/surfaces.h"

/* place stipple: a blend: the table of a palette */
/* surfaces 4.3 */
fxl_status fxl_blend_make_table(const uint8_t *palette, uint32_t sixteenths, uint32_t first,
                                uint32_t count, uint8_t *table)
{
    if (palette == NULL || table == NULL) {
        return FXL_E_ARGUMENT;
    }
    if (sixteenths < 1 || sixteenths > 16) {
        return FXL_E_RANGE;
    }
    if (count == 0 || first > 255 || count > 256 - first) {
        return FXL_E_COUNT;
    }
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t colour = first + i;
        for (uint32_t beneath = 0; beneath < 256; beneath++) {
            table[256 * i + beneath] =
                beneath == colour /* which another entry may equal */
                    ? (uint8_t)colour
                    : fxl_mix_colours(palette, &palette[3 * beneath], &palette[3 * colour],
                                      (int32_t)sixteenths, 16);
        }
    }
    return FXL_OK;
}
