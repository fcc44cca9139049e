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

/* The places of a frame, which the assembler numbers: slots says where the next one begins, slot names
 * it and how many words it has, 0 for the frame's end, and slot_of gives a place another name, for faces
 * that have something else there. Names begin with .L, so that no symbol table has them. */
    .macro  slots from:req
    .set    .Lslot, \from
    .endm
    .macro  slot name:req, words=1
    .equiv  \name, .Lslot
    .set    .Lslot, .Lslot + 4 * \words
    .endm
    .macro  slot_of name:req, place:req
    .equiv  \name, \place
    .endm

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

/* low, high: the weight where 16 columns of that number begin. r1: row, r6, r7: the weight's step. */
    .macro  weight_of_16 low, high, number
    ldrd    \low, \high, [r1, #PAINT_ROW_WEIGHT]
    umlal   \low, \high, r6, \number
    mla     \high, r7, \number, \high
    .endm

/* r10, r11: the weight at the first of the 16 columns that column r2 is in; r12, lr: at the end of
 * those that column r3 - 1 is in. r0: face, r1: row. Overwrites r4 to r7. */
    .macro  weights_at_ends
    lsr     r4, r2, #4
    add     r5, r3, #15
    lsr     r5, r5, #4
    ldrd    r6, r7, [r0, #SEGMENT_FACE_WEIGHT_STEP]
    weight_of_16 r10, r11, r4
    weight_of_16 r12, lr, r5
    .endm

/* place sampling: the kernels of Armv7-M; texel_offset has the shift and mask of both */
/* offset = that of the texel at a position, in a texture of 2^log columns that is no higher. */
    .macro  texel_offset offset, mask, position, log
    .if     \log == 8
    and.w   \offset, \mask, \position
    .else
    and.w   \offset, \mask, \position, lsr #(16 - 2 * \log)
    .endif
    add.w   \offset, \offset, \position, lsr #(32 - \log)
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
