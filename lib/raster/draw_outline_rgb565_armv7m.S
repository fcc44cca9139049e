/* SPDX-License-Identifier: MIT */
/* fxl_draw_outline_rgb565 for Armv7-M and Armv8-M Mainline: draw_outline_armv7m.S once more, with
 * places that are half of an address. The result is the same as of draw_outline_rgb565.c. */
#define FXL_PIXELS_OF_16_BITS 1
#define DRAW_OUTLINE         fxl_draw_outline_rgb565
#define DRAW_ROWS_BELOW      fxl_draw_rows_below_rgb565
#define DRAW_BY_ACTIVE_EDGES fxl_draw_by_active_edges_rgb565
#define FILL_ROWS            fxl_fill_rows_rgb565

    .global fxl_draw_outline_rgb565
    .global fxl_draw_rows_below_rgb565

#include "draw_outline_armv7m.S"
