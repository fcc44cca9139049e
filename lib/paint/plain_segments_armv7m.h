/* SPDX-License-Identifier: MIT */
/* Part of plain_rows_armv7m.h: segments, from one end to the next, and the pixels of a part of one.
 * Assembly. */
#ifndef FXL_PLAIN_SEGMENTS_ARMV7M_H
#define FXL_PLAIN_SEGMENTS_ARMV7M_H

/* clang-format off */

/* The position and the step of a segment of 2^log columns. r2: U, r4: V at its end. Goes on to its
 * pixels. Where v is not repeated, a position beyond the texture takes its carry away from u: so u is
 * right at the pixels that are within. */
    .macro  paint_between log, repeats=1
    .if     \repeats
    ubfx    p, v_0, #4, #16
    .else
    asr     p, v_0, #4
    .endif
    lsr     r3, u_0, #4
    add     p, p, r3, lsl #16
    sub     r3, r2, u_0
    sub     r5, r4, v_0
    mov     u_0, r2
    mov     v_0, r4
    adds    r3, #(8 << \log)
    adds    r5, #(8 << \log)
    asrs    r3, r3, #(4 + \log)
    .if     \repeats
    sbfx    r5, r5, #(4 + \log), #16
    .else
    asrs    r5, r5, #(4 + \log)
    .endif
    add     step, r5, r3, lsl #16
    .if     \log < 4
    subs    pixels, #((16 - (1 << \log)) << WIDE)
    .endif
    add     r3, sp, #.LF_TEXELS
    ldm     r3, {texels, mask, table, pc}   /* F_GO */
    .endm

