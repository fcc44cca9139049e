/* SPDX-License-Identifier: MIT */
/* fxl_paint_colour_run for Armv7-M and Armv8-M Mainline: 8 instructions a pixel, and 2 for each eight
 * of them. Compilers take 10. */
#include "../math/family.h"

#if FXL_KERNELS_ARMV7M

    .syntax unified
    .thumb

pixels     .req r1
count      .req r2     /* then eights */
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

/* r0: words, r1: pixels, r2: count. What is left over eights is painted first. */
fxl_paint_colour_run:
    push    {r4-r7}
    ldm     r0, {both, green, step, green_step}
    adds    count, #7
    and     r0, count, #7
    lsrs    count, #3
    tbb     [pc, r0]
.Lparts:
    .byte   (.Lpixel7 - .Lparts) / 2, (.Lpixel6 - .Lparts) / 2
    .byte   (.Lpixel5 - .Lparts) / 2, (.Lpixel4 - .Lparts) / 2
    .byte   (.Lpixel3 - .Lparts) / 2, (.Lpixel2 - .Lparts) / 2
    .byte   (.Lpixel1 - .Lparts) / 2, (.Lpixel0 - .Lparts) / 2
    .irp    number, 0, 1, 2, 3, 4, 5, 6, 7
.Lpixel\number:
    paint_pixel
    .endr
    subs    count, #1
    bne     .Lpixel0
    pop     {r4-r7}
    bx      lr

    .size fxl_paint_colour_run, . - fxl_paint_colour_run

#endif
