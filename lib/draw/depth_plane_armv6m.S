/* SPDX-License-Identifier: MIT */
/* fxl_find_depth_plane for Armv6-M. lib/draw/depth_plane.h states what it requires and returns; it
 * gives the same bits as lib/draw/depth_plane.c, which derives the bounds. A product of 32 by 32 bits
 * is made of four products of 16 by 16, and the reciprocal of 16 bits is that of core.h. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV6M && !FXL_IS_COMPACT

#include "../math/reciprocal_armv6m.h"

    .syntax unified
    .thumb

/* On the stack: n, the view, sums along the axes, lower words first; later the focal length, the
 * factor and `one` take the place of sums. Above are r4 to r7, lr, and the plane's address. */
#define NORMAL 0
#define VIEW   12
#define POINT  16
#define SUMS   20
#define FOCAL  20
#define FACTOR 24
#define ONE    28
#define FRAME  44
#define PLANE  (FRAME + 20)

/* r2 and r3 become four products of halves: r0 the lowest, r4 and r5 the middle ones, r3 the highest.
 * Overwrites r2. \shift is asrs or lsrs: whether the factors have signs. */
    .macro  products shift
    uxth    r4, r2
    \shift  r2, r2, #16
    uxth    r5, r3
    \shift  r3, r3, #16
    movs    r0, r4
    muls    r0, r5
    muls    r5, r2
    muls    r4, r3
    muls    r3, r2
    .endm

/* r3:r0 = r2 r3, signed, where both are at most 2^30. Upper halves are then from -2^14 to 2^14 - 1,
 * or 2^14 with a lower half of 0, so the sum of the two middle products is from -2^31 to below 2^31. */
    .macro  multiply_short
    products asrs
    adds    r4, r4, r5
    lsls    r5, r4, #16
    asrs    r4, r4, #16
    adds    r0, r0, r5
    adcs    r3, r3, r4
    .endm

/* The same where |r2| <= 2^30 and 0 <= r3 < 2^31: each middle product is below 2^31. By lsrs, of any
 * factors without a sign. */
    .macro  multiply shift=asrs
    products \shift
    lsls    r2, r5, #16
    \shift  r5, r5, #16
    adds    r0, r0, r2
    adcs    r3, r3, r5
    lsls    r2, r4, #16
    \shift  r4, r4, #16
    adds    r0, r0, r2
    adcs    r3, r3, r4
    .endm

    .macro  accumulate
    adds    r6, r6, r0
    adcs    r7, r7, r3
    .endm

