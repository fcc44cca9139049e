/* SPDX-License-Identifier: MIT */
/* Drawing over the 3-D picture: rectangles, lines, sprites and text, in the pixels of a band.
 *
 * Every function draws at once into the band that it is given, after fxl_frame_draw. Coordinates
 * are whole pixels of the screen: (0, 0) is the top left pixel, x goes right, y goes down. What
 * lies outside of the band is not drawn, so a frame drawn in bands has the same pixels as a frame
 * drawn whole if each band gets the same calls. Colours are entries of the palette, in a band of
 * RGB565 those of band->palette; `palette.reserve` of a scene file keeps entries for the program
 * (docs/scenes.md).
 * docs/extras/overlay.md specifies the pixels. All results are exact. */
#ifndef FXL_OVERLAY_H
#define FXL_OVERLAY_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The largest magnitude of a coordinate of fxl_draw_line, in pixels. */
#define FXL_LINE_COORDINATE_MAX 536870911 /* 2^29 - 1 */

/* A band is wrong if its width is 0 or above FXL_SCREEN_MAX, if its columns are beyond its width or
 * its stride, or if it has no rows. */

/* Fills the pixels x <= column < x + width, y <= row < y + height. Takes any x, y, width and
 * height; a width or height of 0 or less covers nothing.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: the band is wrong.
 * FXL_E_ALIGNMENT: a band of RGB565 with pixels or a palette at an odd address.
 * With each of these statuses: band untouched. */
fxl_status fxl_draw_rectangle(const fxl_band *band, int32_t x, int32_t y, int32_t width,
                              int32_t height, uint8_t colour);

/* Draws the outermost pixels of that rectangle: a border one pixel wide. Takes any x, y, width and
 * height.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: the band is wrong.
 * FXL_E_ALIGNMENT: a band of RGB565 with pixels or a palette at an odd address.
 * With each of these statuses: band untouched. */
fxl_status fxl_draw_border(const fxl_band *band, int32_t x, int32_t y, int32_t width,
                           int32_t height, uint8_t colour);

/* Draws a line from the centre of pixel (x0, y0) to the centre of pixel (x1, y1). A line that is
 * higher than it is wide has one pixel in each row from y0 to y1, both included, in the column
 * floor(x + 1/2), where x is the line's exact place at the centre of the row, counted in pixel
 * centres. Another line has one pixel in each column from x0 to x1, in the row floor(y + 1/2). The
 * line has the same pixels in either direction. Exact.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_RANGE: the band is wrong, or a coordinate is outside +-FXL_LINE_COORDINATE_MAX.
 * FXL_E_ALIGNMENT: a band of RGB565 with pixels or a palette at an odd address.
 * With each of these statuses: band untouched. */
fxl_status fxl_draw_line(const fxl_band *band, int32_t x0, int32_t y0, int32_t x1, int32_t y1,
                         uint8_t colour);

/* The colour key of a sprite all of whose pixels are drawn. */
#define FXL_SPRITE_OPAQUE 256u

/* A small picture. Rows go downward. A row begins at a whole byte and takes
 * (width * bits + 7) / 8 bytes; the leftmost pixel of a byte is in its highest bits. */
typedef struct {
    const uint8_t *pixels;
    const uint8_t *colours; /* 2^bits entries: the colour of each pixel value; null: the value */
    uint16_t width, height; /* pixels; a side of 0 draws nothing */
    uint8_t bits;           /* a pixel: 1, 4 or 8 */
    uint16_t key;           /* the pixel value that is not drawn, or FXL_SPRITE_OPAQUE */
} fxl_sprite;

/* Draws a sprite whose top left pixel is at (x, y). Takes any x and y. The caller owns the record
 * and its tables, which are only read.
 * FXL_E_ARGUMENT: a null pointer, also in the sprite, but for its colours.
 * FXL_E_RANGE: the band is wrong, or the sprite's bits are other than 1, 4 and 8.
 * FXL_E_ALIGNMENT: a band of RGB565 with pixels or a palette at an odd address.
 * With each of these statuses: band untouched. */
fxl_status fxl_draw_sprite(const fxl_band *band, int32_t x, int32_t y, const fxl_sprite *sprite);

/* A character of a font: a picture of 1 bit a pixel, laid out as a sprite's, in which 1 is drawn.
 */
typedef struct {
    uint16_t first_byte;   /* in fxl_font.bits */
    uint8_t width, height; /* pixels of the picture; 0 for a space */
    int8_t left, top;      /* of the picture, from the pen and from the top of the line */
    uint8_t advance;       /* pixels from this character's pen to the next one's */
    uint8_t reserved;      /* 0 */
} fxl_glyph;

/* A font: characters first .. first + count - 1. fixel font makes one of a BDF file. */
typedef struct {
    const uint8_t *bits;
    const fxl_glyph *glyphs; /* count entries */
    uint16_t count;          /* 1..256; first + count <= 256 */
    uint8_t first;
    uint8_t unknown;     /* the character drawn for one that the font does not have */
    uint8_t line_height; /* pixels from the top of a line to the top of the next */
} fxl_font;

/* The built-in font: characters 32..126 of ASCII, 1 to 5 pixels wide, with an advance of one pixel
 * more than the width. Capitals and digits are 7 pixels high; g, j, p, q and y reach 1 or 2 pixels
 * below the baseline. A line is 9 pixels high. */
extern const fxl_font fxl_font_5x7;

/* How text is laid out. */
typedef struct {
    const fxl_font *font;
    uint8_t colour;
    uint8_t cell; /* 0: proportional. Else each character takes so many pixels, and is centred */
} fxl_text_style;

/* Draws text whose top left corner is at (x, y). The text ends at a zero byte; '\n' begins a new
 * line at x. A byte that the font does not have is drawn as the font's `unknown`. Pixels beside the
 * characters are untouched. Takes any x and y.
 * FXL_E_ARGUMENT: a null pointer, also in the style or in the font.
 * FXL_E_RANGE: the band is wrong; or the font has a count of 0, a first + count above 256, or no
 * character `unknown`.
 * FXL_E_ALIGNMENT: a band of RGB565 with pixels or a palette at an odd address.
 * With each of these statuses: band untouched. */
fxl_status fxl_draw_text(const fxl_band *band, int32_t x, int32_t y, const char *text,
                         const fxl_text_style *style);

/* The size of text in pixels. */
typedef struct {
    uint32_t width;  /* the sum of the advances of the longest line */
    uint32_t height; /* lines times the font's line_height */
} fxl_text_size;

/* Measures text as fxl_draw_text lays it out. Requires a text of less than 2^24 bytes.
 * FXL_E_ARGUMENT: a null pointer, also in the style or in the font.
 * FXL_E_RANGE: the font has a count of 0, a first + count above 256, or no character `unknown`.
 * With each of these statuses: *size untouched. */
fxl_status fxl_measure_text(const char *text, const fxl_text_style *style, fxl_text_size *size);

/* What functions of this header refuse: for fxl_explain. */
extern const char fxl_overlay_reasons[];

#ifdef __cplusplus
}
#endif

#endif
