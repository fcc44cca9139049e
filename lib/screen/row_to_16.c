/* SPDX-License-Identifier: MIT */
#include "fixel/pixels.h"

#include "../math/family.h"
#include "../raster/fill.h"

#if !FXL_KERNELS_ARMV6M && !FXL_KERNELS_ARMV7M

#define BLOCK 16u /* pixels that are looked at together */

/* Whether the pixels of a block, aligned to four, are all of one colour. */
/* pixels 1.5 */
static bool is_uniform(const uint8_t *pixels)
{
    const fxl_word *words = (const fxl_word *)(const void *)pixels;
    const uint32_t first = words[0];
    return first == pixels[0] * 0x01010101u && first == words[1] && first == words[2] &&
           first == words[3];
}

static void fill(uint16_t *out, uint16_t colour)
{
    fxl_word *words = (fxl_word *)(void *)out;
    const uint32_t two = colour * 0x00010001u; /* below 2^32: 65535 * 65537 */
    for (uint32_t i = 0; i < BLOCK / 2u; i++) {
        words[i] = two;
    }
}

/* pixels 1.5 */
void fxl_row_to_16(const uint8_t *pixels, uint32_t count, const uint16_t *table, uint16_t *out)
{
    const uint8_t *end = pixels + count;
    while (pixels != end) {
        if (!FXL_IS_SMALL && (uint32_t)(end - pixels) >= BLOCK && ((uintptr_t)pixels & 3u) == 0 &&
            ((uintptr_t)out & 3u) == 0 && is_uniform(pixels)) {
            fill(out, table[*pixels]);
            pixels += BLOCK;
            out += BLOCK;
            continue;
        }
        *out++ = table[*pixels++];
    }
}

#endif
