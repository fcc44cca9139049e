/* SPDX-License-Identifier: MIT */
/* fxl_paint_plain_rows, fxl_paint_run and fxl_paint_line for Armv6-M. lib/paint/plain_run.h states what they
 * require and do. A segment takes 134 instructions beside its pixels, and 16 columns of a row of constant
 * weight take 26. A row takes 130 before its first segment, and a run of segments 90. */
#include "../math/family.h"
#include "../math/offsets.h"
#include "../math/registers_armv6m.h"

#if FXL_KERNELS_ARMV6M

#include "plain_rows_armv6m.h"

    .syntax unified
    .thumb
    .section .text.fxl_paint_plain_rows, "ax", %progbits
    .global fxl_paint_plain_rows
    .global fxl_paint_run
    .global fxl_paint_line

/* r8     the zeros of the weight
 * r9     the reciprocals, less 256 bytes
 * r10    2^31
 * r11    what divides u and v
 * r12    what follows that: the first end, a whole segment or a part of one
 * lr     what follows the pixels */

/* low:high becomes its product with segment, which is below 2^16. The middle sum is at most
 * (2^16 - 1) 2^16. spare may be segment, which is overwritten then. */
    .macro  times low, high, segment, part, spare
    uxth    \part, \low
    lsrs    \low, \low, #16
    muls    \part, \segment
    muls    \low, \segment
    muls    \high, \segment
    lsrs    \spare, \part, #16
    adds    \low, \low, \spare
    lsrs    \spare, \low, #16
    adds    \high, \high, \spare
    lsls    \low, \low, #16
    uxth    \part, \part
    orrs    \low, \part
    .endm

    .macro  enter
    save_registers
    sub     sp, #F_SIZE
    .endm

