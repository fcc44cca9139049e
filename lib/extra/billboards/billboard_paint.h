/* SPDX-License-Identifier: MIT */
/* The pixels of a billboard. Internal. */
#ifndef FXL_BILLBOARD_PAINT_H
#define FXL_BILLBOARD_PAINT_H

#include "fixel/extra/overlay.h"

/* Draws a sprite, stretched over left <= x < right, top <= y < bottom, into a band. A pixel whose
 * centre lies there shows the texel in which its centre falls: column
 * floor((x - left) * sprite->width / (right - left)), row likewise. Exact. Requires a sprite that
 * was checked, and corners within FXL_SCREEN_COORDINATE_MAX, left <= right and top <= bottom. */
void fxl_billboard_paint(const fxl_sprite *sprite, const fxl_screen_point *left_top,
                         const fxl_screen_point *right_bottom, const fxl_band *band);

#endif