/* A row of axes, at r1, times the normal, into the sum \number. */
    .macro  row number
    ldm     r1!, {r2}
    ldr     r3, [sp, #NORMAL]
    multiply_short
    movs    r6, r0
    movs    r7, r3
    ldm     r1!, {r2}
    ldr     r3, [sp, #NORMAL + 4]
    multiply_short
    accumulate
    ldm     r1!, {r2}
    ldr     r3, [sp, #NORMAL + 8]
    multiply_short
    accumulate
    str     r6, [sp, #SUMS + 8 * \number]
    str     r7, [sp, #SUMS + 8 * \number + 4]
    .endm

/* The sum \number becomes a component of n: shifted to the left by r7, less its lower word, and
 * rounded; then negated. r6: 31 - r7. */
    .macro  component number
    ldr     r0, [sp, #SUMS + 8 * \number]
    ldr     r1, [sp, #SUMS + 8 * \number + 4]
    lsls    r1, r1, r7
    lsrs    r0, r0, r6
    adds    r0, r0, #1
    lsrs    r0, r0, #1
    adds    r1, r1, r0
    rsbs    r1, r1, #0
    str     r1, [sp, #NORMAL + 4 * \number]
    .endm

/* r3:r0 = r2 times the factor, less its 16 lowest bits. */
    .macro  by_factor
    ldr     r3, [sp, #FACTOR]
    multiply
    lsrs    r0, r0, #16
    lsls    r2, r3, #16
    orrs    r0, r0, r2
    asrs    r3, r3, #16
    .endm

/* r7 = one of two digits of 16 bits of the quotient of r0 and r3, whose upper halfword is r6 and
 * whose lower one is r5; what is left stays in r0. r4: the reciprocal of r6. The estimate is off by a
 * few units, so the rest is small and its sign says which way. Overwrites r2. */
    .macro  digit
    lsrs    r7, r0, #16
    muls    r7, r4
    lsrs    r7, r7, #15
    movs    r2, r7
    muls    r2, r6
    subs    r0, r0, r2
1:  cmp     r0, r6
    blo     3f
    bpl     2f
    adds    r0, r0, r6
    subs    r7, r7, #1
    b       1b
2:  subs    r0, r0, r6
    adds    r7, r7, #1
    b       1b
3:  lsls    r0, r0, #16
    movs    r2, r7
    muls    r2, r5
    subs    r0, r0, r2
    bhs     2f
1:  subs    r7, r7, #1
    adds    r0, r0, r3
    bcc     1b
2:
    .endm

    .section .text.fxl_find_depth_plane, "ax", %progbits
    .global fxl_find_depth_plane
    .type fxl_find_depth_plane, %function
    .thumb_func

/* r0: normal, r1: axes, r2: point, r3: view; on the stack: plane */
fxl_find_depth_plane:
    push    {r4-r7, lr}
    sub     sp, sp, #FRAME
    str     r3, [sp, #VIEW]
    str     r2, [sp, #POINT]
    ldm     r0!, {r3-r5}
    mov     r2, sp
    stm     r2!, {r3-r5}
    cmp     r1, #0
    bne     1f
    b       height
1:  row     0
    row     1
    row     2

    asrs    r2, r7, #31             /* upper words, without signs, are below 2^29 */
    eors    r2, r2, r7
    ldr     r3, [sp, #SUMS + 4]
    asrs    r4, r3, #31
    eors    r3, r3, r4
    orrs    r2, r2, r3
    ldr     r3, [sp, #SUMS + 12]
    asrs    r4, r3, #31
    eors    r3, r3, r4
    orrs    r2, r2, r3
    lsls    r2, r2, #3
    movs    r7, #0
1:  adds    r7, r7, #1              /* 1 or 2 of a unit normal; 30 if all are 0 */
    cmp     r7, #30
    beq     2f
    lsls    r2, r2, #1
    bcc     1b
2:  movs    r6, #31
    subs    r6, r6, r7
    component 0
    component 1
    component 2

/* n is at NORMAL. */
height:
    ldr     r1, [sp, #POINT]
    .irp    number, 0, 1, 2
    ldr     r2, [sp, #NORMAL + 4 * \number]
    ldr     r3, [r1, #8 * \number]
    lsrs    r3, r3, #1
    multiply
    .if     \number == 0
    movs    r6, r0
    movs    r7, r3
    .else
    accumulate
    .endif
    .endr
    lsls    r0, r7, #1
    lsrs    r6, r6, #31
    orrs    r6, r6, r0
    asrs    r7, r7, #31
    .irp    number, 0, 1, 2
    ldr     r2, [sp, #NORMAL + 4 * \number]
    ldr     r3, [r1, #8 * \number + 4]
    multiply_short
    accumulate
    .endr
    cmp     r7, #0
    bgt     1f
    bne     2f
    cmp     r6, #0
    beq     2f
    b       low
2:  b       infinity
1:  movs    r2, r7
    normalise r2, r4, r0
    movs    r5, #32
    subs    r5, r5, r4              /* the height's exponent */
    lsrs    r6, r6, r5
    orrs    r2, r2, r6
normal:
    str     r5, [sp, #ONE]
    ldr     r1, [sp, #VIEW]
    movs    r3, r1
    adds    r3, r3, #VIEW_PROJECTION
    ldr     r3, [r3, #PROJECTION_FACTOR]
    lsrs    r3, r3, #2
    str     r3, [sp, #FOCAL]
    multiply lsrs
    movs    r7, r0
    movs    r2, r3
    bne     1f
    b       unscaled
1:  normalise r2, r4, r0
    movs    r5, #32
    subs    r5, r5, r4              /* the divisor's exponent */
    lsrs    r7, r7, r5
    orrs    r2, r2, r7
scaled:
    movs    r3, r2
    ldr     r0, [sp, #ONE]
    adds    r5, r5, r0
    ldr     r2, [r1, #VIEW_NEAR_Z]
    normalise r2, r4, r0
    adds    r5, r5, r4
    str     r5, [sp, #ONE]

    lsrs    r0, r2, #1
    lsrs    r6, r3, #16
    uxth    r5, r3
    reciprocal
    digit
    lsls    r1, r7, #16
    digit
    adds    r1, r1, r7
    adds    r1, r1, #1
    lsrs    r1, r1, #1
    str     r1, [sp, #FACTOR]

    ldr     r1, [sp, #VIEW]
    adds    r1, r1, #VIEW_PROJECTION
    ldr     r2, [sp, #NORMAL + 8]
    ldr     r3, [sp, #FOCAL]
    multiply_short
    movs    r6, r0
    movs    r7, r3
    movs    r3, #1
    lsls    r3, r3, #15
    ldr     r2, [r1, #PROJECTION_CENTRE_X]
    subs    r2, r3, r2
    ldr     r3, [sp, #NORMAL]
    multiply_short
    accumulate
    movs    r3, #1
    lsls    r3, r3, #15
    ldr     r2, [r1, #PROJECTION_CENTRE_Y]
    subs    r2, r2, r3
    ldr     r3, [sp, #NORMAL + 4]
    multiply_short
    accumulate

    movs    r2, r7                  /* by the factor: the upper word, then the lower one */
    ldr     r3, [sp, #FACTOR]
    multiply
    movs    r7, r3
    mov     r12, r0
    movs    r2, r6
    ldr     r3, [sp, #FACTOR]
    multiply lsrs
    mov     r0, r12
    adds    r0, r0, r3
    movs    r3, #0
    adcs    r3, r3, r7
    ldr     r1, [sp, #PLANE]
    stm     r1!, {r0, r3}
    ldr     r2, [sp, #NORMAL]
    by_factor
    stm     r1!, {r0, r3}
    ldr     r2, [sp, #NORMAL + 4]
    rsbs    r2, r2, #0
    by_factor
    ldr     r4, [sp, #ONE]
    stm     r1!, {r0, r3, r4}
    add     sp, sp, #FRAME
    pop     {r4-r7, pc}

    /* The upper word of the height is 0. */
low:
    movs    r2, r6
    normalise r2, r4, r0
    rsbs    r5, r4, #0
    b       normal

    /* The upper word of the divisor is 0: a focal length of 1. The lower one is a mantissa. */
unscaled:
    movs    r2, r7
    movs    r5, #0
    b       scaled

infinity:
    movs    r0, #0
    movs    r2, #0
    movs    r3, #0
    ldr     r1, [sp, #PLANE]
    stm     r1!, {r0, r2, r3}
    stm     r1!, {r0, r2, r3}
    str     r0, [r1]
    add     sp, sp, #FRAME
    pop     {r4-r7, pc}

    .pool
    .size fxl_find_depth_plane, . - fxl_find_depth_plane

#endif
