/* SPDX-License-Identifier: MIT */
/* Part of smooth_planes_armv7m.S: the planes of a face's three channels, from the colours of its corners.
 * corner_colours.c has the C text. Assembly. */
#ifndef FXL_COLOUR_CHANNELS_ARMV7M_H
#define FXL_COLOUR_CHANNELS_ARMV7M_H

/* clang-format off */

/* A channel of the colours r0-r2 at the corners, to r7, as find_channel has it. r3: half a level of the colour. */
    .macro channel_of_colours bit, up
    ubfx    r4, r0, #\bit, #8
    ubfx    r5, r1, #\bit, #8
    ubfx    r6, r2, #\bit, #8
    subs    r5, r5, r4
    subs    r6, r6, r4
    add     r4, r3, r4, lsl #\up - 3
    lsls    r5, r5, #\up
    lsls    r6, r6, #\up
    stm     r7!, {r4-r6}
    .endm

/* A channel at r7, of corner 0 in 10.22 and the differences of the others in 7.25: r0, along, in r4, and
 * down, in r1. r3, r6: where corner 0 is, lr: its row. */
    .macro find_channel at, half
    ldm     r7!, {r0, r1, r2}
    smull   r5, r4, r1, r11
    smlal   r5, r4, r2, r9
    smull   r5, r1, r1, r10
    smlal   r5, r1, r2, r8
    smull   r5, r2, r4, r3
    smlal   r5, r2, r1, r6
    subs    r0, r0, r2
    mls     r0, r1, lr, r0
    .if     \half
    add     r0, r0, #1024
    .endif
    strd    r0, r1, [r12, #\at]
    .endm

/* The three channels, if a constant weight changes none too much. r12: the face. */
    .macro find_channels
    ldr     r6, [sp, #VALUES]
    add     r7, r12, #COLOUR_FACE_VALUES
    ldrd    r4, lr, [r12, #COLOUR_FACE_IS_LIT]
    cmp     r4, #0
    bne     .Llit_corners
    ldm     r6, {r0, r1, r2}
    ldr     r0, [r0, #CORNER_TEXEL]
    ldr     r1, [r1, #CORNER_TEXEL]
    ldr     r2, [r2, #CORNER_TEXEL]
    mov     r3, #1 << 18
    channel_of_colours 16, 22
    mov     r3, #1 << 19
    channel_of_colours 8, 23
    mov     r3, #1 << 18
    channel_of_colours 0, 22
.Lhave_corners:
    ldrd    r4, r5, [sp, #LEAST]
    cmp     r5, r4, lsr #7
    it      hi
    cmphi   lr, #0
    bls     .Ldifferences           /* weights are near, or are not asked for */
    clz     r0, r4
    rsb     r0, r0, #17
    lsrs    r4, r4, r0
    mul     r5, lr, r4
    ldrd    r3, r6, [sp, #APART]
    mov     r12, r7
    subs    r7, r7, #36

    /* r4: the least weight, r3, r6: the others less the first one, r5: what needs no mean. */
.Lbend:
    ldm     r7!, {r0, r1, r2}
    asrs    r1, r1, #17
    asrs    r2, r2, #17
    subs    r0, r2, r1
    mla     lr, r1, r3, r5
    cmp     lr, r5, lsl #1
    itt     ls
    mlals   lr, r2, r6, r5
    cmpls   lr, r5, lsl #1
    ittt    ls
    subls   lr, r6, r3
    mlals   lr, r0, lr, r5
    cmpls   lr, r5, lsl #1
    bhi     .Lmean
.Lbalanced:
    cmp     r7, r12
    bne     .Lbend
.Ldifferences:
    ldr     r0, [sp, #EXPONENT]
    subs    r7, r7, #36
    subs    r0, r0, #29
    blt     .Lshort_side
    asr     r8, r8, r0
    asr     r9, r9, r0
    asr     r10, r10, r0
    asr     r11, r11, r0
.Lscaled:
    ldrd    r3, r6, [sp, #X]
    ldr     r12, [sp, #OUTLINE]
    add     lr, r6, #32768
    add     r1, r3, #32768
    asr     lr, lr, #16
    asrs    r1, r1, #16
    str     r1, [r12, #COLOUR_OUTLINE_COLUMN]
    lsls    r3, r3, #16
    lsls    r6, r6, #16
    find_channel COLOUR_OUTLINE_RED, 1
    add     r4, r4, #1024
    asrs    r4, r4, #11
    str     r4, [r12, #COLOUR_OUTLINE_STEP]
    find_channel COLOUR_OUTLINE_GREEN, 0
    lsls    r4, r4, #4
    str     r4, [r12, #COLOUR_OUTLINE_GREEN_STEP]
    find_channel COLOUR_OUTLINE_BLUE, 1
    ldr     r2, [r12, #COLOUR_OUTLINE_STEP]
    add     r4, r4, #1024
    asrs    r4, r4, #11
    add     r2, r2, r4, lsl #16
    str     r2, [r12, #COLOUR_OUTLINE_STEP]
    movs    r0, #1
    .endm

/* What find_channels does in other faces. */
    .macro find_channel_mean
.Llit_corners:
    add     r6, r7, #36
.Llit:
    ldm     r7, {r0, r1, r2}
    subs    r1, r1, r0
    subs    r2, r2, r0
    lsls    r0, r0, #6
    lsls    r1, r1, #9
    lsls    r2, r2, #9
    stm     r7!, {r0, r1, r2}
    cmp     r7, r6
    bne     .Llit
    b       .Lhave_corners

    /* A channel bends by r1, r2 and r0 times weights: as find_means and mean_of have it. r5: the most, r6: the
     * least, r3: the sum, then the mean; lr: what the most may be above the least. */
.Lmean:
    cmp     r5, r4, lsl #6          /* FXL_BEND_NONE is below that, and FXL_BEND_FINE above */
    bhi     .Lrefused_colours
    push    {r3, r5, r6}
    muls    r1, r3, r1
    muls    r2, r6, r2
    subs    r6, r6, r3
    muls    r0, r6, r0
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
    sub     lr, r12, r7
    movs    r6, #0
    cmp     lr, #12                 /* blue is left: green */
    ite     eq
    movteq  r6, #((64 << 6) - 8)    /* the end less 1/8, in 10.22 */
    movtne  r6, #((32 << 6) - 8)
    add     r0, r0, r3, lsl #6
    sub     lr, r0, #1 << 18
    cmp     lr, r6                  /* 1/16 away from both ends? */
    itt     ls
    addls   r5, lr, r1, asr #3
    cmpls   r5, r6
    itt     ls
    addls   r5, lr, r2, asr #3
    cmpls   r5, r6
    bhi     .Lhold_mean
.Lhas_mean:
    str     r0, [r7, #-12]
    pop     {r3, r5, r6}
    b       .Lbalanced

    /* hold_mean: r0 is held from lr to r6, in 16.16. If no bend is too far from nothing, nothing is added. */
.Lhold_mean:
    asrs    r0, r0, #6
    asrs    r1, r1, #9
    asrs    r2, r2, #9
    ends_of_differences r5, lr, r1, r2
    rsb     lr, lr, #4096
    lsrs    r6, r6, #6
    adds    r6, r6, #4096
    subs    r6, r6, r5
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
    asr     r6, r6, #6
    bls     .Lheld_mean
    subs    r6, r0, r6
    cmp     r6, r3
    mov     r3, r6
    bne     .Ladd_mean
    b       .Ltoo_bent
.Lheld_mean:
    adds    r0, r6, r3
    lsls    r0, r0, #6
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
    movs    r5, #0
    add     r12, r7, #36
.Lfits:
    ldrd    r1, r2, [r7, #4]
    lsl     r3, r1, r0
    lsl     r6, r2, r0
    strd    r3, r6, [r7, #4]
    eor     r1, r1, r1, asr #31
    eor     r2, r2, r2, asr #31
    orrs    r1, r1, r2
    orrs    r5, r5, r1
    adds    r7, r7, #12
    cmp     r7, r12
    bne     .Lfits
    subs    r7, r7, #36
    add     r5, r5, #1 << 23
    rsb     r0, r0, #31
    lsrs    r5, r5, r0
    bne     .Lrefused_colours
    b       .Lscaled
    .endm

/* clang-format on */

#endif
