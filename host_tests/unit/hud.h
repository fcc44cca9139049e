/* SPDX-License-Identifier: MIT */
/* A small display over a picture: a panel with text, a cross, sprites and a bar. test_hud.c draws
 * it on boards, and host_tests/boards/examples/hud.c for docs/hud.png. */
#ifndef HUD_H
#define HUD_H

#include "fixel/overlay.h"

/* The entries of the palette that it uses. */
typedef struct {
    uint8_t panel, line, text, heart, shade;
} hud_colours;

/* Draws it into a band of a screen of this size. The calls are the same for every band. False where
 * one is refused. */
bool hud_draw(const fxl_band *band, int32_t width, int32_t height, const char *score,
              const hud_colours *colours);

#endif
