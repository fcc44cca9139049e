/* SPDX-License-Identifier: MIT */
/* fxl_draw_smooth_outline_8 for Armv7-M and Armv8-M Mainline: the text of smooth_outline_armv7m.h,
 * for pixels of 8 bits. */
#include "../math/family.h"

#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT

#define PIXEL_BITS 8

    .syntax unified
    .thumb

    .section .text.fxl_draw_smooth_outline_8, "ax", %progbits
    .global fxl_draw_smooth_outline_8
    .type fxl_draw_smooth_outline_8, %function
    .thumb_func

/* r0: points, r1: count, r2: band, r3: outline; returns whether it was drawn. */
fxl_draw_smooth_outline_8:
#include "smooth_outline_armv7m.h"

    .size fxl_draw_smooth_outline_8, . - fxl_draw_smooth_outline_8

#endif
