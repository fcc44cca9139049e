/* SPDX-License-Identifier: MIT */
/* fxl_draw_depth_outline_16 for Armv7-M and Armv8-M Mainline: the text of depth_outline_armv7m.h,
 * for pixels of 16 bits. */
#include "../math/family.h"

#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT

#define PIXEL_BITS 16

    .syntax unified
    .thumb

    .section .text.fxl_draw_depth_outline_16, "ax", %progbits
    .global fxl_draw_depth_outline_16
    .type fxl_draw_depth_outline_16, %function
    .thumb_func

/* r0: points, r1: count, r2: band, r3: outline; returns whether it was drawn. */
fxl_draw_depth_outline_16:
#include "depth_outline_armv7m.h"

    .size fxl_draw_depth_outline_16, . - fxl_draw_depth_outline_16

#include "depth_face_armv7m.h"

    .size fxl_draw_depth_face_16, . - fxl_draw_depth_face_16

#endif
