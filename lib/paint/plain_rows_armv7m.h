/* SPDX-License-Identifier: MIT */
/* The text of the kernels of rows without light for Armv7-M: paint_segments_armv7m.S paints pixels of
 * 8 bits, paint_segments_565_armv7m.S pixels of 16 bits. Assembly. Before it the file defines
 *
 *   ROWS         fxl_paint_rows, or the name that it has for such pixels
 *   RUNS         the same of fxl_paint_runs
 *   WIDE         0, or 1: pixels of 16 bits
 *   TABLE        where the face has the table of what texels of 8 bits become; null: texels are pixels
 *   WHOLE        bytes of the code of 16 pixels with a table; PIXEL: of one of them
 *   WHOLE_PLAIN  the same where texels are pixels; PIXEL_PLAIN
 *
 * and the label of fxl_paint_segments, or of what it is for such pixels. After it the file has the code
 * of 16 pixels for each width from 32 texels on, by the macro sixteen, from .Lpixels_5 on, and without a table
 * from .Lplain_5 on. A texel takes 5 instructions (6 by a table)
 * if the texture is 32 to 256 texels wide and no higher than wide; any other takes 9 or 10. A segment
 * takes 46 more; where the weight is constant, 16 columns take 9 more. A row takes about 110. */
#ifndef FXL_PLAIN_ROWS_ARMV7M_H
#define FXL_PLAIN_ROWS_ARMV7M_H

/* clang-format off */
#include "segments_armv7m.h"

/* The frame: the steps of a segment but the last word, then: */
#define F_W_LOW    20 /* its register has the table */
#define F_V_HIGH   24 /* of the step */
#define F_U_DROP   28 /* then three more words of the face */
#define F_TEXELS   36
#define F_TABLE    44
#define F_GO       48 /* what paints the next segment */
#define F_FULL     52 /* what paints a whole one */
#define F_NEXT     56 /* what follows the pixels of a segment */
#define F_RESUME   60 /* the end of the next segment */
#define F_LAST     64 /* the last r0 at which a whole segment may begin; then r0 at the end */
#define F_END      68
#define F_SKIP     72 /* columns of the next segment that are not painted */
#define F_SHORT    76 /* pixels of 16 that a segment has not; then those that a loop leaves out */
#define F_BEFORE   80
#define F_CODE     84 /* of 16 pixels; then its bytes a pixel, 0 for a loop */
#define F_COLUMN   92 /* for a loop: how far a position is shifted to the column; then, to the row */
#define F_LOG      100 /* of the segments that the frame is for; above 4: none */
#define F_DONE     104 /* what follows a row */
#define F_ROW      108
#define F_FACE     112
#define F_X        116 /* the end of the run; then that of the row */
#define F_X_END    120
#define F_BEGIN    124 /* finds the registers from w_low on at the beginning of a run */
#define F_SAVED    128 /* the registers from w_low on */
#define F_KIND     164 /* what takes a row of the face */
#define F_SIZE     168

/* The frame of rows of constant weight has in the place of F_SAVED: */
#define F_LINE     128 /* the weight for which it has: how far coordinates are shifted, */
#define F_U_LEFT   132
#define F_V_LEFT   136
#define F_STEPS    140 /* the step of a pixel and the reciprocal; those of 16 pixels of u, and what it is more
                        * in the middle of them; of v */

pixels  .req r0         /* the address before the 16 pixels whose last ones are the segment's */
p       .req r1
step    .req r2
texels  .req r4
mask    .req r5
table   .req r6
w_low   .req r6         /* what is linear, at the end of the segment */
w       .req r7
u_low   .req r8
u       .req r9
v_low   .req r10
v       .req r11
u_0     .req r12        /* U and V at the beginning of the segment */
v_0     .req lr

/* A row of constant weight: u and v are its coordinates at the segment. */
last    .req r7         /* F_LAST */
u_more  .req r8
v_more  .req r10

