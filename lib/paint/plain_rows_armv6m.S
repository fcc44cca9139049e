/* SPDX-License-Identifier: MIT */
/* fxl_paint_plain_rows, fxl_paint_run and fxl_paint_line for Armv6-M. lib/paint/plain_run.h states what they
 * require and do. A segment takes 134 instructions beside its pixels, and 16 columns of a row of constant
 * weight take 26. A row takes 130 before its first segment, and a run of segments 90. */
#include "../math/family.h"
#include "../math/offsets.h"

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
    push    {r4-r7, lr}
    mov     r4, r8
    mov     r5, r9
    mov     r6, r10
    mov     r7, r11
    push    {r4-r7}
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
    pop     {r4-r7}
    mov     r8, r4
    mov     r9, r5
    mov     r10, r6
    mov     r11, r7
    pop     {r4-r7, pc}

/* The zeros of another weight, r1, and the shifts. Any number that is not 0 ends up with its highest bit set. */
.Lnormalise:
    movs    r0, r1
    movs    r2, #0
    lsrs    r3, r0, #16
    bne     1f
    adds    r2, #16
    lsls    r0, r0, #16
1:  lsrs    r3, r0, #24
    bne     1f
    adds    r2, #8
    lsls    r0, r0, #8
1:  lsrs    r3, r0, #28
    bne     1f
    adds    r2, #4
    lsls    r0, r0, #4
1:  lsrs    r3, r0, #30
    bne     1f
    adds    r2, #2
    lsls    r0, r0, #2
1:  cmp     r0, #0
    bmi     1f
    adds    r2, #1
    lsls    r0, r0, #1
