/* SPDX-License-Identifier: MIT */
/* fxl_project_seen for Armv7-M and Armv8-M Mainline: UMULL, UDIV, CLZ. The
 * numbers' names, and why nothing overflows, stand in
 * lib/kernels/portable/project_seen.c.
 *
 * Sides are shifted by multiplication, which takes two instructions for 64 bits.
 * What decides the rounding is left in the carry and added with the centre. */

    .syntax unified
    .thumb

/* fxl_view_point; fxl_projection, which begins with factor, depth_min,
 * factor_2, factor_17: project.c holds them against the structures. */
#define X       0
#define Y       8
#define Z       16
#define CENTRES 16

projection  .req r0
view        .req r1     /* later whatever comes along */
screen      .req r2
factor      .req r3     /* F */
factor_2    .req r12    /* 4 F */
factor_17   .req lr     /* 2^17 F, without what wraps; later whatever comes along */
depth       .req r4     /* d; before it the lower word of Z */
scale       .req r5     /* G; before it the upper word of Z */
power       .req r10    /* 2^n, then 2^(n - 3); before it the least upper word of Z */
half        .req r11    /* h; before it whatever comes along */

    .section .text.fxl_project_seen, "ax", %progbits
    .global fxl_project_seen
    .type fxl_project_seen, %function
    .thumb_func

fxl_project_seen:
    push    {r4-r11, lr}
    ldrd    r4, r5, [view, #Z]
    ldm     projection, {r3, r10, r12, lr}
    ldrd    r6, r7, [view, #X]
    ldrd    r8, r9, [view, #Y]
    cmp     r5, r10
    blt     long_way
    eor     r10, r7, r7, asr #31
    eor     r11, r9, r9, asr #31
    orr     r10, r10, r11
    cmp     r10, r5, lsl #1
    bhs     long_way

    clz     r11, r5
    mov     power, #1
    lsl     power, power, r11
    umull   r11, r1, r4, power              /* the upper word of Z 2^n */
    mla     r5, r5, power, r1
    lsr     power, power, #3
    lsrs    depth, r5, #1                   /* the bit that falls out rounds */
    adc     depth, depth, #0

    lsr     r5, depth, #15                  /* D */
    udiv    r11, factor_2, r5
    mls     lr, r11, depth, factor_17
    sdiv    lr, lr, r5
    add     scale, lr, r11, lsl #15
    lsr     half, depth, #1

    umull   r6, lr, r6, power               /* X' = r7:r6 */
    mla     r7, r7, power, lr
    umull   r6, lr, r6, factor              /* P + h */
    add     lr, lr, half
    mla     lr, r7, factor, lr
    smull   r6, r7, scale, r7               /* the quotient, or one less */
    mls     lr, r7, depth, lr
    cmp     lr, depth                       /* carry: one less */
    ldrd    r1, r6, [projection, #CENTRES]
    adc     r7, r7, r1

    umull   r8, lr, r8, power
    mla     r9, r9, power, lr
    umull   r8, lr, r8, factor
    add     lr, lr, half
    mla     lr, r9, factor, lr
    smull   r8, r9, scale, r9
    mls     lr, r9, depth, lr
    sub     depth, depth, #1
    cmp     depth, lr                       /* no carry: one less */
    sbc     r6, r6, r9
    strd    r7, r6, [screen]
    movs    r0, #0                          /* FXL_OK */
    pop     {r4-r11, pc}

long_way:
    pop     {r4-r11, lr}
    b.w     fxl_project_any

    .size fxl_project_seen, . - fxl_project_seen
