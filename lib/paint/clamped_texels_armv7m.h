/* SPDX-License-Identifier: MIT */
/* Part of plain_rows_armv7m.h: texels that do not repeat. Where all pixels of a segment lie within
 * the texture, or beyond one side of it, the code of plain texels paints them. paint_clamped of
 * segment_runs.h is the portable text. Assembly. */
#ifndef FXL_CLAMPED_TEXELS_ARMV7M_H
#define FXL_CLAMPED_TEXELS_ARMV7M_H

/* clang-format off */

#define F_PUSHED   20

/* A coordinate of the first pixel and of the last one: beyond the same side it is held there.
 * Overwrites r10. */
    .macro  hold_within first, last, step
    orr     r10, \first, \last
    cmp     r10, #0x10000
    blo     1f
    ands    r10, \first, \last
    itt     mi
    movmi   \first, #0
    movmi   \step, #0
    bmi     1f
    cmp     \first, #0x10000
    it      ge
    cmpge   \last, #0x10000
    blt     .Lclamped_mixed
    movw    \first, #0xFFFF
    movs    \step, #0
1:
    .endm

/* r1, r2: u and v of the first pixel, 1/16 of U and V; r3, r4: their steps; r5: pixels of 16 that
 * are left out; r8, r9: u and v of the last pixel. */
/* Both ends are within the texture, and the last one by 8 units of a position: so far may a step
 * that is rounded lead beyond it. Then p and step are those of a plain face. */
    .align  2