1:  mov     r8, r2
    ldr     r3, [sp, #F_U_DROP]
    subs    r3, r3, r2
    str     r3, [sp, #F_U_SHIFT]
    ldr     r4, [sp, #F_V_DROP]
    subs    r4, r4, r2
    str     r4, [sp, #F_V_SHIFT]
    ldr     r5, =.Lnear
    orrs    r3, r4
    bpl     1f
    ldr     r5, =.Lfar
1:  mov     r11, r5
    b       .Lreciprocal

/* What follows the pixels of a segment: r2 is F_PIXELS, or in the run's last part F_LAST. */
    .macro  after next, part
    ldr     r3, [sp, #F_WIDTH]
    adds    r2, r2, r3
    str     r2, [sp, #F_PIXELS]
    ldr     r3, [sp, #F_LAST]
    cmp     r2, r3
    bls     \next
    ldr     r3, [sp, #F_STOP]
    cmp     r2, r3
    blo     1f
    ldr     r3, [sp, #F_DONE]
    mov     pc, r3
    .align  2
1:  ldr     r3, =\part
    mov     r12, r3
    .endm

    .align  2
.Lafter:
    after   .Lnext, .Lpart

/* The end of the next segment. */
.Lnext:
    mov     r6, sp
    add     r7, sp, #F_W_STEP
    ldmia   r6!, {r0-r3}
    ldmia   r7!, {r4, r5}
    adds    r0, r0, r4
    adcs    r1, r5
    ldmia   r7!, {r4, r5}
    adds    r2, r2, r4
    adcs    r3, r5
    subs    r6, #16
    stmia   r6!, {r0-r3}
    ldmia   r6!, {r2, r3}
    ldmia   r7!, {r4, r5}
    adds    r2, r2, r4
    adcs    r3, r5
    subs    r6, #8
    stmia   r6!, {r2, r3}

/* r1: the weight. Mostly it has as many leading zeros as the one before. Its lowest bit counts as set. */
.Ldivide:
    mov     r2, r8
    movs    r3, #1
    orrs    r1, r3
    movs    r0, r1
    lsls    r0, r2
    bpl     .Lnormalise
    movs    r3, r0
    lsrs    r3, r2
    cmp     r3, r1
    bne     .Lnormalise

/* r0: the weight, in 32 bits. */
.Lreciprocal:
    lsrs    r1, r0, #16                 /* d, from 2^15 on */
    lsrs    r2, r0, #24
    lsls    r2, r2, #1
    mov     r3, r9
    ldrh    r2, [r3, r2]                /* 2^31 / d, relatively within 2^-8: Newton's step squares that */
    uxth    r0, r0
    movs    r3, r2
    muls    r3, r1
    mov     r4, r10
    subs    r3, r4, r3                  /* below 2^23 */
    asrs    r3, r3, #8
    muls    r3, r2                      /* below 2^31 */
    asrs    r3, r3, #23
    adds    r2, r2, r3                  /* the quotient of 2^31 - 1, or 1 less: every d was tried */
    movs    r3, r2
    muls    r3, r1
    subs    r3, r4, r3
    cmp     r3, r1
    bls     1f
    adds    r2, #1
    subs    r3, r3, r1
/* Of e = r2, its square times the weight is e (2^47 - 2^16 r3 + e r0): so the reciprocal,
 * 2^16 e - e^2 weight / 2^32, is 2^15 e - (e^2 r0 / 2^16 - e r3) / 2^16, rounded up. Both products fit
 * 32 bits, and their difference 33. */
1:  muls    r0, r2
    uxth    r4, r0
    lsrs    r0, r0, #16
    muls    r4, r2
    lsrs    r4, r4, #16
    muls    r0, r2
    adds    r0, r0, r4
    muls    r3, r2
    subs    r0, r0, r3
    sbcs    r3, r3
    lsls    r3, r3, #16
    lsrs    r0, r0, #16
    orrs    r0, r3
    lsls    r2, r2, #15
    subs    r2, r2, r0
    uxth    r3, r2
    lsrs    r2, r2, #16
    mov     pc, r11

/* r0 = the upper word of r0, signed, times the reciprocal, whose halves are r2 and r3. The reciprocal
 * is below 2^31: sums of a product of halves and 2^16 fit 32 bits. */
    .macro  multiply keep
    uxth    r4, r0
    asrs    r0, r0, #16
    movs    r5, r4
    muls    r5, r3
    .if     \keep
    uxth    r7, r5
    .endif
    lsrs    r5, r5, #16
    movs    r6, r0
    muls    r6, r3
    adds    r5, r5, r6
    uxth    r6, r5
    asrs    r5, r5, #16
    muls    r4, r2
    adds    r4, r4, r6
    .if     \keep
    lsls    r6, r4, #16
    orrs    r7, r6                      /* the lower word */
    .endif
    lsrs    r4, r4, #16
    muls    r0, r2
    adds    r0, r0, r5
    adds    r0, r0, r4
    .endm

    .align  2
.Lnear:
    ldr     r0, [sp, #F_U + 4]
    multiply 0
    ldr     r4, [sp, #F_U_SHIFT]
    asrs    r0, r4
    movs    r7, r0
    ldr     r0, [sp, #F_V + 4]
    multiply 0
    ldr     r4, [sp, #F_V_SHIFT]
    asrs    r0, r4
    mov     pc, r12

/* A product of 64 bits, shifted to the right by less than 32. */
    .macro  multiply_far value, shift
    ldr     r0, [sp, #\value]
    multiply 1
    ldr     r4, [sp, #\shift]
    cmp     r4, #0
    blt     1f
    asrs    r0, r4
    b       2f
1:  rsbs    r4, r4, #0
    lsls    r0, r4
    movs    r5, #32
    subs    r5, r5, r4
    lsrs    r7, r5
    orrs    r0, r7
2:
    .endm

    .align  2
.Lfar:
    multiply_far F_U + 4, F_U_SHIFT
    str     r0, [sp, #F_SPARE]
    multiply_far F_V + 4, F_V_SHIFT
    ldr     r7, [sp, #F_SPARE]
    mov     pc, r12

/* Entry i is 2^31 / (2^15 + 2^8 i + 127.5), rounded. */
    .align  2
.Lreciprocals:
    .short  65279, 64774, 64278, 63789, 63308, 62833, 62366, 61906
    .short  61452, 61005, 60565, 60131, 59703, 59281, 58865, 58454
    .short  58050, 57651, 57257, 56869, 56486, 56108, 55735, 55368
    .short  55004, 54646, 54292, 53943, 53598, 53258, 52922, 52590
    .short  52263, 51939, 51619, 51304, 50992, 50684, 50379, 50078
    .short  49781, 49487, 49197, 48910, 48627, 48346, 48069, 47795
    .short  47525, 47257, 46992, 46730, 46471, 46215, 45962, 45711
    .short  45464, 45219, 44976, 44736, 44499, 44264, 44032, 43802
    .short  43574, 43349, 43126, 42905, 42687, 42471, 42257, 42045
    .short  41835, 41628, 41422, 41219, 41017, 40817, 40620, 40424
    .short  40230, 40038, 39848, 39659, 39473, 39288, 39105, 38923
    .short  38743, 38565, 38389, 38214, 38040, 37869, 37698, 37530
    .short  37363, 37197, 37033, 36870, 36708, 36548, 36390, 36233
    .short  36077, 35922, 35769, 35617, 35467, 35317, 35169, 35022
    .short  34877, 34732, 34589, 34447, 34306, 34166, 34028, 33890
    .short  33754, 33618, 33484, 33351, 33219, 33088, 32958, 32829

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
