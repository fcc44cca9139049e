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

/* clang-format off */
    .syntax unified
    .thumb

/* The reciprocal of a weight and its leading zeros, as fxl_reciprocal_of finds them, where `most` is
 * 2^31 - 1. Overwrites `scaled`, which may be the weight, and `spare`. */
    .macro  reciprocal inverse, zeros, weight, most, scaled, spare
    clz     \zeros, \weight
    orr     \scaled, \weight, #1
    lsl     \scaled, \scaled, \zeros
    lsr     \spare, \scaled, #16
    udiv    \inverse, \most, \spare
    mul     \spare, \inverse, \inverse
    umull   \spare, \scaled, \spare, \scaled
    rsb     \inverse, \scaled, \inverse, lsl #16
    .endm

/* high:low is shifted to the right by 32 + drop, from 0 on, into high. drop is overwritten. */
    .macro  shift_down high, low, drop
    cmp     \drop, #0
    bge     1f
    rsb     \drop, \drop, #0
    lsl     \high, \high, \drop
    rsb     \drop, \drop, #32
    lsr     \low, \low, \drop
    orr     \high, \high, \low
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
    add.w   \offset, \offset, \position, lsr #(32 - \log)
    .endm

/* Chooses the code for a face in r0: it takes so many bytes a pixel, and so many for a whole segment,
 * from .Lpixels_5 on. Overwrites r2 and r3. */
    .macro  choose_code bytes, whole_bytes
    ldrb    r2, [r0, #SEGMENT_FACE_FORM]
    cbz     r2, 1f
    movw    r3, #\whole_bytes
    mul     r2, r2, r3
    adr     r3, .Lpixels_5 - \whole_bytes + 1 /* Thumb code */
    add     r2, r2, r3
    movs    r3, #\bytes
    b       2f
1:  ldrb    r2, [r0, #SEGMENT_FACE_LOG_WIDTH]
    ldrb    r3, [r0, #SEGMENT_FACE_ROW_DROP]
    rsb     r2, r2, #32
    strd    r2, r3, [sp, #FRAME_COLUMN]
    adr     r2, .Lloop + 1
    movs    r3, #0
    str     r3, [sp, #FRAME_BEFORE]
2:  strd    r2, r3, [sp, #FRAME_FULL]
    .endm

/* The pixels of columns x0 to x1 of a row in r1: r0 becomes the address before the segment's.
 * Overwrites r2, r3 and x1. GO is the code for the first segment. */
    .macro  begin_pixels x0, x1
    ldr     r0, [r1, #PAINT_ROW_PIXELS]
    and     r2, \x0, #15
    subs    r0, #1
    add     \x1, \x1, r0
    sub     r3, \x1, #16
    strd    r3, \x1, [sp, #FRAME_LAST]
    str     r2, [sp, #FRAME_SKIP]
    sub     \x0, \x0, r2
    add     r0, r0, \x0
    cmp     r0, r3
    it      ls
    cmpls   r2, #0
    ite     eq
    ldreq   r3, [sp, #FRAME_FULL]
    adrne   r3, .Lpartial + 1
    str     r3, [sp, #FRAME_GO]
    .endm

/* Pixels from FRAME_SKIP on, up to the end of the row or of the segment: the last ones of the code
 * of a whole segment, whose first pixel is before them by as many as are left out. skip: the pixels
 * that are skipped; left: those of the code that are left out. */
    .macro  find_partial skip, left
    ldr     \skip, [sp, #FRAME_SKIP]
    mla     r1, r2, \skip, r1
    add     r0, r0, \skip
    rsb     \left, \skip, #16
    ldr     r3, [sp, #FRAME_LAST + 4]
    subs    r3, r3, r0
    cmp     r3, \left
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

/* The code of a whole segment for each width that has its own: a kernel's macro whole writes it for
 * one logarithm of the width, under the label .Lpixels_ and the logarithm. */
    .macro  whole_of_each_size
    .align  2
    whole   5
    .org    .Lpixels_5 + WHOLE
    whole   6
    .org    .Lpixels_5 + 2 * WHOLE
    whole   7
    .org    .Lpixels_5 + 3 * WHOLE
    whole   8
    .endm

/* clang-format on */

#endif
