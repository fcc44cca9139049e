/* SPDX-License-Identifier: MIT */
/* The ordered dither of 8 x 8 pixels (docs/formats.md, section 4). Internal. */
#ifndef FXL_DITHER_H
#define FXL_DITHER_H

#include "../raster/columns.h"
#include "fixel/pixels.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How far a pixel of row y is from the next level, in 128ths of a level: for each of eight columns,
 * at most 127. */
const uint8_t *fxl_dither_row(uint32_t y);

/* Returns the level of an entry of fxl_grey_table, below 128 * 256. */
/* formats 4.3, pixels 1.3 */
static inline uint32_t fxl_dithered(uint32_t entry, const uint8_t *dither, uint32_t x)
{
    return (entry + dither[x & 7u]) >> 7;
}

/* The level, 0..highest, of a pixel of a row: a palette index of prepared pixels, or a colour of
 * RGB565. */
/* formats 4.2 */
static inline uint32_t fxl_dithered_pixel(const fxl_pixels *pixels, const void *row,
                                          fxl_pixel_kind kind, uint32_t highest, const uint8_t *dither, uint32_t x)
{
    const uint32_t pixel = fxl_pixel_at(kind, row, x);
    const uint32_t entry = kind.is_colour ? fxl_grey_of_rgb565((uint16_t)pixel, highest)
                                          : pixels->entries[pixel];
    return fxl_dithered(entry, dither, x);
}

#ifdef __cplusplus
}
#endif

#endif
