/* SPDX-License-Identifier: MIT */
/* Board contract: where finished pixels go. One display, one frame at a time.
 *
 * Who owns the pixels: the caller lends the buffer to display_flush for the
 * length of the call and has it back when the call returns, to be drawn over
 * at once. A driver that sends in the background copies first, or waits: see
 * panel.h, which is what a display driver implements.
 */
#ifndef BOARD_DISPLAY_H
#define BOARD_DISPLAY_H

#include <stdbool.h>
#include <stdint.h>

/* Makes the display ready for frames of width x height pixels, one byte each,
 * which number an entry of the palette: 256 x red, green, blue.
 * Requires 1 <= width, height <= 1024; journal_open called before; the palette
 * outlives display_close.
 * False where the board cannot show that: the display then stays closed. */
bool display_open(uint16_t width, uint16_t height, const uint8_t *palette);

/* Shows a rectangle of the frame: height rows of width bytes each, without a
 * gap between rows, whose top left is pixel (x, y).
 * Requires an open display, and that the rectangles of a frame go downward,
 * are whole rows (x = 0, width = that of the display) and cover each row once;
 * each frame between journal_begin and journal_end.
 * False where the board could not take all of it, or was asked for anything
 * else: the frame is then lost, and so is the run. */
bool display_flush(uint16_t x, uint16_t y, uint16_t width, uint16_t height, const uint8_t *pixels);

/* Ends the last frame's showing. False where something that was flushed did
 * not arrive, or where fewer frames came than journal_open announced. */
bool display_close(void);

#endif
