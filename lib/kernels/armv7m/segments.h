/* SPDX-License-Identifier: MIT */
/* What both kernels of segments for Armv7-M share: paint_segments_armv7m.S paints faces without
 * light, paint_lit_segments_armv7m.S those with light. Assembly. Both keep in r0 the address of the
 * pixel before the segment, in r1 its position, in r2 the step, in r4 the texels and in r5 the mask
 * of rows. Each names the places of its frame:
 *
 *   FRAME_GO      what paints the next segment
 *   FRAME_FULL    what paints a whole one; then the bytes of its code for a pixel, 0 for a loop
 *   FRAME_BEFORE  pixels that a loop leaves out
 *   FRAME_LAST    the last r0 at which a whole segment may begin; then r0 at the end of the pixels
 *   FRAME_SKIP    columns of the next segment that are not painted
 *   FRAME_COLUMN  for a loop: how far a position is shifted to the column; then, to the row
 *   FRAME_TEXELS  the texels; then the mask */
#ifndef FXL_SEGMENTS_ARMV7M_H
#define FXL_SEGMENTS_ARMV7M_H

    .syntax unified
    .thumb

/* inverse = the reciprocal of a weight, as fxl_reciprocal_of finds it, and its leading zeros. */
    .macro  reciprocal inverse, zeros, weight, a, b, c
    clz     \zeros, \weight
    lsl     \a, \weight, \zeros
    lsr     \inverse, \a, #16
    mov     \b, #-1
    udiv    \inverse, \b, \inverse
    lsl     \inverse, \inverse, #14
    umull   \b, \c, \a, \inverse
    rsb     \c, \c, #1073741824
    asr     \b, \inverse, #16
    mul     \b, \b, \c
    add     \inverse, \inverse, \b, asr #14 /* bug: v7m-segment-newton */
    .endm

/* high:low is shifted to the right by 32 + drop, from 0 on, into high. drop is overwritten. */
    .macro  shift_down high, low, drop
    cmp     \drop, #0
    bge     1f
    rsb     \drop, \drop, #0
    lsl     \high, \high, \drop
    rsb     \drop, \drop, #32
    lsr     \low, \low, \drop
    orr     \high, \high, \low          /* bug: v7m-segment-far */
    b       2f
1:  asr     \high, \high, \drop
2:
    .endm

/* offset = that of the texel at a position, in a texture of 2^log columns that is no higher. */
    .macro  texel_offset offset, mask, position, log
    .if     \log == 8
    and.w   \offset, \mask, \position
    .else
    and.w   \offset, \mask, \position, lsr #(16 - 2 * \log)
    .endif
    add.w   \offset, \offset, \position, lsr #(32 - \log) /* bug: v7m-segment-column */
    .endm

/* Chooses the code for a face in r0; it takes so many bytes a pixel. Overwrites r2 to r5. */
    .macro  choose_code bytes
    ldrb    r2, [r0, #SEGMENT_FACE_LOG_WIDTH]
    ldrb    r3, [r0, #SEGMENT_FACE_ROW_DROP]
    add     r4, r3, r2, lsl #1
    cmp     r4, #16                     /* else the texture is higher than wide */
    bne     1f
    subs    r5, r2, #5
    cmp     r5, #3
    bhi     1f
    adr     r3, .Lwidths
    ldrh    r3, [r3, r5, lsl #1]
    adr     r2, .Lpixels_5
    add     r2, r2, r3, lsl #1
    movs    r3, #\bytes
    b       2f
1:  rsb     r2, r2, #32
    strd    r2, r3, [sp, #FRAME_COLUMN]
    movs    r3, #0
    str     r3, [sp, #FRAME_BEFORE]
    adr     r2, .Lloop
2:  adds    r2, #1                      /* Thumb code */
    strd    r2, r3, [sp, #FRAME_FULL]
    .endm

    .macro  width_table
    .align  2
.Lwidths:
    .hword  0, (.Lpixels_6 - .Lpixels_5) / 2
    .hword  (.Lpixels_7 - .Lpixels_5) / 2, (.Lpixels_8 - .Lpixels_5) / 2
    .endm

/* Begins with the pixels of a start in r1: r0 becomes the address before them. Overwrites r2, r3. */
    .macro  begin_pixels
    ldrd    r2, r3, [r1, #SEGMENT_START_SKIP]
    ldr     r0, [r1, #SEGMENT_START_PIXELS]
    subs    r0, #1
    add     r3, r3, r0
    str     r2, [sp, #FRAME_SKIP]
    sub     r2, r3, #16
    strd    r2, r3, [sp, #FRAME_LAST]
    .endm

/* Only the beginning of the first segment was to be found. Goes on to `next` by an instruction. */
    .macro  start_pixels
    ldr     r3, [sp, #FRAME_SKIP]
    ldr     r4, [sp, #FRAME_LAST]
    cmp     r0, r4
    it      ls
    cmpls   r3, #0
    ite     eq
    ldreq   r3, [sp, #FRAME_FULL]
    adrne   r3, .Lpartial + 1
    str     r3, [sp, #FRAME_GO]
    .endm

/* Pixels from FRAME_SKIP on, up to the end of the row or of the segment: the last ones of the code
 * of a whole segment, whose first pixel is before them by as many as are left out. count: those
 * that are skipped; left: those of the code that are left out. */
    .macro  find_partial count, left
    ldr     \count, [sp, #FRAME_SKIP]
    mla     r1, r2, \count, r1
    add     r0, r0, \count
    rsb     \left, \count, #16
    ldr     r3, [sp, #FRAME_LAST + 4]
    subs    r3, r3, r0
    cmp     r3, \left                   /* bug: v7m-segment-partial */
    it      lo
    movlo   \left, r3
    rsb     \left, \left, #16
    sub     r0, r0, \left
    movs    r3, #0
    str     r3, [sp, #FRAME_SKIP]
    str     \left, [sp, #FRAME_BEFORE]
    .endm

/* Goes to the code of a whole segment, and leaves out `left` of its pixels. */
    .macro  go_partial left
    ldr     r3, [sp, #FRAME_FULL]
    str     r3, [sp, #FRAME_GO]
    ldr     r4, [sp, #FRAME_FULL + 4]
    mla     r3, \left, r4, r3
    ldrd    r4, r5, [sp, #FRAME_TEXELS]
    bx      r3
    .endm

/* Less than a segment is left; or nothing: to .Lend. */
    .macro  begin_rest
    ldr     r3, [sp, #FRAME_LAST + 4]
    cmp     r0, r3
    bhs     .Lend
    adr     r3, .Lpartial + 1
    str     r3, [sp, #FRAME_GO]
    .endm

#endif
