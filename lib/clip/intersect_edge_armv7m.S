/* SPDX-License-Identifier: MIT */
/* fxl_intersect_edge for Armv7-M and Armv8-M Mainline. The arithmetic, with its bounds, is that of
 * lib/clip/intersection.c and of fxl_fraction in lib/math/arith.c. An edge
 * takes 125 to 145 instructions here, and 190 as the compiler has it. */
#include "../math/family.h"

#if FXL_INTERSECTS_IN_ASSEMBLY


    .syntax unified
    .thumb

from        .req r0
to          .req r1
point       .req r2
rest        .req r4     /* inside; later what is left of it. In the end the fraction */
rest_high   .req r5
whole       .req r6     /* inside - outside */
whole_high  .req r7
reciprocal  .req r9
fraction        .req r4
fraction_high   .req r5

    .section .text.fxl_intersect_edge, "ax", %progbits
    .global fxl_intersect_edge
    .type fxl_intersect_edge, %function
    .thumb_func

/* r0: from, r1: to, r2: inside, r3: outside, on the stack: point */
fxl_intersect_edge:
    push    {r4-r11, lr}
    ldrd    rest, rest_high, [r2]
    ldrd    whole, whole_high, [r3]
    ldr     point, [sp, #36]
    subs    whole, rest, whole
    sbcs    whole_high, rest_high, whole_high
    beq     .Lshort
    clz     r8, whole_high
    rsb     r10, r8, #33
    sub     r8, r8, #1              /* shift; r10: 32 - shift */
    lsl     whole_high, whole_high, r8
    lsr     r11, whole, r10
    orr     whole_high, whole_high, r11
    lsl     whole, whole, r8
    lsl     rest_high, rest_high, r8
    lsr     r11, rest, r10
    orr     rest_high, rest_high, r11
    lsl     rest, rest, r8

    lsr     r10, whole_high, #15    /* reciprocal_below(whole_high + 1) */
    add     r10, r10, #1
    mvn     r11, #0x80000000
    udiv    reciprocal, r11, r10
    mul     r10, reciprocal, reciprocal
    add     r11, whole_high, #1
    umull   r11, r10, r10, r11
    rsb     reciprocal, r10, reciprocal, lsl #15
    sub     reciprocal, reciprocal, #2

/* fraction_digit(&rest, whole, reciprocal, \bits), before its correction */
    .macro  estimate_digit digit, bits
    lsl     r12, rest_high, #1
    orr     r12, r12, rest, lsr #31
    umull   r12, \digit, r12, reciprocal
    lsr     \digit, \digit, #(29 - \bits)
    lsl     rest_high, rest_high, #\bits
    orr     rest_high, rest_high, rest, lsr #(32 - \bits)
    lsl     rest, rest, #\bits
    umull   r12, lr, \digit, whole
    subs    rest, rest, r12
    sbc     rest_high, rest_high, lr
    mls     rest_high, \digit, whole_high, rest_high
    cmp     rest, whole
    sbcs    r12, rest_high, whole_high
    .endm

    estimate_digit r8, 22
    bcs     .Lupper_is_more
.Lmiddle:
    estimate_digit r10, 21
    bcs     .Lmiddle_is_more
.Llower:
    estimate_digit r11, 21
    it      cs
    addcs   r11, r11, #1
    orr     fraction, r11, r10, lsl #21
    lsr     fraction_high, r10, #11
    orr     fraction_high, fraction_high, r8, lsl #10

.Linterpolate:
/* \high, \low: floor(r9, r8 times the fraction / 2^64) */
    .macro  multiply_high low, high
    umull   r10, r11, r8, fraction
    mov     \low, #0
    umlal   r11, \low, r9, fraction
    mov     r12, #0
    umlal   r11, r12, r8, fraction_high
    mov     \high, #0
    umlal   \low, \high, r9, fraction_high
    adds    \low, \low, r12
    adc     \high, \high, #0
    .endm

    .irp    axis, x, y, z
    ldrd    r6, r7, [from], #8
    ldrd    r8, r9, [to], #8
    subs    r8, r8, r6
    sbcs    r9, r9, r7
    bmi     .Lbackward_\axis
    multiply_high r10, lr
    adds    r6, r6, r10
    adc     r7, r7, lr
.Linterpolated_\axis:
    strd    r6, r7, [point], #8
    .endr
    pop     {r4-r11, pc}

    .irp    axis, x, y, z
.Lbackward_\axis:
    negs    r8, r8
    sbc     r9, r9, r9, lsl #1
    multiply_high r10, lr
    subs    r6, r6, r10
    sbc     r7, r7, lr
    b       .Linterpolated_\axis
    .endr

.Lupper_is_more:
    subs    rest, rest, whole
    sbc     rest_high, rest_high, whole_high
    add     r8, r8, #1
    b       .Lmiddle

.Lmiddle_is_more:
    subs    rest, rest, whole
    sbc     rest_high, rest_high, whole_high
    add     r10, r10, #1
    b       .Llower

    /* The whole is below 2^32. */
.Lshort:
    sub     sp, sp, #4              /* aligned for the call */
    mov     r8, from
    mov     r9, to
    mov     r10, point
    mov     r0, rest
    mov     r1, rest_high
    mov     r2, whole
    mov     r3, whole_high
    bl      fxl_fraction
    add     sp, sp, #4
    mov     fraction, r0
    mov     fraction_high, r1
    mov     from, r8
    mov     to, r9
    mov     point, r10
    b       .Linterpolate

    .size fxl_intersect_edge, . - fxl_intersect_edge

#endif
