/* SPDX-License-Identifier: MIT */
/* Opaque pixels of RGB565 whose channels are linear. A kernel of Armv7-M. Internal. */
#ifndef FXL_COLOUR_RUN_H
#define FXL_COLOUR_RUN_H

#include <stdint.h>

#include "../math/core.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The first pixel, and what a pixel adds, in the order in which the kernel loads them. `both` has
 * blue in its upper half and red in its lower one, each with 11 bits after the point; green has 26.
 * A channel's level is what stands in the uppermost bits: red's is where a pixel has it. */
typedef struct {
    uint32_t both, green, step, green_step;
} fxl_colour_words;

/* Red and blue in 10.22, in one word: each loses 11 bits. */
static inline uint32_t fxl_colours_both(int32_t red, int32_t blue)
{
    return (fxl_bits_32(blue >> 11) << 16) + fxl_bits_32(red >> 11);
}

/* Writes count pixels. Sums are modulo 2^32; red and blue of all pixels are from 0 to below 32, or
 * the two mix. Requires count > 0. */
void fxl_paint_colour_run(const fxl_colour_words *words, uint16_t *pixels, uint32_t count);

#ifdef __cplusplus
}
#endif

#endif
