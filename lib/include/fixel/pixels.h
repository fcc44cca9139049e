/* SPDX-License-Identifier: MIT */
/* Pixels as a display takes them: converts rows of palette indices or of RGB565 to 24, 16 or 8 bits
 * of colour, to 16 greys, or to black and white with an ordered dither. docs/extras/pixels.md defines
 * the formats bit for bit. */
#ifndef FXL_PIXELS_H
#define FXL_PIXELS_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FXL_PALETTE_COLOURS 256

typedef struct fxl_pixels fxl_pixels;

/* A format: one of the constant records below. A program links the formats that it names. */
typedef struct {
    uint8_t bits; /* of a pixel: 24, 16, 8, 4 or 1 */
    uint8_t rows; /* of the frame in a byte: 1, or 8 in pages */
    void (*prepare)(uint16_t *entries, const uint8_t *palette);
    /* band: its pixels are those from column 0 on, also where it has some columns alone. */
    void (*convert)(const fxl_pixels *pixels, const fxl_band *band, uint8_t *out);
} fxl_pixel_format;

/* place converter: its declaration, and the comment at the top */
extern const fxl_pixel_format fxl_pixels_rgb565;     /* the byte with red first: displays on SPI */
extern const fxl_pixel_format fxl_pixels_rgb565_low; /* the byte with blue first: a framebuffer of a
                                                 little-endian core */
extern const fxl_pixel_format fxl_pixels_rgb666;     /* a byte a channel, red first, of which displays
                                                 take the upper six bits; its colours are those of RGB565 */
extern const fxl_pixel_format fxl_pixels_rgb332;     /* red in the upper three bits */
extern const fxl_pixel_format fxl_pixels_grey4; /* 16 greys,
    dithered; the left pixel in the upper half */
extern const fxl_pixel_format fxl_pixels_mono_rows;  /* dithered; the leftmost pixel in the highest bit */
extern const fxl_pixel_format fxl_pixels_mono_pages; /* dithered; a byte is eight pixels of a column, the
                                                 topmost in the lowest bit; a page is eight rows */

/* A palette, prepared for one format. The caller owns it. Members are for reading only. */
struct fxl_pixels {
    const fxl_pixel_format *format;
    uint16_t entries[FXL_PALETTE_COLOURS];
};

/* Prepares a palette of 256 x red, green, blue: that of a scene, or cube_palette[0] of an exported
 * one.
 * FXL_E_ARGUMENT: a null pointer; a format of zeros; *pixels untouched. */
fxl_status fxl_pixels_init(fxl_pixels *pixels, const fxl_pixel_format *format,
                           const uint8_t *palette);

/* Returns the bytes that rows of a width take in a format. A row begins with a byte of its own,
 * and a page too. Returns 0 for a format that is null, or all zeros. */
size_t fxl_pixels_size(const fxl_pixel_format *format, uint16_t width, uint16_t rows);

/* Converts a band, of palette indices or of RGB565 (band->palette is not null; its colours stay,
 * and the prepared palette is not read), into `size` bytes at `out`, aligned to 4: row after row,
 * without a gap. Bits of a last byte that no pixel has are 0. The dither counts columns from the
 * left of the frame and rows from its top, so the result does not depend on how a frame is cut into
 * bands.
 * FXL_E_ARGUMENT: a null pointer, a band without rows or columns.
 * FXL_E_ORDER: fxl_pixels_init did not prepare the pixels: they are all zeros.
 * FXL_E_ALIGNMENT: out is not aligned, or pixels or palette of a band of RGB565.
 * FXL_E_RANGE: columns beyond the width or the stride; with pages, a first row that is no multiple
 * of 8.
 * FXL_E_CAPACITY: size is less than fxl_pixels_size.
 * With each of these statuses: *out untouched. */
fxl_status fxl_pixels_convert(const fxl_pixels *pixels, const fxl_band *band, void *out,
                              size_t size);

/* Swaps the two bytes of every pixel of a band of RGB565 where it lies: so displays on SPI take it,
 * the byte with red first, from a little-endian core. fxl_pixels_convert copies it so. The band is
 * for sending then, not for drawing on. A second call swaps them back. Exact.
 * Requires a band that is not null and has pixels of RGB565 at an even address. It does not look at
 * band->palette. */
void fxl_swap_rgb565(const fxl_band *band);

/* --- the parts, for a format of your own ------------------------------------------------------ */

/* Writes table[*pixel] for each of count pixels. Runs of one colour take fewer instructions.
 * Requires 2-byte alignment of out. It is fastest where pixels and out are aligned to 4 bytes
 * alike. It is a kernel: each family of cores has its own, and all write the same. */
void fxl_row_to_16(const uint8_t *pixels, uint32_t count, const uint16_t *table, uint16_t *out);

/* Returns the luma, 0..255, of red, green, blue: rounded to nearest, halves upward. */
uint8_t fxl_luma(const uint8_t *colour);

/* Fills the table that fxl_grey_level needs, for each entry of a palette: its luma in 128ths of a
 * level, rounded down, for a display whose highest level is `highest`. Rounding down changes no
 * level. Requires 1 <= highest <= 255. */
void fxl_grey_table(uint16_t *table, const uint8_t *palette, uint32_t highest);

/* Returns the entry that fxl_grey_table would have for a colour of RGB565, whose channels become
 * bytes of which 255 is the largest, rounded to nearest. Requires 1 <= highest <= 255. */
uint16_t fxl_grey_of_rgb565(uint16_t colour, uint32_t highest);

/* Returns the level, 0..highest, of a pixel in column x and row y of the frame. */
uint8_t fxl_grey_level(uint16_t entry, uint32_t x, uint32_t y);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_pixels_reasons[];

#ifdef __cplusplus
}
#endif

#endif
