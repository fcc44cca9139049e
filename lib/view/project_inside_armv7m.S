/* SPDX-License-Identifier: MIT */
/* fxl_project_inside for Armv7-M and Armv8-M Mainline: UMULL, UDIV, CLZ.
 * lib/view/project.c defines the letters and shows that nothing overflows.
 *
 * Sides are shifted by multiplication, which takes two instructions for 64 bits. Their product
 * with F is accumulated onto half the depth. The comparison that decides the rounding leaves
 * its result in the carry, which is added together with the centre. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV7M


    .syntax unified
    .thumb

projection  .req r0
view        .req r1     /* later 2^n, then 2^(n - 3) */
power       .req r1
screen      .req r2
factor      .req r3     /* F */
depth       .req r9     /* d; before it, the upper word of Z */
upper       .req r10    /* the least upper word of Z; later the upper word of a product */
factor_1    .req r11    /* F - 1: UMLAL adds a lower word to its product with F - 1 */
factor_2    .req r12    /* 4 F */
scale       .req r12    /* G */
factor_17   .req lr     /* 2^17 F, modulo 2^32; later P + h */

    .section .text.fxl_project_inside, "ax", %progbits
    .global fxl_project_inside
    .type fxl_project_inside, %function
    .thumb_func

/* For fxl_clip_by_view r1 and r3 return x and y, and r2 is kept. */
fxl_project_inside:
    push    {r4-r11, lr}
    ldm     view, {r4-r9}
    b       fxl_project_inside_loaded       /* seen by what adds up the stack */
    .size fxl_project_inside, . - fxl_project_inside

    /* Here with r4-r11 and lr on the stack, and the point in r4-r9: fxl_transform_and_project. */
    .global fxl_project_inside_loaded
    .hidden fxl_project_inside_loaded
    .type fxl_project_inside_loaded, %function
    .thumb_func
fxl_project_inside_loaded:
    ldm     projection, {r3, r10, r11, r12, lr}
    cmp     r9, r10
    blt     slow_path

    clz     r10, r9
    mov     power, #1
    lsl     power, power, r10
    umull   r8, upper, r8, power            /* the upper word of Z 2^n */
    mla     r9, r9, power, upper
    lsr     power, power, #3
    lsrs    depth, r9, #1                   /* the bit shifted out rounds */
    adc     depth, depth, #0

    lsr     r8, depth, #15                  /* D */
    udiv    r10, factor_2, r8
    mls     lr, r10, depth, factor_17
    sdiv    lr, lr, r8
    add     scale, lr, r10, lsl #15

    umull   r4, upper, r4, power            /* X' = r5:r4 */
    mla     r5, r5, power, upper
    lsr     lr, depth, #1                   /* h */
    umlal   r4, lr, r4, factor_1
    mla     lr, r5, factor, lr
    smull   r4, r5, scale, r5               /* the quotient, or one less */
    mls     lr, r5, depth, lr
    cmp     lr, depth                       /* carry: one less */
    ldrd    r4, r8, [projection, #PROJECTION_CENTRE_X]
    adc     r5, r5, r4

    umull   r6, upper, r6, power
    mla     r7, r7, power, upper
    lsr     lr, depth, #1
    umlal   r6, lr, r6, factor_1
    mla     lr, r7, factor, lr
    smull   r6, r7, scale, r7
    mls     lr, r7, depth, lr
    sub     depth, depth, #1
    cmp     depth, lr                       /* no carry: one less */
    sbc     r3, r8, r7
    strd    r5, r3, [screen]
    mov     r1, r5
    movs    r0, #0                          /* FXL_OK */
    pop     {r4-r11, pc}

slow_path:
    mov     r4, screen
    sub     sp, sp, #4                      /* a call wants a multiple of 8 */
    bl      fxl_project_any
    add     sp, sp, #4
    cmp     r0, #0
    mov     screen, r4
    ldrd    r1, r3, [screen]
    pop     {r4-r11, pc}

    .size fxl_project_inside_loaded, . - fxl_project_inside_loaded

#endif
