/* SPDX-License-Identifier: MIT */
/* Part of plain_rows_armv6m.S: rows of constant weight, and what a frame has of a face. Assembly. */
#ifndef FXL_PLAIN_FACES_ARMV6M_H
#define FXL_PLAIN_FACES_ARMV6M_H

/* clang-format off */

/* --- rows of constant weight ---------------------------------------------------------------- */

    .type   fxl_paint_line, %function
    .thumb_func

/* r0: face, r1: row, r2: line */
fxl_paint_line:
    enter
    str     r1, [sp, #F_RECORD]
    ldr     r1, [r2, #RUN_CODE]
    bl      .Lface
    ldmia   r2!, {r0, r1}
    adds    r2, #LINE_U - 8
    mov     r3, sp
    ldmia   r2!, {r4-r7}
    stmia   r3!, {r4-r7}
    ldr     r2, [r2]
    str     r2, [r3]
    movs    r2, #4
    bl      .Lset_log
    place
    ldr     r0, =.Lreturn
    str     r0, [sp, #F_DONE]
    ldr     r0, =.Lline_after + 1
    mov     lr, r0
    ldr     r0, =.Lpaint_whole
    str     r0, [sp, #F_WHOLE]
    ldr     r0, =.Lpaint_part
    mov     r12, r0
.Lline:
    ldr     r0, [sp, #F_W]
    ldr     p, [sp, #F_W + 4]
    ldr     step, [sp, #F_STEP]
    lsrs    r0, r0, #16
    lsls    r0, r0, #16
    lsrs    p, p, #16
    orrs    p, r0
    mov     pc, r12

    .align  2
.Lline_after:
    mov     r6, sp
    ldmia   r6!, {r0, r1, r3, r4}
    adds    r0, r0, r3
    adds    r1, r1, r4
    str     r0, [sp, #F_W]
    str     r1, [sp, #F_W + 4]
    after   .Lline, .Lpaint_part
    b       .Lline
    .ltorg

/* --- what the frame has of a face ----------------------------------------------------------- */

/* r0: face, r1: code. Keeps r2. */
.Lface:
    str     r0, [sp, #F_FACE]
    movs    r4, #0
    mov     r8, r4                      /* those of no weight */
    mvns    r4, r4
    str     r4, [sp, #F_LOG]
    movs    r4, #1
    lsls    r4, r4, #31
    mov     r10, r4
    ldr     r4, =.Lreciprocals - 256
    mov     r9, r4
    ldr     r4, =.Lwhole
    str     r4, [sp, #F_WHOLE]
    movs    r3, r0
    adds    r3, #SEGMENT_FACE_U_DROP
    ldmia   r3!, {r4-r7}
    str     r4, [sp, #F_U_DROP]
    str     r5, [sp, #F_V_DROP]
    str     r6, [sp, #F_TEXELS]
    str     r7, [sp, #F_MASK]
    ldmia   r1!, {r4}
    str     r4, [sp, #F_WIDE]
    ldr     r5, [r1, #CODE_LOOP - 4]
    str     r5, [sp, #F_PAINT]
    cmp     r4, #0
    beq     1f
    movs    r5, #SEGMENT_FACE_IN_BEAM
    ldr     r6, [r0, r5]
    str     r6, [sp, #F_IN_BEAM]
    movs    r5, #SEGMENT_FACE_PALETTE
    ldr     r6, [r0, r5]
    str     r6, [sp, #F_TABLE]
    cmp     r6, #0
    beq     1f
    adds    r1, #CODE_PALETTE - CODE_PLAIN
1:  movs    r5, #SEGMENT_FACE_FORM
    ldrb    r4, [r0, r5]
    cmp     r4, #0
    beq     3f
    ldmia   r1!, {r5, r6, r7}           /* the address, and the bytes of 16 pixels and of one */
    muls    r4, r6
    adds    r4, r4, r5
    movs    r5, r7
    b       4f
3:  movs    r5, #SEGMENT_FACE_LOG_WIDTH
    ldrb    r5, [r0, r5]
    movs    r6, #32
    subs    r6, r6, r5
    str     r6, [sp, #F_COLUMN]
    movs    r5, #SEGMENT_FACE_ROW_DROP
    ldrb    r5, [r0, r5]
    str     r5, [sp, #F_ROW]
    movs    r5, #0
    ldr     r4, =.Lloop_part + 1
4:  str     r4, [sp, #F_CODE_0]
    str     r5, [sp, #F_PIXEL]
    bx      lr

/* What it has of segments of 2^r2 columns: a step is that of 16, shifted. Keeps r0 to r2. */
.Lset_log:
    str     r2, [sp, #F_LOG]
    movs    r3, #1
    lsls    r3, r2
    subs    r4, r3, #1
    str     r4, [sp, #F_COLUMNS]
    movs    r4, #16
    subs    r4, r4, r3
    ldr     r5, [sp, #F_PIXEL]
    ldr     r6, [sp, #F_CODE_0]
    cmp     r5, #0
    bne     1f
    ldr     r6, =.Lloop_whole + 1
1:  muls    r5, r4
    adds    r5, r5, r6
    str     r5, [sp, #F_CODE]
    ldr     r6, [sp, #F_WIDE]
    lsls    r4, r6
    lsls    r3, r6
    str     r4, [sp, #F_BACK]
    str     r3, [sp, #F_WIDTH]
    adds    r3, r2, #4
    str     r3, [sp, #F_SHIFT]
    movs    r3, #8
    lsls    r3, r2
    str     r3, [sp, #F_ROUND]
    movs    r3, #4
    subs    r3, r3, r2
    movs    r2, #32
    subs    r2, r2, r3
    ldr     r7, [sp, #F_FACE]
    .irp    at, F_W_STEP, F_U_STEP, F_V_STEP
    ldmia   r7!, {r4, r5}
    mov     r6, r5
    lsls    r6, r2
    lsrs    r4, r3
    orrs    r4, r6
    asrs    r5, r3
    str     r4, [sp, #\at]
    str     r5, [sp, #\at + 4]
    .endr
    ldr     r2, [sp, #F_LOG]
    bx      lr
    .ltorg

/* clang-format on */

#endif
