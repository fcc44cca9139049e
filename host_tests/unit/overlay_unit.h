/* SPDX-License-Identifier: MIT */
/* A band whose neighbours must stay as they are, as palette indices and in RGB565, whose pixels are
 * the colours of the same indices; and the picture that is wanted in it. */
#ifndef OVERLAY_UNIT_H
#define OVERLAY_UNIT_H

#include "unit.h"

enum {
    OVERLAY_WIDTH = 24,
    OVERLAY_STRIDE = 26,
    OVERLAY_HEIGHT = 16,
    OVERLAY_FIRST = 5, /* row of the band */
    OVERLAY_GROUND = 0xEE
};

extern uint8_t overlay_drawn[OVERLAY_HEIGHT][OVERLAY_STRIDE];
extern uint8_t overlay_wanted[OVERLAY_HEIGHT][OVERLAY_STRIDE];
extern uint16_t overlay_drawn_565[OVERLAY_HEIGHT][OVERLAY_STRIDE];
extern const fxl_band overlay_band, overlay_band_565;

/* Two indices have two colours. */
uint16_t overlay_colour_of(uint32_t index);

/* Empties what is drawn. */
void overlay_clear(void);

/* Empties both pictures, and sets the colours. */
void overlay_begin(void);

/* A pixel of the screen in the wanted picture, where the band has it. */
void overlay_want(int64_t x, int64_t y, uint8_t colour);

/* A sprite in the wanted picture, by its definition. */
void overlay_want_sprite(int64_t x, int64_t y, const fxl_sprite *sprite);

/* What is drawn must be what is wanted. */
void overlay_expect_equal(void);

/* The same; then both pictures are empty. */
void overlay_expect_wanted(void);

/* Draws in both formats. */
fxl_status overlay_sprite_at(int32_t x, int32_t y, const fxl_sprite *sprite);
fxl_status overlay_text_at(int32_t x, int32_t y, const char *text, const fxl_text_style *style);

/* A coordinate near the band, or anywhere. */
int32_t overlay_any(void);

#endif
