/* SPDX-License-Identifier: MIT */
/* Board contract: the destination of finished pixels. One display, one frame at a time.
 *
 * Ownership of the pixels: the caller lends the buffer to display_flush for the length of the
 * call. When the call returns, the caller may draw over it at once. A panel that sends in the
 * background copies the pixels first, or waits: see panel.h. */
#ifndef BOARD_DISPLAY_H
#define BOARD_DISPLAY_H

#include <stdbool.h>
#include <stdint.h>

/* Makes the display ready for frames of width x height pixels. With 8 pixel_bits a pixel is a
 * uint8_t, the number of an entry of the palette: 256 x red, green, blue. With 16 it is a uint16_t,
 * a colour of RGB565 in the byte order of the core.
 * Requires 1 <= width, height <= 1024. The caller must have called journal_open. The palette
 * must stay valid until display_close. Returns false where the board cannot show that; the
 * display then stays closed. */
bool display_open(uint16_t width, uint16_t height, uint8_t pixel_bits, const uint8_t *palette);

/* Shows a rectangle of the frame: height rows of width pixels each, without a gap between rows.
 * Its top left is pixel (x, y).
 * Requires an open display. The rectangles of a frame must go downward, be whole rows (x = 0,
 * width = that of the display) and cover each row once. Each frame must lie between
 * journal_begin and journal_end. Returns false where the board could not take all of it, or the
 * rectangle breaks these rules. The frame is then lost, and so is the run. */
bool display_flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const void *pixels);

/* Closes the display after the last frame. Returns false where something that was flushed did
 * not arrive, or where fewer frames came than journal_open announced. */
bool display_close(void);

#endif