/* Which of 16 pixels a run paints, from column r0 on, before r1, in segments of 2^r2 columns. r3 becomes the
 * column at which the first segment begins, r6 the row. */
    .macro  place
    ldr     r4, [sp, #F_COLUMNS]
    ands    r4, r0
    str     r4, [sp, #F_SKIP]
    subs    r3, r0, r4
    ldr     r6, [sp, #F_RECORD]
    ldr     r7, [r6, #PAINT_ROW_PIXELS]
    ldr     r4, [sp, #F_WIDE]
    movs    r5, r3
    lsls    r5, r4
    lsls    r1, r4
    ldr     r4, [sp, #F_BACK]
    subs    r7, r7, r4
    adds    r5, r5, r7
    str     r5, [sp, #F_PIXELS]
    adds    r1, r1, r7
    str     r1, [sp, #F_STOP]
    ldr     r4, [sp, #F_WIDTH]
    subs    r1, r1, r4
    str     r1, [sp, #F_LAST]
    .endm

    .type   fxl_paint_run, %function
    .thumb_func

/* r0: face, r1: row, r2: run */
fxl_paint_run:
    enter
    str     r1, [sp, #F_RECORD]
    ldr     r1, [r2, #RUN_CODE]
    bl      .Lface
    ldr     r0, =.Lreturn
    str     r0, [sp, #F_DONE]
    ldmia   r2!, {r0, r1}
    ldr     r2, [r2, #RUN_LOG - 8]
    b       .Lrun

    .type   fxl_paint_plain_rows, %function
    .thumb_func

/* r0: rows, r1: code. Returns 0, or 1 at a row that is not the kernel's. */
fxl_paint_plain_rows:
    enter
    str     r0, [sp, #F_RECORD]
    ldr     r0, [r0, #PAINT_ROW_SEGMENTS]
    bl      .Lface
    ldr     r0, =.Lrun_done
    str     r0, [sp, #F_DONE]
    ldr     r6, [sp, #F_RECORD]
    movs    r7, r6
    adds    r7, #PLAIN_ROWS_EDGES
    ldr     r0, [r7]
    ldr     r1, [r7, #EDGE_SIZE]
    b       .Lrow

    .align  2
.Lrun_done:
    ldr     r0, [sp, #F_X]
    ldr     r1, [sp, #F_X_END]
    cmp     r0, r1
    beq     .Lnext_row
    b       .Lfind

.Lnext_row:
    ldr     r6, [sp, #F_RECORD]
    movs    r7, r6
    adds    r7, #PLAIN_ROWS_DOWNS
    ldmia   r6!, {r0-r3}
    ldmia   r7!, {r4, r5}
    adds    r0, r0, r4
    adcs    r1, r5
    ldmia   r7!, {r4, r5}
    adds    r2, r2, r4
    adcs    r3, r5
    subs    r6, #16
    stmia   r6!, {r0-r3}
    ldmia   r6!, {r0, r1}
    ldmia   r7!, {r4, r5}
    adds    r0, r0, r4
    adcs    r1, r5
    subs    r6, #8
    stmia   r6!, {r0, r1}
    ldmia   r7!, {r0-r3}                /* the edges */
    adds    r1, r1, r3
    adcs    r0, r2
    subs    r7, #16
    stmia   r7!, {r0, r1}
    adds    r7, #8
    ldmia   r7!, {r1-r4}
    adds    r2, r2, r4
    adcs    r1, r3
    subs    r7, #16
    stmia   r7!, {r1, r2}
    ldr     r2, [r7, #PLAIN_ROWS_END - PLAIN_ROWS_EDGES - EDGE_SIZE - 8]
    ldr     r3, [r7, #PLAIN_ROWS_STRIDE - PLAIN_ROWS_EDGES - EDGE_SIZE - 8]
    subs    r6, #PAINT_ROW_LIGHT - 4
    ldr     r4, [r6, #PAINT_ROW_PIXELS]
    adds    r4, r4, r3
    str     r4, [r6, #PAINT_ROW_PIXELS]
    ldr     r4, [r6, #PAINT_ROW_Y]
    adds    r4, #1
    str     r4, [r6, #PAINT_ROW_Y]
    cmp     r4, r2
    blt     .Lrow
    b       .Lreturn

/* r0, r1: the edges' columns, r6: rows */
.Lrow:
    cmp     r0, r1
    beq     .Lnext_row
    blt     1f
    movs    r2, r0
    movs    r0, r1
    movs    r1, r2
1:  ldr     r7, [sp, #F_FACE]
    ldr     r2, [r7, #SEGMENT_FACE_WEIGHT_STEP]
    ldr     r3, [r7, #SEGMENT_FACE_WEIGHT_STEP + 4]
    lsrs    r4, r0, #4
    times   r2, r3, r4, r5, r4
    ldr     r5, [r6, #PAINT_ROW_WEIGHT]
    adds    r2, r2, r5
    ldr     r5, [r6, #PAINT_ROW_WEIGHT + 4]
    adcs    r3, r5
    str     r2, [sp, #F_W]
    str     r3, [sp, #F_W + 4]
    ldr     r2, [r7, #SEGMENT_FACE_WEIGHT_STEP]
    ldr     r3, [r7, #SEGMENT_FACE_WEIGHT_STEP + 4]
    movs    r4, r1
    adds    r4, #15
    lsrs    r4, r4, #4
    times   r2, r3, r4, r5, r4
    ldr     r5, [r6, #PAINT_ROW_WEIGHT]
    adds    r2, r2, r5
    ldr     r5, [r6, #PAINT_ROW_WEIGHT + 4]
    adcs    r3, r5
    ldr     r2, [sp, #F_W + 4]
    cmp     r2, r3
    ble     1f
    movs    r2, r3
1:  ldr     r3, [r7, #SEGMENT_FACE_LEAST]
    str     r1, [sp, #F_X_END]
    cmp     r2, r3
    blt     1f
    str     r1, [sp, #F_X]
    movs    r2, #4
    ldr     r3, [sp, #F_LOG]
    cmp     r2, r3
    beq     2f
    bl      .Lset_log
    ldr     r3, =.Lafter + 1
    mov     lr, r3
2:  place
    lsrs    r3, r3, #4
    b       .Lbegin_texels
1:  ldr     r3, [r7, #SEGMENT_FACE_LEAST + 12]
    cmp     r2, r3
    bge     1f
    movs    r0, #1
    b       .Lleave
1:  ldr     r2, [sp, #F_W]
    ldr     r3, [sp, #F_W + 4]
    b       1f

/* The columns that have segments of the same length, from r0 on. The weight is linear: the least one of 16 columns
 * is that at their left end if it rises, and that at their right end if it falls. */
.Lfind:
    ldr     r6, [sp, #F_RECORD]
    ldr     r7, [sp, #F_FACE]
    ldr     r2, [r7, #SEGMENT_FACE_WEIGHT_STEP]
    ldr     r3, [r7, #SEGMENT_FACE_WEIGHT_STEP + 4]
    lsrs    r4, r0, #4
    times   r2, r3, r4, r5, r4
    ldr     r5, [r6, #PAINT_ROW_WEIGHT]
    adds    r2, r2, r5
    ldr     r5, [r6, #PAINT_ROW_WEIGHT + 4]
    adcs    r3, r5
1:  lsrs    r1, r0, #4
    adds    r1, #1
    lsls    r1, r1, #4
    ldr     r4, [r7, #SEGMENT_FACE_WEIGHT_STEP]
    ldr     r5, [r7, #SEGMENT_FACE_WEIGHT_STEP + 4]
    cmp     r5, #0
    blt     .Lfalling
    ldr     r6, [r7, #SEGMENT_FACE_LEAST]
    cmp     r3, r6
    bge     .Lall_16
    ldr     r6, [r7, #SEGMENT_FACE_LEAST + 4]
    cmp     r3, r6
    blt     1f
    ldr     r6, [r7, #SEGMENT_FACE_LEAST]
    movs    r7, #3
    b       3f
1:  ldr     r6, [r7, #SEGMENT_FACE_LEAST + 8]
    cmp     r3, r6
    blt     2f
    ldr     r6, [r7, #SEGMENT_FACE_LEAST + 4]
    movs    r7, #2
    b       3f
2:  movs    r7, #0
3:  mov     r12, r7
    ldr     r7, [sp, #F_X_END]
4:  cmp     r1, r7
    bge     .Lto_end
    adds    r2, r2, r4
    adcs    r3, r5
    cmp     r3, r6
    bge     .Lfound
    adds    r1, #16
    b       4b

.Lall_16:
    movs    r7, #4
    mov     r12, r7
    b       .Lto_end

.Lfalling:
    adds    r2, r2, r4
    adcs    r3, r5
    ldr     r6, [r7, #SEGMENT_FACE_LEAST]
    cmp     r3, r6
    blt     1f
    movs    r7, #4
    b       3f
1:  ldr     r6, [r7, #SEGMENT_FACE_LEAST + 4]
    cmp     r3, r6
    blt     2f
    movs    r7, #3
    b       3f
2:  ldr     r6, [r7, #SEGMENT_FACE_LEAST + 8]
    movs    r7, #2
    cmp     r3, r6
    bge     3f
    movs    r7, #0
    mov     r12, r7
    b       .Lto_end
3:  mov     r12, r7
    ldr     r7, [sp, #F_X_END]
4:  cmp     r1, r7
    bge     .Lto_end
    adds    r2, r2, r4
    adcs    r3, r5
    cmp     r3, r6
    blt     .Lfound
    adds    r1, #16
    b       4b
.Lto_end:
    ldr     r1, [sp, #F_X_END]
.Lfound:
    str     r1, [sp, #F_X]
    mov     r2, r12

/* A run of segments of 2^r2 columns: the columns from r0 on, before r1. */
.Lrun:
    ldr     r3, [sp, #F_LOG]
    cmp     r2, r3
    beq     1f
    bl      .Lset_log
    ldr     r3, =.Lafter + 1
    mov     lr, r3
1:  place
    lsrs    r3, r2                      /* the first segment's number, below 2^16 */
    ldr     r4, [sp, #F_W_STEP]
    ldr     r5, [sp, #F_W_STEP + 4]
    times   r4, r5, r3, r0, r1
    ldr     r0, [r6, #PAINT_ROW_WEIGHT]
    ldr     r1, [r6, #PAINT_ROW_WEIGHT + 4]
    adds    r4, r4, r0
    adcs    r5, r1
    str     r4, [sp, #F_W]
    str     r5, [sp, #F_W + 4]

/* The texels at the beginning of segment r3, of the row in r6. */
.Lbegin_texels:
    adds    r6, #PAINT_ROW_U
    add     r0, sp, #F_U_STEP
    add     r2, sp, #F_U
    .rept   2
    ldmia   r0!, {r4, r5}
    mov     r1, r6
    times   r4, r5, r3, r6, r7
    mov     r6, r1
    ldmia   r6!, {r1, r7}
    adds    r4, r4, r1
    adcs    r5, r7
    stmia   r2!, {r4, r5}
    .endr
    adr     r0, .Lfirst
    mov     r12, r0
    ldr     r1, [sp, #F_W + 4]
    b       .Ldivide
    .ltorg

    .align  2
.Lfirst:
    str     r7, [sp, #F_U_0]
    str     r0, [sp, #F_V_0]
    ldr     r1, [sp, #F_WHOLE]
    mov     r12, r1
    ldr     r0, [sp, #F_SKIP]
    cmp     r0, #0
    bne     1f
    ldr     r0, [sp, #F_PIXELS]
    ldr     r2, [sp, #F_LAST]
    cmp     r0, r2
    bhi     1f
    b       .Lnext
1:  adr     r1, .Lpart
    mov     r12, r1
    b       .Lnext

/* The step of a pixel and the position of the first one: r7, r0: U and V at the segment's end. */
    .macro  find_step
    ldr     r1, [sp, #F_U_0]
    ldr     r2, [sp, #F_V_0]
    str     r7, [sp, #F_U_0]
    str     r0, [sp, #F_V_0]
    ldr     r5, [sp, #F_ROUND]
    ldr     r6, [sp, #F_SHIFT]
    subs    r7, r7, r1
    adds    r7, r7, r5
    asrs    r7, r6
    subs    r0, r0, r2
    adds    r0, r0, r5
    asrs    r0, r6
    lsls    r7, r7, #16
    sxth    r0, r0
    adds    step, r7, r0
    lsls    p, p, #12
    lsrs    p, p, #16
    lsls    p, p, #16
    lsls    r2, r2, #12
    lsrs    r2, r2, #16
    orrs    p, r2
    .endm

/* A part of a segment. */
    .align  2
.Lpart:
    find_step
.Lpaint_part:
    ldr     r2, [sp, #F_PIXELS]
    ldr     r5, [sp, #F_LAST]
    ldr     r6, [sp, #F_BACK]
    ldr     r3, [sp, #F_SKIP]
    cmp     r3, #0
    beq     2f
    movs    r0, r3
    muls    r0, step
    adds    p, p, r0
    ldr     r7, [sp, #F_WIDE]
    lsls    r3, r7
    adds    r6, r6, r3
    movs    r0, #0
    str     r0, [sp, #F_SKIP]
2:  ldr     r7, [sp, #F_WIDE]
    subs    r0, r2, r5
    bls     1f
    adds    r6, r6, r0
    mov     r2, r5
1:  str     r6, [sp, #F_SHORT]
    lsrs    r6, r7
    ldr     r7, [sp, #F_PIXEL]
    muls    r6, r7
    ldr     r7, [sp, #F_CODE_0]
    adds    r6, r6, r7
    ldr     r0, [sp, #F_WHOLE]
    mov     r12, r0
    ldr     texels, [sp, #F_TEXELS]
    ldr     mask, [sp, #F_MASK]
    ldr     palette, [sp, #F_TABLE]
    bx      r6

    .align  2
.Lwhole:
    find_step
.Lpaint_whole:
    add     r6, sp, #F_TEXELS
    ldmia   r6, {r0, r2, r5, r6, r7}
    bx      r6

.Lreturn:
    movs    r0, #0
.Lleave:
    add     sp, #F_SIZE
    restore_and_return

#include "plain_weights_armv6m.h"
#include "plain_faces_armv6m.h"

/* A loop paints a whole segment or a part of one. */
    .align  2
.Lloop_whole:
    ldr     r6, [sp, #F_BACK]
    ldr     r3, [sp, #F_PAINT]
    bx      r3
    .align  2
.Lloop_part:
    ldr     r6, [sp, #F_SHORT]
    ldr     r3, [sp, #F_PAINT]
    bx      r3

    .ltorg
    .size fxl_paint_plain_rows, . - fxl_paint_plain_rows

#endif