.Lclamped:
    ldrd    r3, r4, [sp, #.LF_PREVIOUS]
    strd    u_0, v_0, [sp, #.LF_PREVIOUS]
    orr     r5, r3, r4
    sub     r6, u_0, #128
    orr     r5, r5, r6
    add     r6, u_0, #128
    orr     r5, r5, r6
    sub     r6, v_0, #128
    orr     r5, r5, r6
    add     r6, v_0, #128
    orr     r5, r5, r6
    cmp     r5, #0x100000
    bhs     1f
    ldr     r5, [sp, #.LF_BEFORE]
    ldr     r3, [sp, #.LF_SHORT]
    str     r3, [sp, #.LF_BEFORE]
    ldrd    r3, r4, [sp, #.LF_PLAIN]
    mla     r3, r5, r4, r3
    ldrd    texels, mask, [sp, #.LF_TEXELS]
    ldr     table, [sp, #.LF_TABLE]
    bx      r3

1:  mov     r1, r3
    mov     r2, r4
    push    {r7-r11}
    ldr     r5, [sp, #(.LF_BEFORE + F_PUSHED)]
    ldr     r7, [sp, #(.LF_LOG + F_PUSHED)]
    movs    r6, #8
    lsls    r6, r6, r7
    adds    r7, #4
    sub     r3, u_0, r1
    sub     r4, v_0, r2
    adds    r3, r3, r6
    adds    r4, r4, r6
    asrs    r3, r3, r7
    asrs    r4, r4, r7
    asrs    r1, r1, #4
    asrs    r2, r2, #4
    ldr     r6, [sp, #(.LF_SHORT + F_PUSHED)]
    cmp     r5, r6
    beq     1f                          /* a whole segment */
    ldr     r9, [sp, #(.LF_ROW + F_PUSHED)]
    ldr     r9, [r9, #PAINT_ROW_PIXELS]
    sub     r9, pixels, r9
    .if     WIDE
    add     r9, r5, r9, asr #1
    .else
    add     r9, r5, r9
    .endif
    add     r9, r9, #1                  /* the first pixel's column */
    rsb     r10, r7, #36
    lsl     r9, r9, r10
    lsr     r9, r9, r10                 /* and its number in the segment */
    mla     r1, r3, r9, r1
    mla     r2, r4, r9, r2
1:  rsb     r9, r5, #15
    mla     r8, r3, r9, r1
    mla     r9, r4, r9, r2
    orr     r10, r1, r8
    orr     r11, r2, r9
    orr     r10, r10, r11
    cmp     r10, #0x10000
    bhs     .Lclamped_beyond
.Lclamped_paint:
    add     p, r2, r1, lsl #16
    add     step, r4, r3, lsl #16
    ldr     r3, [sp, #(.LF_SHORT + F_PUSHED)]
    str     r3, [sp, #(.LF_BEFORE + F_PUSHED)]
    ldrd    r7, r8, [sp, #(.LF_PLAIN + F_PUSHED)]
    mla     r3, r5, r8, r7
    pop     {r7-r11}
    ldrd    texels, mask, [sp, #.LF_TEXELS]
    ldr     table, [sp, #.LF_TABLE]
    bx      r3

/* A whole segment both of whose ends have the same position, r5 and r6, once it is held within the
 * texture: so has each pixel the same texel. A step that is rounded may lead beyond an end by less than
 * 8 units of a position; a texel has at least 256. r3: the code that stores the pixels. */
.Lclamped_fill:
    ldr     r4, [sp, #.LF_FACE]
    ldrb    r1, [r4, #SEGMENT_FACE_LOG_WIDTH] /* and of the height */
    rsb     r4, r1, #16
    lsr     r2, r6, r4
    lsl     r2, r2, r1
    lsr     r5, r5, r4
    add     r2, r2, r5
    ldr     texels, [sp, #.LF_TEXELS]
    ldr     table, [sp, #.LF_TABLE]
    .if     WIDE
    cbz     table, 1f
    ldrb    r1, [texels, r2]
    ldrh    r1, [table, r1, lsl #1]
    bx      r3
1:  ldrh    r1, [texels, r2, lsl #1]
    bx      r3
    .align  2
.Lclamped_words:
    tst     pixels, #2
    beq     .Lclamped_stores
    orr     r1, r1, r1, lsl #16
    adds    pixels, #2
    .irp    i, 0, 1, 2, 3, 4, 5, 6, 7
    str     r1, [pixels, #(4 * \i)]
    .endr
    adds    pixels, #30
    ldr     pc, [sp, #.LF_NEXT]
    .else
    ldrb    r1, [texels, r2]
    cbz     table, 1f
    ldrb    r1, [table, r1]
1:  bx      r3
    .endif
    .align  2
.Lclamped_stores:
    .irp    i, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16
    .if     WIDE
    strh.n  r1, [pixels, #(2 * \i)]
    .else
    strb.n  r1, [pixels, #\i]
    .endif
    .endr
    adds    pixels, #(16 << WIDE)
    ldr     pc, [sp, #.LF_NEXT]

.Lclamped_beyond:
    hold_within r1, r8, r3
    hold_within r2, r9, r4
    b       .Lclamped_paint

/* Some pixels are within the texture, others beyond it. r12: the texels, lr: where pixels end. */
.Lclamped_mixed:
    ldr     r6, [sp, #(.LF_SHORT + F_PUSHED)]
    str     r6, [sp, #(.LF_BEFORE + F_PUSHED)]
    ldr     r10, [sp, #(.LF_FACE + F_PUSHED)]
    ldr     r6, [sp, #(.LF_TABLE + F_PUSHED)]
    ldrd    r12, r11, [sp, #(.LF_TEXELS + F_PUSHED)]
    ldrb    r7, [r10, #SEGMENT_FACE_LOG_WIDTH]
    ldrb    r8, [r10, #SEGMENT_FACE_ROW_DROP]
    rsb     r7, r7, #16
    add     lr, pixels, #(16 << WIDE)
    add     pixels, pixels, r5, lsl #WIDE
1:  usat    r5, #16, r2
    lsr     r5, r5, r8
    and     r5, r5, r11
    usat    r10, #16, r1
    lsr     r10, r10, r7
    add     r5, r5, r10
    .if     WIDE
    cbz     r6, 2f
    ldrb    r5, [r12, r5]
    ldrh    r5, [r6, r5, lsl #1]
    b       3f
2:  ldrh    r5, [r12, r5, lsl #1]
3:  strh    r5, [pixels, #2]!
    .else
    ldrb    r5, [r12, r5]
    cbz     r6, 2f
    ldrb    r5, [r6, r5]
2:  strb    r5, [pixels, #1]!
    .endif
    add     r1, r1, r3
    add     r2, r2, r4
    cmp     pixels, lr
    bne     1b
    pop     {r7-r11}
    ldrd    u_0, v_0, [sp, #.LF_PREVIOUS]
    ldr     pc, [sp, #.LF_NEXT]

/* clang-format on */

#endif
