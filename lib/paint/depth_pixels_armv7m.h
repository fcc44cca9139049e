/* SPDX-License-Identifier: MIT */
/* Part of depth_outline_armv7m.h: the pixels of a row whose depths are of one octave, and what follows them.
 * Assembly. */
#ifndef FXL_DEPTH_PIXELS_ARMV7M_H
#define FXL_DEPTH_PIXELS_ARMV7M_H

/* clang-format off */

/* Paints the pixel of the cell in r4. Pixels of 8 bits take r9. */
    .macro paint_pixel
#if PIXEL_BITS == 16
    strh    r6, [r4, r5]
#else
    lsr     r9, r4, #1
    strb    r6, [r5, r9]
#endif
    .endm

.Lpixels:
    adds    r1, r1, #DEPTH_OUTLINE_CELLS - DEPTH_OUTLINE_ZEROS
    ldm     r1, {r4, r5, r6}        /* cells, pixels, filling */
    add     r4, r4, r2, lsl #1
    add     r2, r4, r0, lsl #1
    sub     r11, r2, #16
    cmp     r0, #MANY
    blo     .Lfew
.Lmany:
#if FXL_KERNELS_MVE
    /* Eight pixels at once, the last ones by a predicate. q0, q1: the codes of even and of odd
     * ones; r7: what they change in eight. */
    movs    r8, #0
    lsl     r7, lr, #3
    vidup.u32 q0, r8, #2
    vmul.i32 q0, q0, lr
    vadd.i32 q0, q0, r3
    vadd.i32 q1, q0, lr
    dlstp.16 lr, r0
#if PIXEL_BITS == 16
    add     r0, r4, r5
#else
    add     r0, r5, r4, lsr #1
#endif
.Leight:
    vmov    q2, q1
    vsri.32 q2, q0, #16
    vldrh.u16 q3, [r4]
    vpttt.u16 hi, q2, q3
    vstrht.16 q2, [r4]
    vdupt.16 q3, r6
#if PIXEL_BITS == 16
    vstrht.16 q3, [r0], #16
#else
    vstrbt.16 q3, [r0], #8
#endif
    vadd.i32 q0, q0, r7
    vadd.i32 q1, q1, r7
    adds    r4, r4, #16
    letp    lr, .Leight
    b       .Lrow_done
#else
    /* Rounded down, a code may be below 1 as the cell of a pixel where nothing was drawn. */
    mla     r1, lr, r0, r3
    sub     r1, r1, lr
    cmp     r3, #65536
    it      hs
    cmphs   r1, #65536
    blo     .Leach

.Leight_or_seven:
    tst     r4, #2
    beq     .Leight
    ldrh    r7, [r4]
    lsr     r8, r3, #16
    cmp     r8, r7
    bls     .Lhidden
    paint_pixel
    strh    r8, [r4], #2
    add     r3, r3, lr
    cmp     r4, r11
    bhi     .Lfew

    /* Eight pixels. Where nothing was drawn, all are visible. */
.Leight:
    ldm     r4, {r7-r10}
    orr     r0, r7, r8
    orr     r1, r9, r10
    orrs    r0, r0, r1
    bne     .Leach_of_eight
    .irp    two, r7, r8, r9, r10
    lsr     r0, r3, #16
    add     \two, r3, lr
    bfi     \two, r0, #0, #16
    add     r3, r3, lr, lsl #1
    .endr
#if PIXEL_BITS == 16
    add     r0, r4, r5
    stm     r4!, {r7-r10}
    strd    r6, r6, [r0]
    strd    r6, r6, [r0, #8]
#else
    lsr     r0, r4, #1
    add     r0, r0, r5
    stm     r4!, {r7-r10}
    strh    r6, [r0]
    strh    r6, [r0, #2]
    strh    r6, [r0, #4]
    strh    r6, [r0, #6]
#endif
    cmp     r4, r11
    bls     .Leight
#endif

    /* Fewer than MANY pixels, each tested for itself. */
.Lfew:
    sub     r0, r2, r4
#if PIXEL_BITS == 16
    add     r1, r2, r5
#else
    add     r1, r5, r2, lsr #1
#endif
    tbb     [pc, r0]
.Lfews:
    .irp    length, 0, 1, 2, 3, 4, 5, 6, 7
    .byte   (.Lfew\length - .Lfews) / 2, 0
    .endr
    .irp    length, 7, 6, 5, 4, 3, 2, 1
.Lfew\length:
    ldrh    r7, [r2, #-2 * \length]
    lsr     r8, r3, #16
    cmp     r8, r7
    bls     .Lfew_hidden\length
#if PIXEL_BITS == 16
    strh    r6, [r1, #-2 * \length]
#else
    strb    r6, [r1, #-\length]
#endif
    strh    r8, [r2, #-2 * \length]
.Lfew_hidden\length:
    .if     \length > 1
    add     r3, r3, lr
    .endif
    .endr
.Lfew0:

.Lrow_done:
    ldm     sp, {r4-r11}
    subs    r12, r12, #1
    bpl     .Lrow_of_one
.Lrows_done:
    cmn     r12, #1
    beq     .Lrows_below
.Lrow_of_several_done:
    lsls    r0, r12, #1
    beq     .Lrows_below
    bpl     .Lrow

    /* The rest of a row. */
    bic     r12, r12, #REST_OF_ROW
    ldr     r1, [sp, #FRAME_OUTLINE]
    ldrd    r6, r7, [r1, #DEPTH_OUTLINE_ALONG]
    ldrd    r2, r3, [r1, #DEPTH_OUTLINE_REST]
    ldrd    r4, r5, [r1, #DEPTH_OUTLINE_REST + 8]
    ldr     r0, [r1, #DEPTH_OUTLINE_REST + 16]
    adds    r1, r1, #DEPTH_OUTLINE_ZEROS
    b       .Lpart

#if !FXL_KERNELS_MVE
    /* Some of eight pixels may be hidden. */
.Leach_of_eight:
    .rept   8
    ldrh    r7, [r4]
    lsr     r8, r3, #16
    cmp     r8, r7
    bls     .Lhidden
    paint_pixel
    strh    r8, [r4], #2
    add     r3, r3, lr
    .endr
    cmp     r4, r11
    bls     .Leight
    b       .Lfew

    /* The pixel of r4 is hidden: on to the first that is not. */
.Lhidden:
    add     r4, r4, #2
    add     r3, r3, lr
    cmp     r4, r11
    bhi     .Lfew
.Leight_hidden:
    .rept   8
    ldrh    r7, [r4], #2
    cmp     r7, r3, lsr #16
    blo     .Lvisible
    add     r3, r3, lr
    .endr
    cmp     r4, r11
    bls     .Leight_hidden
    b       .Lfew
.Lvisible:
    sub     r4, r4, #2
    cmp     r4, r11
    bls     .Leight_or_seven
    b       .Lfew

    /* Any number of pixels, without regard to speed. */
.Leach:
    ldrh    r7, [r4]
    lsr     r8, r3, #16
    cmp     r8, r7
    bls     .Leach_hidden
    paint_pixel
    strh    r8, [r4]
.Leach_hidden:
    adds    r4, r4, #2
    add     r3, r3, lr
    cmp     r4, r2
    blo     .Leach
    b       .Lrow_done
#endif

/* clang-format on */

#endif