/* r0: face, r1: row, r2: x0, r3: x1 */
    push    {r4-r11, lr}
    sub     sp, #F_SIZE
    adr     r4, .Lreturn + 1
    strd    r4, r1, [sp, #F_DONE]
    bl      .Lprepare
    cmp     r1, #0
    ldr     r4, [sp, #F_ROW]
    ldr     r5, [r4, #PAINT_ROW_PIXELS]
    bne     .Lline
    b       .Lface_weights
    .align  2
.Lreturn:
    movs    r0, #0
.Lleave:
    add     sp, #F_SIZE
    pop     {r4-r11, pc}

    .type   ROWS, %function
    .thumb_func

/* r0: rows. Returns 0, or 1 at a row that is not the kernel's. */
ROWS:
    push    {r4-r11, lr}
    sub     sp, #F_SIZE
    adr     r4, .Lnext_row + 1
    strd    r4, r0, [sp, #F_DONE]
    mov     r11, r0
    ldr     r0, [r0, #PAINT_ROW_SEGMENTS]
    bl      .Lprepare
    ldr     r2, [r11, #PLAIN_ROWS_EDGES]
    ldr     r6, [r11, #PLAIN_ROWS_EDGES + EDGE_SIZE]
    ldr     r5, [r11, #PAINT_ROW_PIXELS]
    b       .Lrow

#if !FXL_IS_COMPACT

    .type   RUNS, %function
    .thumb_func

/* r0: runs. Returns 0, or 1 after a run that is not the kernel's. */
RUNS:
    push    {r4-r11, lr}
    sub     sp, #F_SIZE
    adr     r4, .Lnext_run + 1
    strd    r4, r0, [sp, #F_DONE]
    ldr     r0, [r0, #PAINT_ROW_SEGMENTS]
    bl      .Lprepare
    .align  2
.Lnext_run:
    ldr     r12, [sp, #F_ROW]
    ldrd    r0, r1, [r12, #PLAIN_RUNS_NEXT]
    cmp     r0, r1
    beq     .Lreturn
    ldr     lr, [r0], #4
    str     r0, [r12, #PLAIN_RUNS_NEXT]
    cmp     lr, #0
    bmi     .Lrun_below
    ldr     r5, [r12, #PAINT_ROW_PIXELS]
.Lcolumns:                              /* lr: the run, r5: the address of column 0 */
    uxth    r2, lr
    ubfx    r3, lr, #16, #15
    cmp     r2, r3
    beq     .Lnext_run
    ldr     pc, [sp, #F_KIND]
.Lrun_below:
    ldm     r12, {r0-r5}
    add     r6, r12, #PLAIN_ROWS_DOWNS
    ldm     r6, {r6-r11}
    adds    r0, r0, r6
    adc     r1, r1, r7
    adds    r2, r2, r8
    adc     r3, r3, r9
    adds    r4, r4, r10
    adc     r5, r5, r11
    stm     r12, {r0-r5}
    ldr     r5, [r12, #PAINT_ROW_PIXELS]
    ldr     r1, [r12, #PLAIN_RUNS_STRIDE]
    add     r5, r5, r1
    str     r5, [r12, #PAINT_ROW_PIXELS]
    b       .Lcolumns

#endif

/* What the frame has of the face in r0; r1 becomes whether its rows are lines. Keeps r2 and r3. */
    .align  2
.Lprepare:
    str     r0, [sp, #F_FACE]
    add     r8, r0, #SEGMENT_FACE_U_DROP
    ldm     r8, {r4-r7}
    add     r8, sp, #F_U_DROP
    stm     r8, {r4-r7}
    ldrb    r4, [r0, #SEGMENT_FACE_FORM]
    ldr     r7, [r0, #TABLE]
    str     r7, [sp, #F_TABLE]
    cbz     r4, 2f
    cbz     r7, 1f
    movw    r5, #WHOLE
    mul     r4, r4, r5
    adr     r5, .Lpixels_5 - WHOLE + 1
    add     r4, r4, r5
    movs    r5, #PIXEL
    b       3f
1:  movw    r5, #WHOLE_PLAIN
    mul     r4, r4, r5
    adr     r5, .Lplain_5 - WHOLE_PLAIN + 1
    add     r4, r4, r5
    movs    r5, #PIXEL_PLAIN
    b       3f
2:  ldrb    r4, [r0, #SEGMENT_FACE_LOG_WIDTH]
    ldrb    r5, [r0, #SEGMENT_FACE_ROW_DROP]
    rsb     r4, r4, #32
    strd    r4, r5, [sp, #F_COLUMN]
    adr     r4, .Lloop + 1
    movs    r5, #0
3:  strd    r4, r5, [sp, #F_CODE]
    ldrb    r1, [r0, #SEGMENT_FACE_IS_CONSTANT]
    str     r4, [sp, #F_LOG]            /* none: it is above 4 */
    adr     r5, .Lbegin + 1
    str     r5, [sp, #F_BEGIN]
    adr     r5, .Lface_weights + 1
    str     r5, [sp, #F_KIND]
    cbz     r1, 4f
    movs    r5, #0
    str     r4, [sp, #F_FULL]
    str     r5, [sp, #F_SHORT]
    str     r5, [sp, #F_BEFORE]
    mov     r5, #0x80000000
    str     r5, [sp, #F_LINE]           /* no weight */
    adr     r4, .Lline_next + 1
    adr     r5, .Lline_resume + 1
    strd    r4, r5, [sp, #F_NEXT]
    adr     r4, .Lline + 1
    str     r4, [sp, #F_KIND]
4:  bx      lr

/* --- rows ----------------------------------------------------------------------------------- */

    .align  2
.Lnext_row:
    ldr     r12, [sp, #F_ROW]
    ldm     r12, {r0-r5}
    add     lr, r12, #PLAIN_ROWS_DOWNS
    ldm     lr!, {r6-r11}
    adds    r0, r0, r6
    adc     r1, r1, r7
    adds    r2, r2, r8
    adc     r3, r3, r9
    adds    r4, r4, r10
    adc     r5, r5, r11
    stm     r12, {r0-r5}
    ldm     lr, {r2-r9}                 /* the edges */
    adds    r3, r3, r5
    adcs    r2, r2, r4
    adds    r7, r7, r9
    adcs    r6, r6, r8
    strd    r2, r3, [r12, #PLAIN_ROWS_EDGES]
    strd    r6, r7, [r12, #PLAIN_ROWS_EDGES + EDGE_SIZE]
    ldrd    r5, r0, [r12, #PAINT_ROW_PIXELS]
    ldrd    r1, r4, [r12, #PLAIN_ROWS_END]
    add     r5, r5, r4
    adds    r0, r0, #1
    strd    r5, r0, [r12, #PAINT_ROW_PIXELS]
    cmp     r0, r1
    bge     .Lreturn

/* r2, r6: the edges' columns, r5: the address of column 0 */
.Lrow:
    cmp     r2, r6
    bge     .Lother_way
    mov     r3, r6
    ldr     pc, [sp, #F_KIND]
.Lother_way:
    beq     .Lnext_row
    mov     r3, r2
    mov     r2, r6
    ldr     pc, [sp, #F_KIND]

    .align  2
/* Which segments the columns r2 to r3 have; r0: face, r1: row. r10, r11: the weight at the first 16
 * columns. */
.Lface_weights:
    ldrd    r1, r0, [sp, #F_ROW]
    lsr     r4, r2, #4
    add     r5, r3, #15
    lsr     r5, r5, #4
    ldrd    r6, r7, [r0, #SEGMENT_FACE_WEIGHT_STEP]
    ldrd    r8, r9, [r1, #PAINT_ROW_WEIGHT]
    umull   r10, r11, r6, r4
    mla     r11, r7, r4, r11
    adds    r10, r10, r8
    adc     r11, r11, r9
    umull   r12, lr, r6, r5
    mla     lr, r7, r5, lr
    adds    r12, r12, r8
    adc     lr, lr, r9
    cmp     lr, r11
    it      gt
    movgt   lr, r11
    ldrd    r8, r9, [r0, #SEGMENT_FACE_LEAST]
    str     r3, [sp, #F_X_END]
    cmp     lr, r8
    blt     .Lmixed
    movs    r4, #4
    str     r3, [sp, #F_X]

/* A run of segments of 2^r4 columns: the columns r2 to r3 of the row in r1; r0: face. */
.Lrun:
    ldr     r5, [sp, #F_LOG]
    cmp     r4, r5
    bne     .Lother_log
.Lsame_log:
    rsb     r5, r4, #32
    lsl     r6, r2, r5
    lsr     r6, r6, r5                  /* columns that are skipped */
    ldr     r8, [sp, #F_SHORT]
    ldr     r7, [r1, #PAINT_ROW_PIXELS]
    rsb     r8, r8, #16
    sub     r7, r7, #(1 << WIDE)
    add     r3, r7, r3, lsl #WIDE
    sub     r8, r3, r8, lsl #WIDE
    strd    r8, r3, [sp, #F_LAST]
    str     r6, [sp, #F_SKIP]
    sub     r3, r2, r6
    add     pixels, r7, r3, lsl #WIDE
    lsr     r12, r2, r4                 /* the first segment's number */
    cmp     pixels, r8
    it      ls
    cmpls   r6, #0
    ite     eq
    ldreq   r3, [sp, #F_FULL]
    adrne   r3, .Lpartial + 1
    str     r3, [sp, #F_GO]
    ldr     pc, [sp, #F_BEGIN]

    .align  2
.Lbegin:
    ldrd    r2, r3, [sp]
    umull   w_low, w, r2, r12
    mla     w, r3, r12, w
    ldrd    r2, r3, [r1, #PAINT_ROW_WEIGHT]
    adds    w_low, w_low, r2
    adc     w, w, r3
    ldrd    r2, r3, [sp, #8]
    umull   u_low, u, r2, r12
    mla     u, r3, r12, u
    ldrd    r2, r3, [r1, #PAINT_ROW_U]
    adds    u_low, u_low, r2
    adc     u, u, r3
    ldr     r2, [sp, #16]
    ldr     r3, [sp, #F_V_HIGH]
    umull   v_low, v, r2, r12
    mla     v, r3, r12, v
    ldrd    r2, r3, [r1, #PAINT_ROW_V]
    adds    v_low, v_low, r2
    adc     v, v, r3
    str     w_low, [sp, #F_W_LOW]
    mvn     r3, #0x80000000
    reciprocal r3, r1, w, r3, r2, r5
    ldrd    r4, r5, [sp, #F_U_DROP]
    subs    r4, r4, r1
    subs    r5, r5, r1
    orrs    r2, r4, r5
    bmi     .Lfar_start
    smull   r1, u_0, u, r3
    asr     u_0, u_0, r4
    smull   r1, v_0, v, r3
    asr     v_0, v_0, r5
    ldr     pc, [sp, #F_RESUME]
.Lfar_start:
    smull   r1, r2, u, r3
    shift_down r2, r1, r4
    mov     u_0, r2
    smull   r1, r2, v, r3
    shift_down r2, r1, r5
    mov     v_0, r2
    ldr     pc, [sp, #F_RESUME]

/* A word of 64 bits in high:low is shifted to the right by less than 32. */
    .macro  shift_step low, high, by
    .if     \by
    lsr     \low, \low, #\by
    orr     \low, \low, \high, lsl #(32 - \by)
    asr     \high, \high, #\by
    .endif
    .endm

/* The frame for segments of 2^log columns: a step is that of 16, shifted. Keeps r0 to r4. */
    .macro  set_log log, resume
    ldm     r0, {r6-r11}
    shift_step r6, r7, (4 - \log)
    shift_step r8, r9, (4 - \log)
    shift_step r10, r11, (4 - \log)
    stm     sp, {r6-r10}
    str     r11, [sp, #F_V_HIGH]
    movs    r6, #(16 - (1 << \log))
    strd    r6, r6, [sp, #F_SHORT]
    ldrd    r7, r8, [sp, #F_CODE]
    mla     r7, r6, r8, r7
    adr     r8, .Lsegment_\log + 1
    adr     r9, \resume + 1
    str     r7, [sp, #F_FULL]
    strd    r8, r9, [sp, #F_NEXT]
    b       .Lsame_log
    .endm

/* The frame of another logarithm, r4. */
.Lother_log:
    str     r4, [sp, #F_LOG]
    cmp     r4, #3
    beq     .Lset_3
    blo     .Lset_less
    set_log 4, .Lresume_4
.Lset_3:
    set_log 3, .Lresume_3
.Lset_less:
    cmp     r4, #0
    beq     .Lset_0
    set_log 2, .Lresume_2
.Lset_0:
    set_log 0, .Leach

/* Not all are of 16 columns. */
.Lmixed:
    ldr     r12, [r0, #SEGMENT_FACE_LEAST + 12]
    cmp     lr, r12
    blt     .Lnot_ours
/* The run of 16 columns that have the same segments, from r2 on, up to r3 at most. r10, r11: the weight
 * at the first 16 columns; r6, r7: its step; r8, r9: the least weights for 16 and for 8. The weight is
 * linear, so where it rises segments do not become shorter. */
.Lfind:
    bic     r5, r2, #15
    ldr     r12, [r0, #SEGMENT_FACE_LEAST + 8]
    cmp     r7, #0
    blt     .Lfalling
    cmp     r11, r8
    bge     .Lall_16
    movs    r4, #3
    mov     lr, r8
    cmp     r11, r9
    bge     1f
    movs    r4, #2
    mov     lr, r9
    cmp     r11, r12
    bge     1f
    movs    r4, #0
    mov     lr, r12
1:  adds    r5, #16
    cmp     r5, r3
    bge     .Lto_end
    adds    r10, r10, r6
    adc     r11, r11, r7
    cmp     r11, lr
    blt     1b
    b       .Lfound
.Lfalling:
    adds    r10, r10, r6
    adc     r11, r11, r7
    movs    r4, #4
    mov     lr, r8
    cmp     r11, r8
    bge     1f
    movs    r4, #3
    mov     lr, r9
    cmp     r11, r9
    bge     1f
    movs    r4, #2
    mov     lr, r12
    cmp     r11, r12
    bge     1f
    movs    r4, #0
    b       .Lto_end
1:  adds    r5, #16
    cmp     r5, r3
    bge     .Lto_end
    adds    r10, r10, r6
    adc     r11, r11, r7
    cmp     r11, lr
    bge     1b
.Lfound:
    mov     r3, r5
    str     r3, [sp, #F_X]
    b       .Lrun
.Lall_16:
    movs    r4, #4
.Lto_end:
    str     r3, [sp, #F_X]
    b       .Lrun

.Lnot_ours:
    movs    r0, #1
    b       .Lleave

/* A run has ended. If segments have come to an end of 16 columns, all registers are those at the
 * beginning of the next run. */
    .align  2
.Lrun_end:
    ldrd    r2, r3, [sp, #F_X]
    cmp     r2, r3
    beq     2f
    ldr     r4, [sp, #F_LOG]
    ldrd    r1, r0, [sp, #F_ROW]
    cbz     r4, 1f
    ldr     w_low, [sp, #F_W_LOW]
    adr     r4, .Lkept + 1
    str     r4, [sp, #F_BEGIN]
    add     r4, sp, #F_SAVED
    stm     r4, {r6-r12, lr}
    mov     r10, w_low
    mov     r11, w
    ldrd    r6, r7, [r0, #SEGMENT_FACE_WEIGHT_STEP]
    ldrd    r8, r9, [r0, #SEGMENT_FACE_LEAST]
    b       .Lfind
1:  lsr     r4, r2, #4
    ldrd    r6, r7, [r0, #SEGMENT_FACE_WEIGHT_STEP]
    ldrd    r8, r9, [r1, #PAINT_ROW_WEIGHT]
    umull   r10, r11, r6, r4
    mla     r11, r7, r4, r11
    adds    r10, r10, r8
    adc     r11, r11, r9
    ldrd    r8, r9, [r0, #SEGMENT_FACE_LEAST]
    b       .Lfind
2:  ldr     pc, [sp, #F_DONE]

    .align  2
.Lkept:
    adr     r3, .Lbegin + 1
    str     r3, [sp, #F_BEGIN]
    add     r3, sp, #F_SAVED
    ldm     r3, {r6-r12, lr}
    ldr     pc, [sp, #F_RESUME]

/* --- segments ------------------------------------------------------------------------------- */

/* The position and the step of a segment of 2^log columns. r2: U, r4: V at its end. Goes on to its
 * pixels. */
    .macro  paint_between log
    ubfx    p, v_0, #4, #16
    lsr     r3, u_0, #4
    add     p, p, r3, lsl #16
    sub     r3, r2, u_0
    sub     r5, r4, v_0
    mov     u_0, r2
    mov     v_0, r4
    adds    r3, #(8 << \log)
    adds    r5, #(8 << \log)
    asrs    r3, r3, #(4 + \log)
    sbfx    r5, r5, #(4 + \log), #16
    add     step, r5, r3, lsl #16
    .if     \log < 4
    subs    pixels, #((16 - (1 << \log)) << WIDE)
    .endif
    add     r3, sp, #F_TEXELS
    ldm     r3, {texels, mask, table, pc}   /* F_GO */
    .endm

/* What is linear, at the end of the next segment. */
    .macro  next_values
    ldm     sp, {r1-r5, w_low}
    adds    w_low, w_low, r1
    adc     w, w, r2
    str     w_low, [sp, #F_W_LOW]
    adds    u_low, u_low, r3
    adc     u, u, r4
    adds    v_low, v_low, r5
    ldr     r5, [sp, #F_V_HIGH]
    adc     v, v, r5
    .endm

    .macro  segments log
    .align  2
.Lsegment_\log:
    ldr     r3, [sp, #F_LAST]
    cmp     pixels, r3
    bhi     .Lrest
    .align  2
.Lresume_\log:
    next_values
    mvn     r3, #0x80000000
    reciprocal r3, r1, w, r3, r2, r5
    ldrd    r4, r5, [sp, #F_U_DROP]
    subs    r4, r4, r1
    subs    r5, r5, r1
    orrs    r2, r4, r5
    bmi     .Lfar_\log
    smull   r1, r2, u, r3
    asrs    r2, r2, r4
    smull   r1, r4, v, r3
    asrs    r4, r4, r5
.Lbetween_\log:
    paint_between \log

/* Fewer leading zeros in a drop: some bits come from the lower word. */
.Lfar_\log:
    smull   r1, r2, u, r3
    shift_down r2, r1, r4
    smull   r1, r4, v, r3
    shift_down r4, r1, r5
    b       .Lbetween_\log
    .endm

    segments 4
    segments 3
    segments 2

/* Each pixel divided: U and V at a pixel. */
    .align  2
.Lsegment_0:
    ldr     r3, [sp, #F_LAST]
    cmp     pixels, r3
    bhi     .Lrun_end
    next_values
    mvn     r3, #0x80000000
    reciprocal r3, r1, w, r3, r2, r5
    ldrd    r4, r5, [sp, #F_U_DROP]
    subs    r4, r4, r1
    subs    r5, r5, r1
    orrs    r2, r4, r5
    bmi     .Lfar_start
    smull   r1, u_0, u, r3
    asr     u_0, u_0, r4
    smull   r1, v_0, v, r3
    asr     v_0, v_0, r5
    .align  2
.Leach:
    ubfx    p, v_0, #4, #16
    lsr     r3, u_0, #4
    add     p, p, r3, lsl #16
    subs    pixels, #(15 << WIDE)
    add     r3, sp, #F_TEXELS
    ldm     r3, {texels, mask, table, pc}   /* F_GO */

/* Less than a segment is left, or nothing. */
    .align  2
.Lrest:
    ldr     r3, [sp, #F_END]
    cmp     pixels, r3
    bhs     .Lrun_end
    adr     r3, .Llast_partial + 1
    str     r3, [sp, #F_GO]
    ldr     pc, [sp, #F_RESUME]

/* The same as below where no column is skipped and the run ends in the segment: the code of 16 pixels
 * ends at its end. */
    .align  2
.Llast_partial:
    ldr     r3, [sp, #F_SHORT]
    ldr     r5, [sp, #F_END]
    add     pixels, pixels, r3, lsl #WIDE
    subs    r3, r5, pixels
    sub     pixels, r5, #(16 << WIDE)
    rsb     r3, r3, #(16 << WIDE)
    .if     WIDE
    lsrs    r3, r3, #1
    .endif
    str     r3, [sp, #F_BEFORE]
    ldrd    r4, r5, [sp, #F_CODE]
    mla     r3, r3, r5, r4
    ldrd    texels, mask, [sp, #F_TEXELS]
    bx      r3

/* Pixels from F_SKIP on, up to the end of the run or of the segment: the last ones of the code of 16
 * pixels, whose first pixel is before them by as many as are left out. */
    .align  2
.Lpartial:
    ldr     r5, [sp, #F_SKIP]
    mla     p, step, r5, p
    ldr     r3, [sp, #F_SHORT]
    add     r5, r5, r3
    add     pixels, pixels, r5, lsl #WIDE
    ldr     r3, [sp, #F_END]
    sub     r3, r3, pixels
    .if     WIDE
    lsrs    r3, r3, #1
    .endif
    rsb     r3, r3, #16
    cmp     r3, r5
    it      lt
    movlt   r3, r5
    sub     pixels, pixels, r3, lsl #WIDE
    str     r3, [sp, #F_BEFORE]
    movs    r4, #0
    str     r4, [sp, #F_SKIP]
    ldr     r4, [sp, #F_FULL]
    str     r4, [sp, #F_GO]
    ldrd    r4, r5, [sp, #F_CODE]
    mla     r3, r3, r5, r4
    ldrd    texels, mask, [sp, #F_TEXELS]
    bx      r3

/* Any size. */
    .align  2
.Lloop:
    push    {r6-r11}
    mov     r11, table
    add     r3, sp, #(F_COLUMN + 24)
    ldm     r3, {r6, r7}
    add     r8, pixels, #(16 << WIDE)
    ldr     r3, [sp, #(F_BEFORE + 24)]
    add     pixels, pixels, r3, lsl #WIDE
    ldr     r3, [sp, #(F_SHORT + 24)]
    str     r3, [sp, #(F_BEFORE + 24)]
    cmp     r11, #0
    beq     2f
    .if     WIDE
    mov     r10, step
    ldr     r2, [sp, #(F_FACE + 24)]
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
    ldr     pc, [sp, #F_NEXT]

/* --- rows of constant weight ---------------------------------------------------------------- */

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

    .macro  line_segment
    lsr     p, v, #16
    lsr     r3, u, #16
    add     p, p, r3, lsl #16
    ldr     pc, [sp, #F_GO]
    .endm

/* A coordinate at the segment r12, where it has what it is more in the middle of 16 columns. r1: row, r3: the
 * reciprocal. Overwrites r4 to r7. */
    .macro  line_at at, more, row_value, left
    mla     \at, \more, r12, \at
    ldr     r4, [r1, #(\row_value + 4)]
    ldr     r6, [sp, #\left]
    smull   r5, r4, r4, r3
    subs    r7, r6, #32
    bmi     1f
    asr     r4, r4, r7
    add     \at, \at, r4
    b       2f
1:  rsb     r7, r6, #32
    lsl     r4, r4, r7
    lsr     r5, r5, r6
    add     \at, \at, r4
    add     \at, \at, r5
2:
    .endm

    .align  2
.Lline:
    ldr     r1, [sp, #F_ROW]
    ldr     r7, [r1, #PAINT_ROW_WEIGHT + 4]
    and     r6, r2, #15
    sub     r5, r5, #(1 << WIDE)
    add     r3, r5, r3, lsl #WIDE
    sub     r8, r3, #(16 << WIDE)
    strd    r8, r3, [sp, #F_LAST]
    str     r6, [sp, #F_SKIP]
    sub     r3, r2, r6
    lsr     r12, r2, #4
    add     pixels, r5, r3, lsl #WIDE   /* the address before the segment */
    cmp     pixels, r8
    it      ls
    cmpls   r6, #0
    ite     eq
    ldreq   r3, [sp, #F_FULL]
    adrne   r3, .Lpartial + 1
    str     r3, [sp, #F_GO]
    ldr     r4, [sp, #F_LINE]
    cmp     r4, r7
    bne     .Lother_line
.Lsame_line:
    add     r4, sp, #F_STEPS
    ldm     r4, {r2, r3, r8-r11}        /* step, the reciprocal, u_more, u, v_more, v */
    line_at u, u_more, PAINT_ROW_U, F_U_LEFT
    line_at v, v_more, PAINT_ROW_V, F_V_LEFT
    ldr     last, [sp, #F_LAST]
    ldrd    texels, mask, [sp, #F_TEXELS]
    ldr     table, [sp, #F_TABLE]
    line_segment

.Lother_line:
    ldr     lr, [sp, #F_FACE]
    ldr     r4, [lr, #SEGMENT_FACE_LEAST + 12]
    cmp     r7, r4
    blt     .Lnot_ours
    str     r7, [sp, #F_LINE]
    mvn     r3, #0x80000000
    reciprocal r3, r9, r7, r3, r4, r5
    line_change u_more, r2, SEGMENT_FACE_U_STEP, F_U_DROP, F_U_LEFT
    line_change v_more, lr, SEGMENT_FACE_V_STEP, F_U_DROP + 4, F_V_LEFT
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
    add     r4, sp, #F_STEPS
    stm     r4, {r2, r3, r8-r11}
    b       .Lsame_line

/* Less than 16 columns are left, or nothing. */
    .align  2
.Lline_rest:
    ldr     r3, [sp, #F_END]
    cmp     pixels, r3
    it      hs
    ldrhs   pc, [sp, #F_DONE]
    adr     r3, .Llast_partial + 1
    str     r3, [sp, #F_GO]
    b       .Lline_resume

    .align  2
.Lline_next:
    cmp     pixels, last
    bhi     .Lline_rest
    .align  2
.Lline_resume:
    add     u, u, u_more
    add     v, v, v_more
    line_segment

/* --- pixels ----------------------------------------------------------------------------------- */

/* The code of 16 pixels of a texture of 2^log columns. No pixel follows the last one. */
    .macro  sixteen log, pixel
    .irp    i, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16
    texel_offset r3, mask, p, \log
    \pixel \i
    .if     \i < 16
    add     p, step
    .endif
    .endr
    ldr     pc, [sp, #F_NEXT]
    .endm
/* clang-format on */

#endif
