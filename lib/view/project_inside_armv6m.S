/* SPDX-License-Identifier: MIT */
/* fxl_project_inside for Armv6-M: products of 32 bits, no division, no CLZ.
 * lib/view/project.c defines the letters and shows that nothing
 * overflows. The reciprocal of 16 bits is that of core.h. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV6M

#include "../math/reciprocal_armv6m.h"

    .syntax unified
    .thumb

/* Offsets on the stack; above these are r4 to r7 and lr. */
#define HALF        0       /* h + 1 */
#define SCALE       4
#define SHIFT       8       /* n - 3 */
#define PROJECTION  12
#define VIEW        16
#define SCREEN      20

/* Results: r0: floor((P + h) / d), or one less; r1: below 0 as a number with a sign if it is one less. P is
 * estimated: the upper word of F times the lower one of X' is at most 2^13 more than that of its upper bits. So
 * if r1 is below 2^13 without its sign, the estimate does not decide, nor then whether it is below 0.
 * Input: lr: d. Overwrites r0 to r7. */
    .macro  offset side
    ldr     r2, [sp, #VIEW]
    ldr     r6, [r2, #\side]
    ldr     r7, [r2, #\side + 4]
    ldr     r5, [sp, #SHIFT]
    movs    r2, #32                         /* X' = r7:r6 */
    subs    r2, r2, r5
    movs    r4, r6
    lsrs    r4, r4, r2
    lsls    r7, r7, r5
    orrs    r7, r7, r4
    lsls    r6, r6, r5
    ldr     r0, [sp, #PROJECTION]
    ldr     r0, [r0, #PROJECTION_FACTOR]
    ldr     r1, [sp, #HALF]
    lsrs    r4, r0, #12                     /* below 2^16 */
    muls    r0, r7                          /* P + h + 1: F x + h + 1 and the estimate */
    adds    r1, r1, r0
    lsrs    r6, r6, #16
    muls    r4, r6
    lsrs    r4, r4, #4
    adds    r1, r1, r4
    ldr     r0, [sp, #SCALE]                /* x G: |x|, G <= 2^30, so the sum of the middle */
    uxth    r2, r7                          /* products and the lowest product's carry is */
    asrs    r7, r7, #16                     /* below 2^31 */
    uxth    r4, r0
    lsrs    r0, r0, #16
    movs    r3, r2
    muls    r3, r4
    muls    r4, r7
    muls    r2, r0
    muls    r0, r7
    lsrs    r3, r3, #16
    adds    r3, r3, r4
    adds    r3, r3, r2
    asrs    r3, r3, #16
    adds    r0, r0, r3
    mov     r3, lr                          /* d - 1 less the remainder */
    movs    r2, r0
    muls    r2, r3
    subs    r1, r1, r2
    subs    r1, r3, r1
    lsls    r2, r1, #1
    lsrs    r2, r2, #14
    beq     undecided
    .endm

/* fxl_divide_half: r0 = floor(r0 / r6), r2 = the remainder. Input: r0 < 2^31, r6: D,
 * r4: the reciprocal of D. Overwrites r7. */
    .macro  divide_half
    movs    r2, r0
    lsrs    r0, r0, #16
    muls    r0, r4
    lsrs    r0, r0, #15
    movs    r7, r0
    muls    r7, r6
    subs    r2, r2, r7
1:  cmp     r2, r6
    blo     3f
    bpl     2f
    adds    r2, r2, r6                      /* below 0: the estimate was too large */
    subs    r0, r0, #1
    b       1b
2:  subs    r2, r2, r6
    adds    r0, r0, #1
    b       1b
3:
    .endm

    .section .text.fxl_project_inside, "ax", %progbits

/* Before the function, so that a short branch reaches it. */
slow_path:
    bl      fxl_project_any
    add     sp, sp, #24
    pop     {r4-r7, pc}

    .global fxl_project_inside
    .type fxl_project_inside, %function
    .thumb_func

fxl_project_inside:
    push    {r0-r2, r4-r7, lr}
    sub     sp, sp, #12
    ldr     r3, [r1, #VIEW_POINT_Z + 4]
    ldr     r4, [r0, #PROJECTION_DEPTH_MIN]
    cmp     r3, r4
    blt     slow_path

    normalise r3, r5, r6                    /* n */
    ldr     r6, [r1, #VIEW_POINT_Z]
    movs    r7, #32
    subs    r7, r7, r5
    lsrs    r6, r6, r7
    orrs    r3, r3, r6
    lsrs    r3, r3, #1                      /* the bit shifted out rounds */
    movs    r6, #0
    adcs    r3, r3, r6
    mov     lr, r3                          /* d */
    subs    r5, r5, #3
    str     r5, [sp, #SHIFT]
    lsrs    r5, r3, #1
    adds    r5, r5, #1
    str     r5, [sp, #HALF]

    lsrs    r6, r3, #15                     /* D */
    reciprocal

    ldr     r1, [r0, #PROJECTION_FACTOR_17]
    ldr     r0, [r0, #PROJECTION_FACTOR_2]
    divide_half
    movs    r2, r0
    muls    r2, r3
    subs    r1, r1, r2                      /* the rest, of either sign */
    lsls    r5, r0, #15
    asrs    r3, r1, #31
    eors    r1, r1, r3
    subs    r0, r1, r3
    divide_half
    eors    r0, r0, r3
    subs    r0, r0, r3
    adds    r5, r5, r0
    str     r5, [sp, #SCALE]

    offset  VIEW_POINT_X
    ldr     r2, [sp, #PROJECTION]
    ldr     r2, [r2, #PROJECTION_CENTRE_X]
    lsls    r1, r1, #1                      /* carry: one less */
    adcs    r0, r0, r2
    ldr     r2, [sp, #SCREEN]
    str     r0, [r2]
    offset  VIEW_POINT_Y
    mvns    r1, r1
    ldr     r2, [sp, #PROJECTION]
    ldr     r4, [r2, #PROJECTION_CENTRE_Y]
    lsls    r1, r1, #1                      /* no carry: one less */
    sbcs    r4, r4, r0
    ldr     r2, [sp, #SCREEN]
    str     r4, [r2, #SCREEN_POINT_Y]
    movs    r0, #0                          /* FXL_OK */
    add     sp, sp, #24
    pop     {r4-r7, pc}

undecided:
    add     r3, sp, #PROJECTION
    ldm     r3!, {r0-r2}
    b       slow_path

    .pool
    .size fxl_project_inside, . - fxl_project_inside

/* fxl_reciprocals of core.h, for other kernels too. */
    .section .rodata.fxl_reciprocals_armv6m, "a", %progbits
    .global fxl_reciprocals_armv6m
    .hidden fxl_reciprocals_armv6m
fxl_reciprocals_armv6m:
    .byte   254, 250, 246, 243, 239, 236, 232, 229, 226, 223, 220, 217, 214, 211, 209, 206
    .byte   204, 201, 199, 196, 194, 192, 189, 187, 185, 183, 181, 179, 177, 175, 173, 172
    .byte   170, 168, 166, 165, 163, 161, 160, 158, 157, 155, 154, 152, 151, 150, 148, 147
    .byte   146, 144, 143, 142, 141, 139, 138, 137, 136, 135, 134, 133, 132, 131, 130, 129
    .byte   128

#endif
