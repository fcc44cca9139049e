/* SPDX-License-Identifier: MIT */
/* What a pixel of a target is, for the texts of the targets: none of them asks for a format, but for
 * what stands here. The file that includes this one has defined FXL_TARGET_FORMAT. A format defines
 *
 *   FXL_PIXEL_BITS          8 or 16, of a pixel
 *   FXL_PIXEL_HAS_PALETTE   1: pixels are colours, which the band's palette has for each entry
 *   FXL_PIXEL_IS_MIXED      1: light and blends mix colours; 0: tables have the entries
 *   fxl_pixel               the type of a pixel
 *   fxl_filling             what fills pixels of one colour
 *   fxl_filling_of          of an entry of the palette, of which light takes a part
 *   fxl_fill_pixels         a row of a filling
 *   fxl_filling_word        a word of pixels, for kernels
 *   fxl_draw_flat           an outline of a filling
 *   FXL_PIXEL_OF_ENTRY      a pixel of an entry
 *   fxl_check_band          whether pixels and palette of a band are aligned
 *   FXL_FILL_BAND           fxl_target.fill
 *   FXL_DRAW_DEPTH_OUTLINE  the kernel of outlines with a depth, for a depth of 16 bits
 *   FXL_DRAW_SMOOTH         the same of smooth outlines
 *   FXL_DRAW_SMOOTH_FACE    the same of a triangle, from its corners
 *   FXL_DRAW_COLOURS        the same of outlines with colours at their corners, where pixels are
 *                           mixed: only these have such faces
 *
 * surface_paint_text.h has what paints surfaces, and fxl_pixel_kind (columns.h) what has a band
 * alone. Internal. */
#ifndef FXL_PIXEL_ROW_H
#define FXL_PIXEL_ROW_H

#include "../raster/draw_outline.h"
#include "../raster/fill.h"
#include "fixel/target.h"

/* The values of FXL_TARGET_FORMAT. */
#define FXL_PALETTE_PIXELS 1
#define FXL_RGB565_PIXELS  2

/* place pixel-format: what a pixel of a target is */
#if FXL_TARGET_FORMAT == FXL_PALETTE_PIXELS

#define FXL_PIXEL_BITS         8
#define FXL_PIXEL_HAS_PALETTE  0
#define FXL_PIXEL_IS_MIXED     0
#define FXL_PIXEL_OF_ENTRY(band, entry) (entry)
#define FXL_FILL_BAND          fxl_fill_band_palette
#define FXL_DRAW_DEPTH_OUTLINE fxl_draw_depth_outline_8
#define FXL_DRAW_SMOOTH        fxl_draw_smooth_outline_8
#define FXL_DRAW_SMOOTH_FACE(inside, band, smooth) \
    FXL_DRAW_SMOOTH((inside)->corners.points, 3, band, smooth)

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

static inline uint32_t fxl_filling_word(fxl_filling filling)
{
    return filling;
}

static inline void fxl_fill_pixels(fxl_pixel *pixel, fxl_pixel *end, fxl_filling filling)
{
    fxl_fill_row(pixel, end, filling);
}

static inline bool fxl_draw_flat(fxl_scan *scan, const fxl_screen_polygon *polygon,
                                 const fxl_band *band, uint16_t dark)
{
    (void)dark;
    return fxl_draw_outline(scan, polygon, band, polygon->colour);
}

/* rgb565 3.2 */
static inline fxl_status fxl_check_band(const fxl_band *band)
{
    (void)band;
    return FXL_OK;
}

#elif FXL_TARGET_FORMAT == FXL_RGB565_PIXELS

#include "../paint/rgb565_colour.h"
#include "../raster/columns.h"

#define FXL_PIXEL_BITS         16
#define FXL_PIXEL_HAS_PALETTE  1
#define FXL_PIXEL_IS_MIXED     1
#define FXL_PIXEL_OF_ENTRY(band, entry) ((band)->palette[entry])
#define FXL_FILL_BAND          fxl_fill_band_rgb565
#define FXL_DRAW_DEPTH_OUTLINE fxl_draw_depth_outline_16
#define FXL_DRAW_SMOOTH        fxl_draw_smooth_outline_16
#define FXL_DRAW_SMOOTH_FACE   fxl_draw_smooth_triangle_16
#define FXL_DRAW_COLOURS       fxl_draw_colour_outline

typedef uint16_t fxl_pixel;
typedef uint16_t fxl_filling;

static inline fxl_filling fxl_filling_of(const fxl_band *band, uint8_t colour, uint8_t shade,
                                         uint16_t dark)
{
    const uint16_t full = band->palette[colour];
    return shade == 0 ? full : fxl_mix_565(full, dark, 256u - shade);
}

static inline uint32_t fxl_filling_word(fxl_filling filling)
{
    return filling * 65537u;
}

static inline void fxl_fill_pixels(fxl_pixel *pixel, fxl_pixel *end, fxl_filling filling)
{
    fxl_fill_row_rgb565(pixel, end, filling);
}

static inline bool fxl_draw_flat(fxl_scan *scan, const fxl_screen_polygon *polygon,
                                 const fxl_band *band, uint16_t dark)
{
    return fxl_draw_outline_rgb565(scan, polygon, band,
                                   fxl_filling_of(band, polygon->colour, polygon->shade, dark));
}

/* FXL_E_ALIGNMENT: pixels or a palette at an odd address. */
static inline fxl_status fxl_check_band(const fxl_band *band)
{
    return fxl_band_is_even(band) ? FXL_OK : FXL_E_ALIGNMENT;
}

#else
#error "FXL_TARGET_FORMAT is no format"
#endif

static inline fxl_pixel *fxl_pixels_of_row(const fxl_band *band, uint32_t row)
{
    return (fxl_pixel *)(void *)band->pixels + (size_t)(row - band->first_row) * band->stride;
}

#endif
