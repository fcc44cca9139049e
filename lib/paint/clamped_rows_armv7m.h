/* SPDX-License-Identifier: MIT */
/* Part of plain_rows_armv7m.h: rows of constant weight of a texture that does not repeat. Those that
 * lie within it as a whole are painted as the rows of a plain face, and the others by
 * clamped_texels_armv7m.h. Assembly. */
#ifndef FXL_CLAMPED_ROWS_ARMV7M_H
#define FXL_CLAMPED_ROWS_ARMV7M_H

/* clang-format off */

/* Where the first pixel of a row and the last one are within the texture, so are all, and the row is
 * painted as that of a plain face. The upper word of a coordinate within it is from 0 to the weight's,
 * shifted to the left by the drop less 10. The kernel's positions are off by less than 12 units of
 * 2^-16 of the texture, and 2 of the upper word; and the slope's upper word makes the coordinate of
 * column x too small by at most x, which is below 4096. Bounds are from 2^20 to 2^30, and slopes below
 * 2^23, so that U and V at the ends of segments do not wrap. */
    .macro  texture_bounds slope, drop, least, range
    clz     r4, r12
    cmp     \drop, r4
    blt     3f
    subs    \drop, \drop, #10
    bpl     1f
    rsb     \drop, \drop, #0
    lsr     \range, r12, \drop
    b       2f
1:  lsl     \range, r12, \drop
    asr     r4, \range, \drop
    cmp     r4, r12
    bne     3f
2:  lsr     \least, \range, #12
    add     r4, \slope, #0x800000
    cmp     r4, #0x1000000
    it      lo
    cmplo   \range, #0x40000000
    bhs     3f
    sub     \range, \range, \least, lsl #1
    add     \least, \least, #16
    sub     \range, \range, #4128
    cmp     \range, #0x100000
    bge     4f
3:  movs    \range, #0                  /* no row is known to be within */
4:
    .endm

    .macro  within_bounds slope, column, at, range
    mla     lr, \slope, \column, \at
    cmp     lr, \range
    bhs     .Lclamped_not_within
    .endm

/* The columns r2 to r3. */
    .align  2
.Lclamped_row:
    ldrd    r1, r0, [sp, #.LF_ROW]
    ldr     r12, [r1, #PAINT_ROW_WEIGHT + 4]
    add     r4, sp, #.LF_WITHIN
    ldm     r4, {r4-r10}
    cmp     r4, r12
    bne     .Lclamped_weight
.Lclamped_bounds:
    ldr     r11, [r1, #PAINT_ROW_U + 4]
    ldr     r12, [r1, #PAINT_ROW_V + 4]
    sub     r11, r11, r5
    sub     r12, r12, r7
    within_bounds r9, r2, r11, r6
    within_bounds r10, r2, r12, r8
    subs    r4, r3, #1
    within_bounds r9, r4, r11, r6
    within_bounds r10, r4, r12, r8
    ldr     r5, [sp, #.LF_LOG]
    strd    r3, r3, [sp, #.LF_X]
    movs    r4, #4
    cmp     r5, #LOG_WITHIN
    beq     .Lsame_log
    ldm     r0, {r6-r11}
    stm     sp, {r6-r10}
    str     r11, [sp, #.LF_V_HIGH]
    movs    r6, #0
    strd    r6, r6, [sp, #.LF_SHORT]
    movs    r6, #LOG_WITHIN
    str     r6, [sp, #.LF_LOG]
    ldrd    r6, r7, [sp, #.LF_PLAIN]
    strd    r6, r7, [sp, #.LF_CODE]
    str     r6, [sp, #.LF_FULL]
    adr     r7, .Lwithin_next + 1
    adr     r8, .Lwithin_resume + 1
    adr     r9, .Lwithin_begin + 1
    strd    r7, r8, [sp, #.LF_NEXT]
    str     r9, [sp, #.LF_BEGIN]
    b       .Lsame_log

/* Another weight, r12. */
.Lclamped_weight:
    ldr     r4, [r0, #SEGMENT_FACE_LEAST]
    cmp     r12, r4
    blt     .Lclamped_not_within
    ldr     r9, [r0, #(SEGMENT_FACE_U_STEP + 4)]
    ldr     r10, [r0, #(SEGMENT_FACE_V_STEP + 4)]
    ldrd    r11, lr, [sp, #.LF_U_DROP]
    asrs    r9, r9, #4
    asrs    r10, r10, #4
    texture_bounds r9, r11, r5, r6
    texture_bounds r10, lr, r7, r8
    mov     r4, r12
    add     r11, sp, #.LF_WITHIN
    stm     r11, {r4-r10}
    mvn     r11, #0x80000000
    reciprocal r11, lr, r12, r11, r12, r4
    str     r11, [sp, #.LF_RECIPROCAL]
    b       .Lclamped_bounds

.Lclamped_not_within:
    ldr     r4, [sp, #.LF_LOG]
    cmp     r4, #LOG_WITHIN
    bne     .Lface_weights
    adr     r4, .Lclamped + 1
    movs    r5, #0
    strd    r4, r5, [sp, #.LF_CODE]
    ldr     r4, [sp, #.LF_FIRST]
    str     r4, [sp, #.LF_BEGIN]
    b       .Lface_weights

/* .Lbegin of a row that is within; the reciprocal is kept in w. */
    .align  2
.Lwithin_begin:
    begin_coordinates
    clz     r2, w
    ldr     w, [sp, #.LF_RECIPROCAL]
    ldrd    r4, r5, [sp, #.LF_U_DROP]
    subs    r4, r4, r2
    subs    r5, r5, r2
    strd    r4, r5, [sp, #.LF_DROPS]
    smull   r1, u_0, u, w
    asr     u_0, u_0, r4
    smull   r1, v_0, v, w
    asr     v_0, v_0, r5
    ldr     pc, [sp, #.LF_RESUME]

    .align  2
.Lwithin_next:
    ldrd    r3, r4, [sp, #.LF_LAST]
    cmp     pixels, r3
    bhi     .Lrest
    .align  2
.Lwithin_resume:
    add     r1, sp, #8
    ldm     r1, {r1-r5}                 /* of u; of v, with F_W_LOW in between */
    adds    u_low, u_low, r1
    adc     u, u, r2
    adds    v_low, v_low, r3
    adc     v, v, r5
    ldrd    r4, r5, [sp, #.LF_DROPS]
    smull   r1, r2, u, w
    asrs    r2, r2, r4
    smull   r1, r4, v, w
    asrs    r4, r4, r5
    paint_between 4, 0

/* clang-format on */

#endif
