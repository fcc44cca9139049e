/* SPDX-License-Identifier: MIT */
/* The pixels of a target: where they are, and how some of them get one colour. The file that
 * includes this one has defined FXL_TARGET_PIXEL_BITS. Internal. */
#ifndef FXL_PIXEL_ROW_H
#define FXL_PIXEL_ROW_H

#include "../raster/fill.h"

/* place pixel-format: the type of a pixel, fxl_pixel, and what fills it, fxl_filling */
#if FXL_TARGET_PIXEL_BITS == 8

typedef uint8_t fxl_pixel;
typedef uint32_t fxl_filling; /* the colour in each byte */

static inline fxl_filling fxl_filling_of(const fxl_band *band, uint8_t colour, uint8_t shade,
                                         uint16_t dark)
{
    (void)band;
    (void)shade;
    (void)dark;
    return colour * 0x01010101u;
}

static inline void fxl_fill_pixels(fxl_pixel *pixel, fxl_pixel *end, fxl_filling filling)
{
    fxl_fill_row(pixel, end, filling);
}

/* rgb565 3.2 */
static inline fxl_status fxl_check_band(const fxl_band *band)
{
    (void)band;
    return FXL_OK;
}

#else

#include "../paint/rgb565_colour.h"
#include "fixel/target.h"

typedef uint16_t fxl_pixel;
typedef uint16_t fxl_filling;

static inline fxl_filling fxl_filling_of(const fxl_band *band, uint8_t colour, uint8_t shade,
                                         uint16_t dark)
{
    const uint16_t full = band->palette[colour];
    return shade == 0 ? full : fxl_mix_565(full, dark, 256u - shade);
}

static inline void fxl_fill_pixels(fxl_pixel *pixel, fxl_pixel *end, fxl_filling filling)
{
    fxl_fill_row_rgb565(pixel, end, filling);
}

static inline bool fxl_is_aligned_band(const fxl_band *band)
{
    return (((uintptr_t)band->pixels | (uintptr_t)band->palette) & 1u) == 0;
}

/* FXL_E_ALIGNMENT: pixels or a palette at an odd address. */
static inline fxl_status fxl_check_band(const fxl_band *band)
{
    return fxl_is_aligned_band(band) ? FXL_OK : FXL_E_ALIGNMENT;
}

#endif

static inline fxl_pixel *fxl_pixels_of_row(const fxl_band *band, uint32_t row)
{
    return (fxl_pixel *)(void *)band->pixels + (size_t)(row - band->first_row) * band->stride;
}

#endif
