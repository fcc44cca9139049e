/* SPDX-License-Identifier: MIT */
/* fxl_fill_trapezoid_rgb565 for Armv6-M: the text of fxl_fill_trapezoid once more, for pixels of 16
 * bits. */
#define FXL_PIXELS_OF_16_BITS 1
#define FILL_TRAPEZOID        fxl_fill_trapezoid_rgb565

    .global fxl_fill_trapezoid_rgb565

#include "fill_rows_armv6m.S"
