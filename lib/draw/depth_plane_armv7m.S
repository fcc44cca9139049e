/* SPDX-License-Identifier: MIT */
/* fxl_find_depth_plane for Armv7-M and Armv8-M Mainline. lib/draw/depth_plane.h states what it
 * requires and returns; it gives the same bits as lib/draw/depth_plane.c, which derives the
 * bounds. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV7M

    .syntax unified
    .thumb

#define PLANE 36 /* on the stack */

/* \high:\low becomes a component of n, in \high: shifted to the left by r7, less its lower word, and
 * rounded; then negated. r8: 31 - r7. */
    .macro component low, high
    lsls    \high, \high, r7
    lsrs    \low, \low, r8
    adds    \low, \low, #1
    add     \high, \high, \low, lsr #1
    rsb     \high, \high, #0
    .endm

/* One of two digits of 16 bits of the quotient of \left and r2, whose upper halfword is r12 and
 * whose lower one is r10; what is left stays in \left. Overwrites r4. */
    .macro digit quotient, left
    udiv    \quotient, \left, r12
    mls     \left, \quotient, r12, \left
    mul     r4, \quotient, r10
    lsl     \left, \left, #16
    subs    \left, \left, r4
    bhs     1f
2:
    sub     \quotient, \quotient, #1
    adds    \left, \left, r2
    bcc     2b
1:
    .endm

    .section .text.fxl_find_depth_plane, "ax", %progbits
    .global fxl_find_depth_plane
    .type fxl_find_depth_plane, %function
    .thumb_func

/* r0: normal, r1: axes, r2: first, r3: view; on the stack: plane */
fxl_find_depth_plane:
    push    {r4-r11, lr}
    ldm     r0, {r4-r6}
    cmp     r1, #0
    beq     .Lin_the_view
    ldm     r1!, {r7-r9}
    smull   r10, r11, r4, r7
    smlal   r10, r11, r5, r8
    smlal   r10, r11, r6, r9
    ldm     r1!, {r7-r9}
    smull   r12, lr, r4, r7
    smlal   r12, lr, r5, r8
    smlal   r12, lr, r6, r9
    ldm     r1, {r7-r9}
    smull   r0, r1, r4, r7
    smlal   r0, r1, r5, r8
    smlal   r0, r1, r6, r9

    eor     r7, r11, r11, asr #31
    eor     r8, lr, lr, asr #31
    orrs    r7, r7, r8
    eor     r8, r1, r1, asr #31
    orrs    r7, r7, r8
    clz     r7, r7
    subs    r7, r7, #2
    rsb     r8, r7, #31
    component r10, r11
    component r12, lr
    component r0, r1

/* r11, lr, r1: n. */
.Lheight:
    ldm     r2, {r4-r9}
    lsrs    r4, r4, #1
    lsrs    r6, r6, #1
    lsr     r8, r8, #1
    smull   r10, r12, r11, r4
    smlal   r10, r12, lr, r6
    smlal   r10, r12, r1, r8
    smull   r0, r2, r11, r5
    smlal   r0, r2, lr, r7
    smlal   r0, r2, r1, r9
    lsl     r4, r12, #1
    orr     r4, r4, r10, lsr #31
    adds    r0, r0, r4
    adcs    r2, r2, r12, asr #31
    bmi     .Linfinity
    beq     .Llow

    clz     r4, r2
    rsb     r5, r4, #32             /* the height's exponent */
    lsls    r2, r2, r4
    lsrs    r0, r0, r5
    orrs    r2, r2, r0
.Lnormal:
    ldr     r6, [r3, #VIEW_PROJECTION + PROJECTION_FACTOR]
    lsrs    r6, r6, #2              /* focal */
    umull   r0, r2, r2, r6
    clz     r4, r2
    rsb     r8, r4, #32             /* the divisor's exponent */
    lsls    r2, r2, r4
    lsr     r0, r0, r8
    orrs    r2, r2, r0
    ldr     r0, [r3, #VIEW_NEAR_Z]
    add     r5, r5, r8
    clz     r4, r0
    lsls    r0, r0, r4
    lsrs    r0, r0, #1
    add     r5, r5, r4              /* one */
    lsr     r12, r2, #16
    uxth    r10, r2
    digit   r7, r0
    digit   r8, r0
    orr     r7, r8, r7, lsl #16
    adds    r7, r7, #1
    lsrs    r7, r7, #1              /* the factor */

    add     r3, r3, #VIEW_PROJECTION
    ldrd    r4, r8, [r3, #PROJECTION_CENTRE_X]
    rsb     r4, r4, #32768
    sub     r8, r8, #32768
    smull   r9, r10, r1, r6
    smlal   r9, r10, r11, r4
    smlal   r9, r10, lr, r8
    ldr     r0, [sp, #PLANE]
    umull   r4, r8, r9, r7
    movs    r9, #0
    smlal   r8, r9, r10, r7
    rsb     lr, lr, #0
    smull   r10, r11, r11, r7
    smull   r12, lr, lr, r7
    lsr     r10, r10, #16
    orr     r10, r10, r11, lsl #16
    asr     r11, r11, #16
    lsr     r12, r12, #16
    orr     r12, r12, lr, lsl #16
    asr     lr, lr, #16
    strd    r8, r9, [r0]
    strd    r10, r11, [r0, #8]
    strd    r12, lr, [r0, #16]
    str     r5, [r0, #DEPTH_PLANE_ONE]
    pop     {r4-r11, pc}

.Lin_the_view:
    mov     r11, r4
    mov     lr, r5
    mov     r1, r6
    b       .Lheight

    /* The upper word of the height is 0. */
.Llow:
    cbz     r0, .Linfinity
    clz     r4, r0
    lsl     r2, r0, r4
    rsb     r5, r4, #0
    b       .Lnormal

.Linfinity:
    ldr     r0, [sp, #PLANE]
    movs    r1, #0
    strd    r1, r1, [r0]
    strd    r1, r1, [r0, #8]
    strd    r1, r1, [r0, #16]
    str     r1, [r0, #DEPTH_PLANE_ONE]
    pop     {r4-r11, pc}

    .size fxl_find_depth_plane, . - fxl_find_depth_plane

#endif
