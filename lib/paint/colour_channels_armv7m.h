/* SPDX-License-Identifier: MIT */
/* Part of smooth_planes_armv7m.S: the planes of a face's three channels, from the colours of its corners.
 * corner_colours.c has the C text. Assembly. */
#ifndef FXL_COLOUR_CHANNELS_ARMV7M_H
#define FXL_COLOUR_CHANNELS_ARMV7M_H

/* clang-format off */

/* A channel of the values at r7, in r0, along, in r4, and down, in r1. r3, r6: where corner 0 is,
 * lr: what moves a difference up. */
    .macro find_channel offset
    ldr     r0, [r7, #\offset]
    ldrd    r1, r2, [r7, #\offset + 4]
    lsl     r1, r1, lr
    lsl     r2, r2, lr
    smull   r5, r4, r1, r11
    smlal   r5, r4, r2, r9
    smull   r5, r1, r1, r10
    smlal   r5, r1, r2, r8
    smull   r5, r2, r4, r3
    smlal   r5, r2, r1, r6
    ldr     r5, [sp, #ROW]
    rsb     r0, r2, r0, lsl #6
    mls     r0, r1, r5, r0
    .endm

/* The same, with what an outline keeps of it: \number: 0, 1, 2: red, green, blue; \half: is added. */
    .macro channel_of_outline number, at, down, half
    find_channel 12 * \number
    .if     \half
    add     r0, r0, #1024
    .endif
    str     r0, [r12, #\at]
    str     r1, [r12, #\down]
    .endm

/* The three channels, if a constant weight changes none too much. r7: the values of a channel,
 * whose second and third become differences from the first; r12: their end. */
    .macro find_channels
    ldr     r7, [sp, #VALUES]
    ldrd    r4, r5, [sp, #LEAST]
    add     r12, r7, #COLOUR_VALUES_LIMIT
    ldr     r2, [r12]
    cmp     r5, r4, lsr #7
    it      hi
    cmphi   r2, #0
    bls     .Lany_bend              /* weights are near, or are not asked for */
    clz     r0, r4
    rsb     r0, r0, #17
    lsrs    r4, r4, r0
    mul     r5, r2, r4
    ldrd    r3, r6, [sp, #APART]

    /* r4: the least weight, r3, r6: the others less the first one, r5: what needs no mean. */
.Lbend:
    ldm     r7!, {r0, r1, r2}
    subs    r1, r1, r0
    subs    r2, r2, r0
    strd    r1, r2, [r7, #-8]
    asrs    r1, r1, #8
    asrs    r2, r2, #8
    subs    r0, r2, r1
    sub     lr, r6, r3
    muls    r1, r3, r1
    muls    r2, r6, r2
    mul     r0, lr, r0
    add     lr, r1, r5
    cmp     lr, r5, lsl #1
    itt     ls
    addls   lr, r2, r5
    cmpls   lr, r5, lsl #1
    itt     ls
    addls   lr, r0, r5
    cmpls   lr, r5, lsl #1
    bhi     .Lmean
.Lbalanced:
    cmp     r7, r12
    bne     .Lbend
.Ldifferences:
    ldr     r7, [sp, #VALUES]
    ldr     r0, [sp, #EXPONENT]
    mov     lr, #9
    subs    r0, r0, #29
    blt     .Lshort_side
    asr     r8, r8, r0
    asr     r9, r9, r0
    asr     r10, r10, r0
    asr     r11, r11, r0
.Lscaled:
    ldrd    r3, r6, [sp, #X]
    ldr     r12, [sp, #OUTLINE]
    add     r0, r6, #32768
    add     r1, r3, #32768
    asrs    r0, r0, #16
    asrs    r1, r1, #16
    str     r0, [sp, #ROW]
    str     r1, [r12, #COLOUR_OUTLINE_COLUMN]
    lsls    r3, r3, #16
    lsls    r6, r6, #16
    channel_of_outline 0, COLOUR_OUTLINE_RED, COLOUR_OUTLINE_RED_DOWN, 1
    add     r4, r4, #1024
    asrs    r4, r4, #11
    str     r4, [r12, #COLOUR_OUTLINE_STEP]
    channel_of_outline 1, COLOUR_OUTLINE_GREEN, COLOUR_OUTLINE_GREEN_DOWN, 0
    lsls    r4, r4, #4
    str     r4, [r12, #COLOUR_OUTLINE_STEP + 4]
    channel_of_outline 2, COLOUR_OUTLINE_BLUE, COLOUR_OUTLINE_BLUE_DOWN, 1
    ldr     r2, [r12, #COLOUR_OUTLINE_STEP]
    add     r4, r4, #1024
    asrs    r4, r4, #11
    add     r2, r2, r4, lsl #16
    str     r2, [r12, #COLOUR_OUTLINE_STEP]
    movs    r0, #1
    .endm

/* What find_channels does in other faces. */
    .macro find_channel_mean
.Lany_bend:
    ldm     r7, {r0, r1, r2}
    subs    r1, r1, r0
    subs    r2, r2, r0
    strd    r1, r2, [r7, #4]
    adds    r7, r7, #12
    cmp     r7, r12
    bne     .Lany_bend
    b       .Ldifferences

    /* A channel bends by r1, r2 and r0: as find_means and mean_of have it. r5: the most, r6: the
     * least, r3: the sum, then the mean; lr: what the most may be above the least. */
.Lmean:
    cmp     r5, r4, lsl #6          /* FXL_BEND_NONE is below that, and FXL_BEND_FINE above */
    bhi     .Lrefused_colours
    push    {r3, r5, r6}
    adds    r3, r1, r2
    adds    r3, r3, r0
    cmp     r1, r2
    itete   lt
    movlt   r5, r2
    movge   r5, r1
    movlt   r6, r1
    movge   r6, r2
    cmp     r0, r5
    it      gt
    movgt   r5, r0
    cmp     r0, r6
    it      lt
    movlt   r6, r0
    bic     r5, r5, r5, asr #31
    and     r6, r6, r6, asr #31
    movw    lr, #606                /* BEND_BOTH */
    mul     lr, lr, r4
    subs    r0, r5, r6
    cmp     r0, lr
    bhi     .Ltoo_bent
    cmp     r0, lr, lsr #1          /* then the mean is nearer to both ends */
    bls     .Lfree_mean
    sub     r0, r5, lr, lsr #1
    add     r0, r0, r0, lsl #1
    add     r1, r6, lr, lsr #1
    add     r1, r1, r1, lsl #1
    cmp     r3, r0
    it      lt
    movlt   r3, r0
    cmp     r3, r1
    it      gt
    movgt   r3, r1
.Lfree_mean:
    lsls    r3, r3, #4
    sdiv    r3, r3, r4
    lsls    r3, r3, #2
    movs    r0, #3
    sdiv    r3, r3, r0
    ldr     r0, [r7, #-12]
    ldrd    r1, r2, [r7, #-8]
    sub     r6, r12, r7
    cmp     r6, #12                 /* green */
    ite     eq
    moveq   r6, #64 << 16
    movne   r6, #32 << 16
    sub     r6, r6, #4096
    adds    r0, r0, r3
    ends_of_differences r5, lr, r1, r2
    rsb     lr, lr, #4096
    subs    r6, r6, r5
    cmp     r0, lr                  /* 1/16 away from both ends? */
    it      ge
    cmpge   r6, r0
    blt     .Lhold_mean
.Lhas_mean:
    str     r0, [r7, #-12]
    pop     {r3, r5, r6}
    b       .Lbalanced

    /* hold_mean: r0 is held from lr to r6. If no bend is too far from nothing, nothing is added. */
.Lhold_mean:
    cmp     r0, lr
    it      lt
    movlt   r0, lr
    cmp     r0, r6
    it      gt
    movgt   r0, r6
    asrs    r1, r1, #8
    asrs    r2, r2, #8
    ldrd    r3, r5, [sp, #APART + 12]
    sub     lr, r2, r1
    subs    r6, r5, r3
    mul     lr, lr, r6
    muls    r1, r3, r1
    muls    r2, r5, r2
    sub     r2, r2, lr
    sub     lr, lr, r1
    mov     r3, #303 * 64           /* BEND_SIDE */
    mul     r5, r3, r4
    movs    r3, #0                  /* is_balanced: r3: more, r6: from none and each of three bends to that */
.Ladd_mean:
    mls     r6, r3, r4, r5
    cmp     r6, r5, lsl #1
    .irp    bend, r1, lr, r2
    itt     ls
    addls   r6, r6, \bend, lsl #6
    cmpls   r6, r5, lsl #1
    .endr
    ldr     r6, [r7, #-12]
    bls     .Lheld_mean
    subs    r6, r0, r6
    cmp     r6, r3
    mov     r3, r6
    bne     .Ladd_mean
    b       .Ltoo_bent
.Lheld_mean:
    adds    r0, r6, r3
    b       .Lhas_mean
.Ltoo_bent:
    add     sp, sp, #12
    b       .Lrefused_colours

    /* A side of the face is short: coefficients and differences share the shift, -r0. */
.Lshort_side:
    rsbs    r0, r0, #0
    eor     r1, r8, r8, asr #31
    .irp    coefficient, r9, r10, r11
    eor     r2, \coefficient, \coefficient, asr #31
    orrs    r1, r1, r2
    .endr
    clz     r1, r1
    subs    r1, r1, #1
    cmp     r1, r0
    it      hi
    movhi   r1, r0
    .irp    coefficient, r8, r9, r10, r11
    lsl     \coefficient, \coefficient, r1
    .endr
    subs    r0, r0, r1
    beq     .Lscaled
    cmp     r0, #4                  /* LESS_MAX */
    bhi     .Lrefused_colours
    add     lr, lr, r0
    movs    r5, #0
.Lfits:
    ldrd    r1, r2, [r7, #4]
    eor     r1, r1, r1, asr #31
    eor     r2, r2, r2, asr #31
    orrs    r1, r1, r2
    orrs    r5, r5, r1
    adds    r7, r7, #12
    cmp     r7, r12
    bne     .Lfits
    ldr     r7, [sp, #VALUES]
    add     r5, r5, #1 << 14
    rsb     r0, r0, #22
    lsrs    r5, r5, r0
    bne     .Lrefused_colours
    b       .Lscaled
    .endm

/* clang-format on */

#endif
