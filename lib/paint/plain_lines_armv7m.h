/* SPDX-License-Identifier: MIT */
/* Part of plain_rows_armv7m.h: rows of constant weight. Assembly. */
#ifndef FXL_PLAIN_LINES_ARMV7M_H
#define FXL_PLAIN_LINES_ARMV7M_H

/* clang-format off */

/* The change of a coordinate in 16 columns and in one. lr: face, r3: the reciprocal, r9: its leading
 * zeros. Overwrites r4 to r7; \change may be lr. */
    .macro  line_change more, change, face_step, drop, left
    ldrd    r4, r5, [lr, #\face_step]
    cmn     r4, #0x80000000
    adc     r5, r5, #0
    smull   r4, r5, r5, r3
    ldr     r6, [sp, #\drop]
    add     r6, r6, #(32 - 12)          /* FXL_ROW_BITS */
    sub     r6, r6, r9
    str     r6, [sp, #\left]
    subs    r7, r6, #32
    bmi     1f
    asr     \more, r5, r7
    adds    r7, #4
    asr     \change, r5, r7
    b       2f
1:  rsb     r7, r6, #32
    lsl     \more, r5, r7
    lsr     r4, r4, r6
    orr     \more, \more, r4
    asr     r5, r5, r6
    lsl     r5, r5, #28
    orr     \change, r5, \more, lsr #4
2:
    .endm

    .macro  line_position
    lsr     p, v, #16
    lsr     r3, u, #16
    add     p, p, r3, lsl #16
    .endm

/* A coordinate at the segment r12, where it has what it is more in the middle of 16 columns. r1: row, r3: the
 * reciprocal. Overwrites r4, r5 and r7. */
    .macro  line_at at, more, row_value, left
    mla     \at, \more, r12, \at
    ldr     r4, [r1, #(\row_value + 4)]
    smull   r5, r4, r4, r3
    subs    r7, \left, #32
    bmi     1f
    asr     r4, r4, r7
    add     \at, \at, r4
    b       2f
1:  rsb     r7, \left, #32
    lsl     r4, r4, r7
    lsr     r5, r5, \left
    add     \at, \at, r4
    add     \at, \at, r5
2:
    .endm

    .align  2
.Lline:
    ldr     r1, [sp, #.LF_ROW]
    ldr     r7, [r1, #PAINT_ROW_WEIGHT + 4]
    and     r6, r2, #15
    sub     r5, r5, #(1 << WIDE)
    add     r3, r5, r3, lsl #WIDE
    sub     r8, r3, #(16 << WIDE)
    strd    r8, r3, [sp, #.LF_LAST]
    str     r6, [sp, #.LF_SKIP]
    sub     r3, r2, r6
    lsr     r12, r2, #4
    add     pixels, r5, r3, lsl #WIDE   /* the address before the segment */
    ldr     r4, [sp, #.LF_LINE]
    cmp     r4, r7
    bne     .Lother_line
.Lsame_line:
    ldm     sp, {r2, r3, r8-r11}        /* step, the reciprocal, u_more, u, v_more, v */
    ldrd    r6, lr, [sp, #.LF_U_LEFT]
    line_at u, u_more, PAINT_ROW_U, r6
    line_at v, v_more, PAINT_ROW_V, lr
    ldr     last, [sp, #.LF_LAST]
    ldrd    texels, mask, [sp, #.LF_TEXELS]
    ldr     table, [sp, #.LF_TABLE]
    line_position
    ldr     r3, [sp, #.LF_SKIP]
    cmp     pixels, last
    it      ls
    cmpls   r3, #0
    bne     .Lpartial
    ldr     pc, [sp, #.LF_FULL]

.Lother_line:
    ldr     lr, [sp, #.LF_FACE]
    ldr     r4, [lr, #SEGMENT_FACE_LEAST + 12]
    cmp     r7, r4
    blt     .Lnot_ours
    str     r7, [sp, #.LF_LINE]
    mvn     r3, #0x80000000
    reciprocal r3, r9, r7, r3, r4, r5
    line_change u_more, r2, SEGMENT_FACE_U_STEP, .LF_U_DROP, .LF_U_LEFT
    line_change v_more, lr, SEGMENT_FACE_V_STEP, .LF_U_DROP + 4, .LF_V_LEFT
    add     r4, r2, #0x8000
    add     r5, lr, #0x8000
    lsr     r4, r4, #16
    asr     r5, r5, #16
    sub     r9, r2, r4, lsl #16
    sub     r11, lr, r5, lsl #16
    lsl     r9, r9, #3
    lsl     r11, r11, #3
    add     r9, r9, #0x8000
    add     r11, r11, #0x8000
    add     step, r5, r4, lsl #16
    stm     sp, {r2, r3, r8-r11}
    b       .Lsame_line

/* Less than 16 columns are left, or nothing. */
    .align  2
.Lline_rest:
    ldr     r3, [sp, #.LF_END]
    cmp     pixels, r3
    it      hs
    ldrhs   pc, [sp, #.LF_DONE]
    add     u, u, u_more
    add     v, v, v_more
    line_position
    b       .Llast_partial

    .align  2
.Lline_next:
    cmp     pixels, last
    bhi     .Lline_rest
    add     u, u, u_more
    add     v, v, v_more
    line_position
    ldr     pc, [sp, #.LF_FULL]

/* clang-format on */

#endif
