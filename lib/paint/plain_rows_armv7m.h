/* SPDX-License-Identifier: MIT */
/* The text of the kernels of rows without light for Armv7-M: paint_segments_armv7m.S paints pixels
 * of 8 bits, paint_segments_565_armv7m.S pixels of 16 bits. Assembly. Before it the file defines
 *
 *   ROWS         fxl_paint_rows, or the name that it has for such pixels
 *   RUNS         the same of fxl_paint_runs
 *   HOLES        the same of fxl_paint_holes
 *   WIDE         0, or 1: pixels of 16 bits
 *   TABLE        where the face has the table of what texels of 8 bits become; null: texels are
 * pixels WHOLE        bytes of the code of 16 pixels with a table; PIXEL: of one of them
 *   WHOLE_PLAIN  the same where texels are pixels; PIXEL_PLAIN
 *
 * and the label of fxl_paint_segments, or of what it is for such pixels. After it the file has the
 * code of 16 pixels for each width from 32 texels on, by the macro sixteen, from .Lpixels_5 on, and
 * without a table from .Lplain_5 on, which is right behind it. A texel takes 5 instructions (6 by a table) if the texture is
 * 32 to 256 texels wide and no higher than wide; any other takes 9 or 10. A segment takes 46 more;
 * where the weight is constant, 16 columns take 9 more. A row takes about 95. Wide texels that are pixels and are each divided
 * take 34. */
#ifndef FXL_PLAIN_ROWS_ARMV7M_H
#define FXL_PLAIN_ROWS_ARMV7M_H

/* clang-format off */
#include "segments_armv7m.h"

/* The frame: the steps of a segment but the last word, then: */
    slots   20
    slot    .LF_W_LOW     /* its register has the table */
    slot    .LF_V_HIGH    /* of the step */
    slot    .LF_U_DROP, 2 /* with three more words of the face */
    slot    .LF_TEXELS, 2
    slot    .LF_TABLE
    slot    .LF_GO        /* what paints the next segment */
    slot    .LF_FULL      /* what paints a whole one */
    slot    .LF_NEXT      /* what follows the pixels of a segment */
    slot    .LF_RESUME    /* the end of the next segment */
    slot    .LF_LAST      /* the last r0 at which a whole segment may begin */
    slot    .LF_END       /* r0 at the end */
    slot    .LF_SKIP      /* columns of the next segment that are not painted */
    slot    .LF_SHORT     /* pixels of 16 that a segment has not */
    slot    .LF_BEFORE    /* those that a loop leaves out */
    slot    .LF_CODE, 2   /* of 16 pixels; then its bytes a pixel, 0 for a loop */
    slot    .LF_COLUMN, 2 /* for a loop: how far a position is shifted to the column; then, to the row */
    slot    .LF_LOG       /* of the segments that the frame is for; above 4: none */
    slot    .LF_DONE      /* what follows a row */
    slot    .LF_ROW
    slot    .LF_FACE
    slot    .LF_X         /* the end of the run */
    slot    .LF_X_END     /* that of the row */
    slot    .LF_BEGIN     /* finds the registers from w_low on at the beginning of a run */
    slot    .LF_FIRST     /* the same, of the first run of a row */
    slot    .LF_OWN       /* of keyed and stippled texels: the key, or the pattern */
    slot    .LF_SAVED, 7  /* the registers from w on */
    slot    .LF_KIND      /* what takes a row of the face */
    slot    .LF_PLAIN, 2  /* of a clamped face: F_CODE of a plain one */
    slot    .LF_SIZE, 0

/* A clamped face of constant weight: the weight for which it has the others; of u and v the least
 * upper word within the texture, and how many are; their changes a column. */
    slot_of .LF_WITHIN, .LF_OWN
    slot_of .LF_RECIPROCAL, .LF_SAVED + 24 /* of the weight */
    slot_of .LF_DROPS, .LF_COLUMN /* of a row within: less the weight's leading zeros */
#define LOG_WITHIN   5 /* F_LOG: 16 columns, and all pixels of the row are within the texture */

/* Any other clamped face: U and V at the end of the segment before. */
    slot_of .LF_PREVIOUS, .LF_COLUMN

/* Wide texels that are pixels: the columns less 1, a mask. */
    slot_of .LF_COLUMNS, .LF_TABLE

    slot_of .LF_OF_16, .LF_OWN /* of texels of 4 bits: what each becomes. Such a face saves no registers. */

/* The frame of rows of constant weight has in the places of the steps and of F_BEGIN: */
    slot_of .LF_STEPS, 0 /* the step of a pixel and the reciprocal; those of 16 pixels of u, and what it is more
                        * in the middle of them; of v */
    slot_of .LF_LINE, .LF_V_HIGH /* the weight for which it has these, and how far coordinates are shifted */
    slot_of .LF_U_LEFT, .LF_BEGIN
    slot_of .LF_V_LEFT, .LF_FIRST

