/* SPDX-License-Identifier: MIT */
/* fxl_row_to_16 for Armv7-M and Armv8-M Mainline. lib/include/fixel/pixels.h states what it
 * requires and does. Pixels are loaded 16 at a time. If all 16 have one colour, they take 14
 * instructions; others take 49. Noise of 320 pixels a row takes 3.1 instructions a pixel. */
#include "../math/family.h"

#if FXL_KERNELS_ARMV7M


    .syntax unified
    .thumb

pixels  .req r0
count   .req r1     /* pixels still to be converted, less 16 */
table   .req r2
out     .req r3
run     .req r8     /* the pixel of the last run, in each of four bytes */
first   .req r12
last    .req lr

    .section .text.fxl_row_to_16, "ax", %progbits
    .global fxl_row_to_16
    .type fxl_row_to_16, %function
    .thumb_func

/* r0: pixels, r1: count, r2: table, r3: out */
fxl_row_to_16:
    push    {r4-r11, lr}
    subs    count, count, #16
    blo     .Lrest
.Lhead:
    tst     pixels, #3
    beq     .Laligned
    ldrb    r4, [pixels], #1
    ldrh    r4, [table, r4, lsl #1]
    strh    r4, [out], #2
    subs    count, count, #1
    bhs     .Lhead
    b       .Lrest
.Laligned:
    tst     out, #3
    bne     .Lrest
    mov     run, #1                     /* no run has this word */

.Lblock:
    ldm     pixels!, {r4-r7}
    cmp     r4, r4, ror #8
    bne     .Lmixed
    cmp     r4, run
    bne     .Lnew_run
.Lcompare:
    cmp     r5, r4
    itt     eq
    cmpeq   r6, r4
    cmpeq   r7, r4
    bne     .Lmixed
    stm     out!, {r9-r11}
    stm     out!, {r9-r11}
    strd    r9, r10, [out], #8
    subs    count, count, #16
    bhs     .Lblock

    /* Fewer than 16 pixels; all of them where pixels and out are not aligned alike. */
.Lrest:
    adds    count, count, #16
    beq     .Lend
.Lpixel:
    ldrb    r4, [pixels], #1
    ldrh    r4, [table, r4, lsl #1]
    strh    r4, [out], #2
    subs    count, count, #1
    bne     .Lpixel
.Lend:
    pop     {r4-r11, pc}

    /* r9 to r11: the run's colour, twice in each. */
.Lnew_run:
    mov     run, r4
    uxtb    r9, r4
    ldrh    r9, [table, r9, lsl #1]
    orr     r9, r9, r9, lsl #16
    mov     r10, r9
    mov     r11, r9
    b       .Lcompare

.Lmixed:
    .irp    word, r4, r5, r6, r7
    uxtb    first, \word
    uxtb    last, \word, ror #8
    ldrh    first, [table, first, lsl #1]
    ldrh    last, [table, last, lsl #1]
    orr     first, first, last, lsl #16
    uxtb    last, \word, ror #16
    lsrs    \word, \word, #24
    ldrh    last, [table, last, lsl #1]
    ldrh    \word, [table, \word, lsl #1]
    orr     last, last, \word, lsl #16
    strd    first, last, [out], #8
    .endr
    subs    count, count, #16
    bhs     .Lblock
    b       .Lrest

    .size fxl_row_to_16, . - fxl_row_to_16

#endif
