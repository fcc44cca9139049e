/* SPDX-License-Identifier: MIT */
/* Colours on a display of few greys (docs/formats.md, section 4): luma, and an ordered dither of
 * 8 x 8 pixels. Integers only, no state: a pixel's level depends only on its colour and its
 * position in the frame. */
#ifndef BOARD_GREY_H
#define BOARD_GREY_H

#include <stdint.h>

/* Returns the luma, 0..255, of red, green, blue. */
uint8_t grey_luma(const uint8_t *colour);

/* Fills the table that grey_level needs, for each entry of a palette (256 x red, green, blue):
 * its luma in 128ths of a level, for a display whose highest level is `highest`.
 * Requires 1 <= highest <= 255. */
void grey_table(uint16_t *table, const uint8_t *palette, uint32_t highest);

/* Returns the level, 0..highest, of a pixel in column x and row y of the frame. */
uint8_t grey_level(uint16_t entry, uint32_t x, uint32_t y);

#endif
