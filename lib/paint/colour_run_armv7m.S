/* SPDX-License-Identifier: MIT */
/* fxl_paint_colour_run for Armv7-M and Armv8-M Mainline: 8 instructions a pixel, and 2 for each four
 * of them. Compilers take 10. */
#include "../math/family.h"

#if FXL_KERNELS_ARMV7M

    .syntax unified
    .thumb

pixels     .req r1
count      .req r2     /* less 4 */
both       .req r3
green      .req r4
step       .req r5
green_step .req r6
colour     .req r7
channel    .req r12

    .section .text.fxl_paint_colour_run, "ax", %progbits
    .global fxl_paint_colour_run
    .type fxl_paint_colour_run, %function
    .thumb_func

    .macro paint_pixel
    lsrs    colour, green, #26
    lsr     channel, both, #27
    orr     colour, colour, channel, lsl #6
    ubfx    channel, both, #11, #5
    add     both, both, step
    add     green, green, green_step
    orr     colour, channel, colour, lsl #5
    strh    colour, [pixels], #2
    .endm

/* r0: words, r1: pixels, r2: count. */
fxl_paint_colour_run:
    push    {r4-r7}
    ldm     r0, {both, green, step, green_step}
    subs    count, #4
    blo     .Lrest
.Lfour:
    .rept   4
    paint_pixel
    .endr
    subs    count, #4
    bhs     .Lfour
.Lrest:
    adds    count, #4
    beq     .Lend
.Lone:
    paint_pixel
    subs    count, #1
    bne     .Lone
.Lend:
    pop     {r4-r7}
    bx      lr

    .size fxl_paint_colour_run, . - fxl_paint_colour_run

#endif