/* Rows with holes, where depths are kept (holes_armv7m.h): a cell's address less that of its pixel, or
 * less twice that; then the code of the pixel after that of address 0. */
    slot_of .LF_HOLES, .LF_PLAIN
    slot_of .LF_HOLES_STEP, .LF_KIND /* of the codes; wide pixels have it in `table` */

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
    sub     sp, #.LF_SIZE
    adr     r4, .Lreturn + 1
    strd    r4, r1, [sp, #.LF_DONE]
    bl      .Lprepare
.Lrow_alone:                            /* the row of F_ROW alone */
    cmp     r1, #0
    ldr     r4, [sp, #.LF_ROW]
    ldr     r5, [r4, #PAINT_ROW_PIXELS]
    bne     .Lline
    b       .Lface_weights
    .align  2
.Lreturn:
    movs    r0, #0
.Lleave:
    add     sp, #.LF_SIZE
    pop     {r4-r11, pc}

    .type   ROWS, %function
    .thumb_func

/* r0: rows. Returns 0, or 1 at a row that is not the kernel's. */
ROWS:
    push    {r4-r11, lr}
    sub     sp, #.LF_SIZE
    adr     r4, .Lnext_row + 1
    strd    r4, r0, [sp, #.LF_DONE]
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
    sub     sp, #.LF_SIZE
    adr     r4, .Lnext_run + 1
    strd    r4, r0, [sp, #.LF_DONE]
    ldr     r0, [r0, #PAINT_ROW_SEGMENTS]
    bl      .Lprepare
    b       .Lnext_run
    .align  2
.Lrun_beside:                           /* in the row of the run before */
    ldr     r5, [r12, #PAINT_ROW_PIXELS]
    b       .Lcolumns
    .align  2
.Lnext_run:
    ldr     r12, [sp, #.LF_ROW]
    ldrd    r0, r1, [r12, #PLAIN_RUNS_NEXT]
    cmp     r0, r1
    beq     .Lreturn
    ldr     lr, [r0], #4
    str     r0, [r12, #PLAIN_RUNS_NEXT]
    cmp     lr, #0
    bpl     .Lrun_beside
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
.Lcolumns:                              /* lr: the run, r5: the address of column 0 */
    uxth    r2, lr
    ubfx    r3, lr, #16, #15
    cmp     r2, r3
    beq     .Lnext_run
    ldr     pc, [sp, #.LF_KIND]

#endif

/* --- rows ----------------------------------------------------------------------------------- */

    .align  2
.Lnext_row:
    ldr     r12, [sp, #.LF_ROW]
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
    ldr     pc, [sp, #.LF_KIND]
.Lother_way:
    beq     .Lnext_row
    mov     r3, r2
    mov     r2, r6
    ldr     pc, [sp, #.LF_KIND]

#include "special_texels_armv7m.h"
#if !FXL_IS_COMPACT
#include "holes_armv7m.h"
#endif
#include "clamped_texels_armv7m.h"

/* r4: what paints pixels of a kind. */
    .macro  special_code code
    adr     r4, \code + 1
    .if     !WIDE
    cmp     r7, #0
    it      ne
    adrne   r4, \code\()_tabled + 1
    .endif
    b       .Lprepared
    .endm

/* What the frame has of the face in r0; r1 becomes whether its rows are lines. Keeps r2 and r3. */
    .align  2
.Lprepare:
    str     r0, [sp, #.LF_FACE]
    add     r8, r0, #SEGMENT_FACE_U_DROP
    ldm     r8, {r4-r7}
    add     r8, sp, #.LF_U_DROP
    stm     r8, {r4-r7}
    ldrb    r4, [r0, #SEGMENT_FACE_FORM]
    ldr     r7, [r0, #TABLE]
    str     r7, [sp, #.LF_TABLE]
    cbz     r4, 2f
    cbz     r7, 1f
    movw    r5, #WHOLE
    mul     r4, r4, r5
    adr     r5, .Lpixels_5 - WHOLE + 1
    add     r4, r4, r5
    movs    r5, #PIXEL
    b       3f
1:  .if     WIDE
    movs    r5, #16
    lsls    r5, r5, r4
    subs    r5, #1
    str     r5, [sp, #.LF_COLUMNS]
    .endif
    movw    r5, #WHOLE_PLAIN
    mul     r4, r4, r5
    adr     r5, .Lpixels_5 - WHOLE_PLAIN + 1
    add     r4, r4, r5
    add     r4, r4, #(4 * WHOLE)        /* .Lplain_5, which is farther away than adr reaches */
    movs    r5, #PIXEL_PLAIN
    b       3f
2:  ldrb    r4, [r0, #SEGMENT_FACE_LOG_WIDTH]
    ldrb    r5, [r0, #SEGMENT_FACE_ROW_DROP]
    rsb     r4, r4, #32
    strd    r4, r5, [sp, #.LF_COLUMN]
    movs    r5, #0
    ldrb    r6, [r0, #SEGMENT_FACE_KIND]
    cbnz    r6, .Lprepare_special
    adr     r4, .Lloop + 1
    .if     WIDE
    cmp     r7, #0
    it      eq
    adreq   r4, .Lcolours + 1
    .endif
3:
.Lprepared:
    strd    r4, r5, [sp, #.LF_CODE]
    ldrb    r1, [r0, #SEGMENT_FACE_IS_CONSTANT]
    cbnz    r1, 4f
    str     r4, [sp, #.LF_LOG]            /* none: it is above 4 */
    adr     r5, .Lbegin + 1
    strd    r5, r5, [sp, #.LF_BEGIN]
    adr     r5, .Lface_weights + 1
    str     r5, [sp, #.LF_KIND]
    bx      lr
4:  movs    r5, #0
    str     r4, [sp, #.LF_FULL]
    str     r5, [sp, #.LF_SHORT]
    str     r5, [sp, #.LF_BEFORE]
    mov     r5, #0x80000000
    str     r5, [sp, #.LF_LINE]           /* no weight */
    adr     r4, .Lline_next + 1
    str     r4, [sp, #.LF_NEXT]
    adr     r4, .Lline + 1
    str     r4, [sp, #.LF_KIND]
    bx      lr

/* Texels of another kind, r6: code that takes any size. r7: the table. */
.Lprepare_special:
    ldr     r1, [r0, #SEGMENT_FACE_LIGHT_MAX] /* the key, or the pattern */
    str     r1, [sp, #.LF_OWN]
    cmp     r6, #2
    beq     1f
    bhi     2f
    special_code .Lkeyed
1:  special_code .Lstippled
2:  cmp     r6, #4
    beq     .Lprepare_clamped

/* Texels of 4 bits: the table of what each becomes, and code for the size. */
    ldr     r1, [r0, #SEGMENT_FACE_IN_BEAM] /* the colours */
    add     r8, sp, #.LF_OF_16
    str     r8, [sp, #.LF_TABLE]
    add     r9, r1, #16
1:  ldrb    r4, [r1], #1
    .if     WIDE
    ldrh    r4, [r7, r4, lsl #1]
    strh    r4, [r8], #2
    .else
    cbz     r7, 2f
    ldrb    r4, [r7, r4]
2:  strb    r4, [r8], #1
    .endif
    cmp     r1, r9
    bne     1b
    ldrb    r4, [r0, #SEGMENT_FACE_LOG_WIDTH]
    ldrb    r6, [r0, #SEGMENT_FACE_ROW_DROP]
    add     r6, r6, r4, lsl #1
    cmp     r6, #16
    bne     3f                          /* higher than wide */
    subs    r4, #5
    bmi     3f
    ldr     r6, [sp, #(.LF_TEXELS + 4)]
    lsr     r6, r6, #1
    str     r6, [sp, #(.LF_TEXELS + 4)]
    movs    r6, #FOUR_BITS
    mul     r4, r4, r6
    adr     r6, .Lfour_bits_5 + 1
    add     r4, r4, r6
    b       .Lprepared
3:  adr     r4, .Lfour_bits + 1
    b       .Lprepared

/* A clamped face. Its segments are painted by the code of plain ones. */
.Lprepare_clamped:
    ldrb    r4, [r0, #SEGMENT_FACE_LOG_WIDTH]
    subs    r4, #5
    cbz     r7, 1f
    movw    r5, #WHOLE
    adr     r6, .Lpixels_5 + 1
    mla     r4, r4, r5, r6
    movs    r5, #PIXEL
    b       2f
1:  movw    r5, #WHOLE_PLAIN
    adr     r6, .Lpixels_5 + 1
    mla     r4, r4, r5, r6
    add     r4, r4, #(4 * WHOLE)
    movs    r5, #PIXEL_PLAIN
2:  strd    r4, r5, [sp, #.LF_PLAIN]
    adr     r4, .Lclamped + 1
    movs    r5, #0
    strd    r4, r5, [sp, #.LF_CODE]
    str     r4, [sp, #.LF_LOG]
    str     r5, [sp, #.LF_WITHIN]         /* no weight */
    adr     r5, .Lbegin + 1
    strd    r5, r5, [sp, #.LF_BEGIN]
    ldrd    r4, r6, [r0, #SEGMENT_FACE_WEIGHT_STEP]
    adr     r5, .Lface_weights + 1
    orrs    r4, r4, r6
    it      eq
    adreq   r5, .Lclamped_row + 1
    str     r5, [sp, #.LF_KIND]
    movs    r1, #0
    bx      lr

#include "plain_lengths_armv7m.h"
#include "plain_segments_armv7m.h"
#include "clamped_rows_armv7m.h"
#include "plain_lines_armv7m.h"

/* --- pixels ----------------------------------------------------------------------------------- */

/* place sampling: the kernels of Armv7-M; texel_offset has the shift and mask of both */
/* The code of 16 pixels of a texture of 2^log columns. No pixel follows the last one. */
    .macro  sixteen log, pixel
    .irp    i, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16
    texel_offset r3, mask, p, \log
    \pixel \i
    .if     \i < 16
    add     p, step
    .endif
    .endr
    ldr     pc, [sp, #.LF_NEXT]
    .endm

/* clang-format on */

#endif