/* What is linear, at the end of the next segment. */
    .macro  next_values
    ldm     sp, {r1-r5, w_low}
    adds    w_low, w_low, r1
    adc     w, w, r2
    str     w_low, [sp, #.LF_W_LOW]
    adds    u_low, u_low, r3
    adc     u, u, r4
    adds    v_low, v_low, r5
    ldr     r5, [sp, #.LF_V_HIGH]
    adc     v, v, r5
    .endm

    .macro  segments log
    .align  2
.Lsegment_\log:
    ldrd    r3, r4, [sp, #.LF_LAST]
    cmp     pixels, r3
    bhi     .Lrest
    .align  2
.Lresume_\log:
    next_values
    divide  r2, r4, r4, r5, r1, r1, .Lfar
.Lbetween_\log:
    paint_between \log
    .endm

    segments 4
    segments 3
    segments 2

/* Fewer leading zeros in a drop: some bits come from the lower word. */
.Lfar:
    smull   r1, r2, u, r3
    shift_down r2, r1, r4
    smull   r1, r4, v, r3
    shift_down r4, r1, r5
    ldr     r3, [sp, #.LF_LOG]
    cmp     r3, #3
    beq     .Lbetween_3
    blo     .Lbetween_2
    b       .Lbetween_4

/* The same of a texture that does not repeat. One texel fills a segment, or it goes on as that of a
 * plain face does. */
    .macro  clamped_segments log
    .align  2
.Lclamped_resume_\log:
    strd    u_0, v_0, [sp, #.LF_PREVIOUS]
    b.w     .Lresume_\log
    .align  2
.Lclamped_segment_\log:
    ldrd    r3, r4, [sp, #.LF_LAST]
    cmp     pixels, r3
    bhi.w   .Lrest
    next_values
    divide  r2, r4, r4, r5, r1, r1, .Lfar
    usat    r5, #16, u_0, asr #4
    usat    r3, #16, r2, asr #4
    cmp     r5, r3
    bne.w   .Lbetween_\log
    usat    r6, #16, v_0, asr #4
    usat    r3, #16, r4, asr #4
    cmp     r6, r3
    bne.w   .Lbetween_\log
    mov     u_0, r2
    mov     v_0, r4
    strd    u_0, v_0, [sp, #.LF_PREVIOUS]
    .if     \log < 4
    subs    pixels, #((16 - (1 << \log)) << WIDE)
    .endif
    .if     WIDE && \log == 4
    adr     r3, .Lclamped_words + 1
    .else
    adr     r3, .Lclamped_stores + 1 + 2 * (16 - (1 << \log))
    .endif
    b.w     .Lclamped_fill
    .endm

    clamped_segments 4
    clamped_segments 3
    clamped_segments 2

/* Each pixel divided: U and V at a pixel; of a texture that does not repeat, held within it. */
    .align  2
.Lclamped_each:
    usat    p, #16, v_0, asr #4
    usat    r3, #16, u_0, asr #4
    b       .Leach_texel
    .align  2
.Lsegment_0:
    ldr     r3, [sp, #.LF_LAST]
    cmp     pixels, r3
    bhi     .Lrun_end
    next_values
    divide_and_resume
    .align  2
.Leach:
    ubfx    p, v_0, #4, #16
    lsr     r3, u_0, #4
.Leach_texel:
    add     p, p, r3, lsl #16
    subs    pixels, #(15 << WIDE)
    add     r3, sp, #.LF_TEXELS
    ldm     r3, {texels, mask, table, pc}   /* F_GO */

    .if     WIDE
/* The same where texels are pixels, of a texture that has code of its own: U and V are shifted on to the
 * column and the row. r5: F_LAST. */
    .align  2
.Leach_colour:
    ldr     texels, [sp, #.LF_TEXELS]
    ldr     r5, [sp, #.LF_LAST]
    ldr     w_low, [sp, #.LF_W_LOW]
    b       2f
.Leach_colour_far:
    str     w_low, [sp, #.LF_W_LOW]
    mov     r4, r2
    mov     r5, r1
    b       .Lfar_start
    .align  2
1:  ldm     sp, {r1-r3, r12, lr}
    adds    w_low, w_low, r1
    adcs    w, w, r2
    adds    u_low, u_low, r3
    adc     u, u, r12
    adds    v_low, v_low, lr
    ldr     r3, [sp, #.LF_V_HIGH]
    adc     v, v, r3
    divide  r12, lr, r2, r1, lr, r2, .Leach_colour_far
2:  ldrd    r1, r2, [sp, #(.LF_TEXELS + 4)] /* the mask and F_COLUMNS */
    and     r1, r1, lr
    and     r2, r2, r12
    adds    r1, r1, r2
    ldrh    r1, [texels, r1, lsl #1]
    strh    r1, [pixels, #2]!
    cmp     pixels, r5
    bls     1b
    b       .Lrun_end
    .endif

/* Less than a segment is left, or nothing. r4: F_END. */
    .align  2
.Lrest:
    cmp     pixels, r4
    bhs     .Lrun_end
    adr     r3, .Llast_partial + 1
    str     r3, [sp, #.LF_GO]
    ldr     pc, [sp, #.LF_RESUME]

/* The same as below where the run ends in the segment: the code of 16 pixels ends at its end. */
    .align  2
.Lonly:
    ldrd    r5, r3, [sp, #.LF_SKIP]     /* and F_SHORT */
    mla     p, step, r5, p
    add     r3, r3, r5
    b       1f
    .align  2
.Llast_partial:
    ldr     r3, [sp, #.LF_SHORT]
1:  ldr     r5, [sp, #.LF_END]
    subs    r4, r5, pixels
    rsb     r4, r4, #(16 << WIDE)
    sub     pixels, r5, #(16 << WIDE)
    add     r3, r3, r4, lsr #WIDE
    str     r3, [sp, #.LF_BEFORE]
    ldrd    r4, r5, [sp, #.LF_CODE]
    mla     r3, r3, r5, r4
    ldrd    texels, mask, [sp, #.LF_TEXELS]
    bx      r3

/* The same as below where it does not end there. */
    .align  2
.Lskipping:
    ldrd    r5, r3, [sp, #.LF_SKIP]
    mla     p, step, r5, p
    add     r3, r3, r5
    b       1f

/* Pixels from F_SKIP on, up to the end of the run or of the segment: the last ones of the code of 16
 * pixels, whose first pixel is before them by as many as are left out. */
    .align  2
.Lpartial:
    ldr     r5, [sp, #.LF_SKIP]
    mla     p, step, r5, p
    ldr     r4, [sp, #.LF_SHORT]
    ldr     r3, [sp, #.LF_END]
    add     r5, r5, r4
    subs    r3, r3, pixels
    rsb     r3, r3, #(16 << WIDE)       /* what of 16 pixels is beyond the end */
    bic     r3, r3, r3, asr #31
    subs    pixels, pixels, r3
    add     r3, r5, r3, lsr #WIDE
1:  str     r3, [sp, #.LF_BEFORE]
    ldr     r4, [sp, #.LF_FULL]
    str     r4, [sp, #.LF_GO]
    ldrd    r4, r5, [sp, #.LF_CODE]
    mla     r3, r3, r5, r4
    ldrd    texels, mask, [sp, #.LF_TEXELS]
    bx      r3

/* Any size. */
    .align  2
.Lloop:
    push    {r6-r11}
    mov     r11, table
    add     r3, sp, #(.LF_COLUMN + 24)
    ldm     r3, {r6, r7}
    add     r8, pixels, #(16 << WIDE)
    ldr     r3, [sp, #(.LF_BEFORE + 24)]
    add     pixels, pixels, r3, lsl #WIDE
    ldr     r3, [sp, #(.LF_SHORT + 24)]
    str     r3, [sp, #(.LF_BEFORE + 24)]
    cmp     r11, #0
    beq     2f
    .if     WIDE
    mov     r10, step
    ldr     r2, [sp, #(.LF_FACE + 24)]
    ldr     r2, [r2, #SEGMENT_FACE_IN_BEAM]
    .endif
1:  lsr     r3, p, r7
    ands    r3, mask
    lsr     r9, p, r6
    add     r3, r3, r9
    ldrb    r3, [texels, r3]
    .if     WIDE
    cbz     r2, 4f
    ldrb    r3, [r2, r3]
4:  ldrh    r3, [r11, r3, lsl #1]
    strh    r3, [pixels, #2]!
    add     p, p, r10
    .else
    ldrb    r3, [r11, r3]
    strb    r3, [pixels, #1]!
    add     p, step
    .endif
    cmp     pixels, r8
    bne     1b
    .if     WIDE
    mov     step, r10
    .endif
    b       3f
2:  lsr     r3, p, r7
    ands    r3, mask
    lsr     r9, p, r6
    add     r3, r3, r9
    .if     WIDE
    ldrh    r3, [texels, r3, lsl #1]
    strh    r3, [pixels, #2]!
    .else
    ldrb    r3, [texels, r3]
    strb    r3, [pixels, #1]!
    .endif
    add     p, step
    cmp     pixels, r8
    bne     2b
3:  pop     {r6-r11}
    ldr     pc, [sp, #.LF_NEXT]

/* clang-format on */

#endif
