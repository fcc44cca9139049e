/* SPDX-License-Identifier: MIT */
/* Part of plain_rows_armv6m.S: what follows the pixels of a segment, which is the weight at the end of the
 * next one, and U and V there by its reciprocal. Assembly. */
#ifndef FXL_PLAIN_WEIGHTS_ARMV6M_H
#define FXL_PLAIN_WEIGHTS_ARMV6M_H

/* clang-format off */

/* The zeros of another weight, r1, and the shifts. Any number that is not 0 ends up with its highest bit set. */
.Lnormalise:
    movs    r0, r1
    movs    r2, #0
    lsrs    r3, r0, #16
    bne     1f
    adds    r2, #16
    lsls    r0, r0, #16
1:  lsrs    r3, r0, #24
    bne     1f
    adds    r2, #8
    lsls    r0, r0, #8
1:  lsrs    r3, r0, #28
    bne     1f
    adds    r2, #4
    lsls    r0, r0, #4
1:  lsrs    r3, r0, #30
    bne     1f
    adds    r2, #2
    lsls    r0, r0, #2
1:  cmp     r0, #0
    bmi     1f
    adds    r2, #1
    lsls    r0, r0, #1
1:  mov     r8, r2
    ldr     r3, [sp, #F_U_DROP]
    subs    r3, r3, r2
    str     r3, [sp, #F_U_SHIFT]
    ldr     r4, [sp, #F_V_DROP]
    subs    r4, r4, r2
    str     r4, [sp, #F_V_SHIFT]
    ldr     r5, =.Lnear
    orrs    r3, r4
    bpl     1f
    ldr     r5, =.Lfar
1:  mov     r11, r5
    b       .Lreciprocal

/* What follows the pixels of a segment: r2 is F_PIXELS, or in the run's last part F_LAST. */
    .macro  after next, part
    ldr     r3, [sp, #F_WIDTH]
    adds    r2, r2, r3
    str     r2, [sp, #F_PIXELS]
    ldr     r3, [sp, #F_LAST]
    cmp     r2, r3
    bls     \next
    ldr     r3, [sp, #F_STOP]
    cmp     r2, r3
    blo     1f
    ldr     r3, [sp, #F_DONE]
    mov     pc, r3
    .align  2
1:  ldr     r3, =\part
    mov     r12, r3
    .endm

    .align  2
.Lafter:
    after   .Lnext, .Lpart

/* The end of the next segment. */
.Lnext:
    mov     r6, sp
    add     r7, sp, #F_W_STEP
    ldmia   r6!, {r0-r3}
    ldmia   r7!, {r4, r5}
    adds    r0, r0, r4
    adcs    r1, r5
    ldmia   r7!, {r4, r5}
    adds    r2, r2, r4
    adcs    r3, r5
    subs    r6, #16
    stmia   r6!, {r0-r3}
    ldmia   r6!, {r2, r3}
    ldmia   r7!, {r4, r5}
    adds    r2, r2, r4
    adcs    r3, r5
    subs    r6, #8
    stmia   r6!, {r2, r3}

/* r1: the weight. Mostly it has as many leading zeros as the one before. Its lowest bit counts as set. */
.Ldivide:
    mov     r2, r8
    movs    r3, #1
    orrs    r1, r3
    movs    r0, r1
    lsls    r0, r2
    bpl     .Lnormalise
    movs    r3, r0
    lsrs    r3, r2
    cmp     r3, r1
    bne     .Lnormalise

/* r0: the weight, in 32 bits. */
.Lreciprocal:
    lsrs    r1, r0, #16                 /* d, from 2^15 on */
    lsrs    r2, r0, #24
    lsls    r2, r2, #1
    mov     r3, r9
    ldrh    r2, [r3, r2]                /* 2^31 / d, relatively within 2^-8: Newton's step squares that */
    uxth    r0, r0
    movs    r3, r2
    muls    r3, r1
    mov     r4, r10
    subs    r3, r4, r3                  /* below 2^23 */
    asrs    r3, r3, #8
    muls    r3, r2                      /* below 2^31 */
    asrs    r3, r3, #23
    adds    r2, r2, r3                  /* the quotient of 2^31 - 1, or 1 less: every d was tried */
    movs    r3, r2
    muls    r3, r1
    subs    r3, r4, r3
    cmp     r3, r1
    bls     1f
    adds    r2, #1
    subs    r3, r3, r1
/* Of e = r2, its square times the weight is e (2^47 - 2^16 r3 + e r0): so the reciprocal,
 * 2^16 e - e^2 weight / 2^32, is 2^15 e - (e^2 r0 / 2^16 - e r3) / 2^16, rounded up. Both products fit
 * 32 bits, and their difference 33. */
1:  muls    r0, r2
    uxth    r4, r0
    lsrs    r0, r0, #16
    muls    r4, r2
    lsrs    r4, r4, #16
    muls    r0, r2
    adds    r0, r0, r4
    muls    r3, r2
    subs    r0, r0, r3
    sbcs    r3, r3
    lsls    r3, r3, #16
    lsrs    r0, r0, #16
    orrs    r0, r3
    lsls    r2, r2, #15
    subs    r2, r2, r0
    uxth    r3, r2
    lsrs    r2, r2, #16
    mov     pc, r11

/* r0 = the upper word of r0, signed, times the reciprocal, whose halves are r2 and r3. The reciprocal
 * is below 2^31: sums of a product of halves and 2^16 fit 32 bits. */
    .macro  multiply keep
    uxth    r4, r0
    asrs    r0, r0, #16
    movs    r5, r4
    muls    r5, r3
    .if     \keep
    uxth    r7, r5
    .endif
    lsrs    r5, r5, #16
    movs    r6, r0
    muls    r6, r3
    adds    r5, r5, r6
    uxth    r6, r5
    asrs    r5, r5, #16
    muls    r4, r2
    adds    r4, r4, r6
    .if     \keep
    lsls    r6, r4, #16
    orrs    r7, r6                      /* the lower word */
    .endif
    lsrs    r4, r4, #16
    muls    r0, r2
    adds    r0, r0, r5
    adds    r0, r0, r4
    .endm

    .align  2
.Lnear:
    ldr     r0, [sp, #F_U + 4]
    multiply 0
    ldr     r4, [sp, #F_U_SHIFT]
    asrs    r0, r4
    movs    r7, r0
    ldr     r0, [sp, #F_V + 4]
    multiply 0
    ldr     r4, [sp, #F_V_SHIFT]
    asrs    r0, r4
    mov     pc, r12

/* A product of 64 bits, shifted to the right by less than 32. */
    .macro  multiply_far value, shift
    ldr     r0, [sp, #\value]
    multiply 1
    ldr     r4, [sp, #\shift]
    cmp     r4, #0
    blt     1f
    asrs    r0, r4
    b       2f
1:  rsbs    r4, r4, #0
    lsls    r0, r4
    movs    r5, #32
    subs    r5, r5, r4
    lsrs    r7, r5
    orrs    r0, r7
2:
    .endm

    .align  2
.Lfar:
    multiply_far F_U + 4, F_U_SHIFT
    str     r0, [sp, #F_SPARE]
    multiply_far F_V + 4, F_V_SHIFT
    ldr     r7, [sp, #F_SPARE]
    mov     pc, r12

/* Entry i is 2^31 / (2^15 + 2^8 i + 127.5), rounded. */
    .align  2
.Lreciprocals:
    .short  65279, 64774, 64278, 63789, 63308, 62833, 62366, 61906
    .short  61452, 61005, 60565, 60131, 59703, 59281, 58865, 58454
    .short  58050, 57651, 57257, 56869, 56486, 56108, 55735, 55368
    .short  55004, 54646, 54292, 53943, 53598, 53258, 52922, 52590
    .short  52263, 51939, 51619, 51304, 50992, 50684, 50379, 50078
    .short  49781, 49487, 49197, 48910, 48627, 48346, 48069, 47795
    .short  47525, 47257, 46992, 46730, 46471, 46215, 45962, 45711
    .short  45464, 45219, 44976, 44736, 44499, 44264, 44032, 43802
    .short  43574, 43349, 43126, 42905, 42687, 42471, 42257, 42045
    .short  41835, 41628, 41422, 41219, 41017, 40817, 40620, 40424
    .short  40230, 40038, 39848, 39659, 39473, 39288, 39105, 38923
    .short  38743, 38565, 38389, 38214, 38040, 37869, 37698, 37530
    .short  37363, 37197, 37033, 36870, 36708, 36548, 36390, 36233
    .short  36077, 35922, 35769, 35617, 35467, 35317, 35169, 35022
    .short  34877, 34732, 34589, 34447, 34306, 34166, 34028, 33890
    .short  33754, 33618, 33484, 33351, 33219, 33088, 32958, 32829

/* clang-format on */

#endif
