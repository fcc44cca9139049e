/* SPDX-License-Identifier: MIT */
/* The text of fxl_draw_depth_outline_8 and fxl_draw_depth_outline_16 for Armv7-M and Armv8-M
 * Mainline. lib/paint/depth_outline.h states what they require and do; they write what
 * lib/paint/depth_row.h writes. A file defines PIXEL_BITS, and includes this one right after the
 * label of its function. An edge is the
 * number of a cell of the band. A row takes about 25 instructions before its pixels, or 55 where the
 * outline's box has several octaves. A visible
 * pixel takes 3.3 where nothing was drawn before, and 7 elsewhere; a hidden one 4.4. */
#include "../math/family.h"
#include "../math/offsets.h"
#include "../raster/draw_frame_armv7m.h"
#include "cell_edges_armv7m.h"

/* Of an outline of one octave: 64 bits whose upper word is the code of cell 0 in the next row, their
 * change a row, and the step. */
#define CODE DEPTH_OUTLINE_ONE

    /* At the first row: its cell, and the value of the plane. If the values at the four corners of
     * the outline's box have one octave, all values have it, as they are linear. Then the rows'
     * codes begin here: CODE is the value of column 0, shifted so that its upper word
     * is the code without the bias; plus the bias, less the step times the row's first cell. Sums
     * wrap: the codes themselves do not. */
    .macro begin_filling
    ldrh    r5, [r2, #BAND_WIDTH]
    sub     r4, r6, r12
    muls    r4, r5, r4
    strd    r4, r5, [r3, #DEPTH_OUTLINE_ROW_CELL]
    stm     sp, {r0, r1, r2, r6, r7, r9, r12}

    /* r10: the first column, r12: the last one and one more, less the first. */
    sub     r8, r1, r0
    ldr     r10, [r0]
    mov     r12, r10
    cmp     r8, #24
    bne     .Lextend
    ldr     r4, [r0, #8]
    ldr     r5, [r0, #16]
    cmp     r4, r10
    ite     gt
    movgt   r12, r4
    movle   r10, r4
    cmp     r5, r12
    it      gt
    movgt   r12, r5
    cmp     r5, r10
    it      lt
    movlt   r10, r5
.Lextended:
    add     r10, r10, r11
    asr     r10, r10, #16
    rsb     r12, r10, r12, asr #16

    ldrd    r4, r5, [r3, #DEPTH_OUTLINE_VALUE]
    ldrd    r0, r1, [r3, #DEPTH_OUTLINE_DOWN]
    ldrd    r8, r9, [r3, #DEPTH_OUTLINE_ALONG]
    sub     r7, r7, r6
    umlal   r4, r5, r0, r6
    mla     r5, r1, r6, r5
    strd    r4, r5, [r3, #DEPTH_OUTLINE_VALUE]
    mov     r2, r4
    mov     r11, r5
    umlal   r2, r11, r8, r10
    mla     r11, r9, r10, r11       /* r2, r11: at the corner of the first row and column */
    umull   lr, r8, r8, r12
    mla     r9, r9, r12, r8         /* lr, r9: to the last column */
    subs    r7, r7, #1
    umull   r10, r12, r0, r7
    mla     r12, r1, r7, r12        /* r10, r12: to the last row */
    adds    r7, r2, lr
    adc     r6, r11, r9
    adds    r7, r7, r10
    adc     r0, r6, r12
    adds    r2, r2, r10
    adc     r1, r11, r12
    eor     r6, r6, r11
    eor     r0, r0, r11
    eor     r1, r1, r11
    orr     r0, r0, r1
    orr     r0, r0, r6
    clz     r0, r0
    clz     r1, r11                 /* octave */
    cmp     r0, r1
    ble     .Loctaves
    find_octave r1, r8, r9, r10, r0, .Loctaves, .Loctaves
    sub     r11, r10, #1
    cmp     r11, #31                /* drop: 1 to 32 */
    bhi     .Loctaves
    rsb     r0, r10, #32
    ldrd    r6, r7, [r3, #DEPTH_OUTLINE_DOWN]
    ldrd    r11, lr, [r3, #DEPTH_OUTLINE_ALONG]
    ldrd    r9, r12, [r3, #DEPTH_OUTLINE_ROW_CELL]
    lsr     r1, r4, r10
    lsls    r4, r4, r0
    lsls    r5, r5, r0
    orrs    r5, r5, r1
    lsr     r1, r6, r10
    lsls    r6, r6, r0
    lsls    r7, r7, r0
    orrs    r7, r7, r1
    lsr     r11, r11, r10
    lsl     lr, lr, r0
    orr     lr, lr, r11             /* step */
    add     r5, r5, r8
    mls     r5, lr, r9, r5
    mls     r7, lr, r12, r7
    add     r8, r3, #CODE
    stm     r8, {r4-r7, lr}
    movs    r0, #0
    str     r0, [r3, #DEPTH_OUTLINE_ZEROS]
.Loctaves:
    ldm     sp, {r0, r1, r2, r6, r7, r9, r12}
    .endm

/* The least number of pixels of a row that are painted by eights. */
#if FXL_KERNELS_MVE
#define MANY 4
#else
#define MANY 8
#endif

/* r12 counts the rows; of rows that may have several octaves its bit 31 is set as well, and it is 1
 * more. Bit 30 is set while the rest of a row is to be painted. */
#define SEVERAL_OCTAVES 0x80000000
#define REST_OF_ROW     0x40000000

    .macro fill_rows
    ldr     r0, [r2, #DEPTH_OUTLINE_ZEROS]
    cmp     r0, #0
    beq     .Lrow_of_one
    add     r12, r12, #1
    orr     r12, r12, #SEVERAL_OCTAVES
    b       .Lrow
    .endm

/* Triangles whose box has so many rows, columns and centres at most are drawn by edge functions. */
#define SMALL_ROWS    7
#define SMALL_COLUMNS 8
#define SMALL_CENTRES 40

#include "../raster/outline_armv7m.h"

#include "small_triangle_armv7m.h"

    /* More points than three. */
.Lextend:
    ldr     r4, [r0, #8]!
    cmp     r4, r10
    it      lt
    movlt   r10, r4
    cmp     r4, r12
    it      gt
    movgt   r12, r4
    subs    r8, r8, #8
    cmp     r8, #8
    bne     .Lextend
    b       .Lextended

    /* The rows of an outline of one octave.
     * The right edge is not right of the left one. */
.Lno_pixel_of_one:
    beq     .Lempty_of_one
    mov     r2, r8
    rsb     r0, r0, #0
    b       .Lspan_of_one
.Lempty_of_one:
    step_edges
    ldr     r1, [sp, #FRAME_OUTLINE]
    adds    r1, r1, #CODE
    ldm     r1, {r0, r2, r3, lr}
    adds    r0, r0, r3
    adc     r2, r2, lr
    strd    r0, r2, [r1]
    subs    r12, r12, #1
    bmi     .Lrows_done

.Lrow_of_one:
    mov     r2, r4
    subs    r0, r8, r4
    ble     .Lno_pixel_of_one
.Lspan_of_one:                      /* r0: pixels, r2: the first cell */
    ldr     r1, [sp, #FRAME_OUTLINE]
    step_edges
    stm     sp, {r4-r11}
    adds    r1, r1, #DEPTH_OUTLINE_CELLS
    ldm     r1, {r4-r10, lr}        /* cells, pixels, filling, code, its change a row, step */
    mla     r3, lr, r2, r8
    adds    r7, r7, r9
    adc     r8, r8, r10
    strd    r7, r8, [r1, #CODE - DEPTH_OUTLINE_CELLS]
    add     r4, r4, r2, lsl #1
    add     r2, r4, r0, lsl #1
    cmp     r0, #MANY
    blo     .Lfew
    sub     r11, r2, #16
    b       .Lmany

/* The pixels of a row of one octave, until .Lrow_done: r2: the end of the cells, r3: the code of
 * the first, lr: the step, r4: the first cell, r5: to its pixel, r6: the filling, r11: the last
 * cell at which eight begin. */
.Lrow:
    mov     r2, r4
    subs    r0, r8, r4
    ble     .Lno_pixel
.Lspan:                             /* r0: pixels, r2: the first cell */
    ldr     r1, [sp, #FRAME_OUTLINE]
    step_edges
    stm     sp, {r4-r11}
    ldm     r1!, {r4-r11}           /* value, along, down, and the row's first cell and cells */
    sub     r3, r2, r10             /* the column */
    add     r10, r10, r11
    adds    r8, r4, r8
    adc     r9, r5, r9
    strd    r8, r9, [r1, #DEPTH_OUTLINE_VALUE - DEPTH_OUTLINE_ZEROS]
    str     r10, [r1, #DEPTH_OUTLINE_ROW_CELL - DEPTH_OUTLINE_ZEROS]

    /* r4, r5: the value in column 0, r6, r7: along. Whether the first pixel and the last are in the
     * octave that is known: then all are, as the value is linear. */
.Lpart:
    umull   r10, r9, r6, r3
    mla     r9, r7, r3, r9
    adds    r10, r10, r4
    adc     r9, r9, r5
    clz     r11, r9
    sub     r8, r0, #1
    umlal   r10, r9, r6, r8
    mla     r9, r7, r8, r9
    clz     r9, r9
    ldm     r1, {r6, r7, r8, lr}    /* zeros, drop, bias, step */
    cmp     r11, r6
    it      eq
    cmpeq   r9, r6
    bne     .Loctave
.Lcode:
    mla     r8, lr, r3, r8
    shift_by r7, r4, r5, r9
    add     r3, r8, r4

#include "depth_pixels_armv7m.h"

    /* The right edge is not right of the left one. */
.Lno_pixel:
    beq     .Lempty
    mov     r2, r8
    rsb     r0, r0, #0
    b       .Lspan
.Lempty:
    step_edges
    ldr     r1, [sp, #FRAME_OUTLINE]
    ldrd    r2, r3, [r1, #DEPTH_OUTLINE_DOWN]
    ldrd    r0, lr, [r1, #DEPTH_OUTLINE_VALUE]
    adds    r2, r2, r0
    adc     r3, r3, lr
    strd    r2, r3, [r1, #DEPTH_OUTLINE_VALUE]
    ldrd    r2, r3, [r1, #DEPTH_OUTLINE_ROW_CELL]
    add     r2, r2, r3
    str     r2, [r1, #DEPTH_OUTLINE_ROW_CELL]
    subs    r12, r12, #1
    b       .Lrow_of_several_done

    /* Another octave than that of the pixels before: that of r11 leading zeros. r9: those of the
     * last pixel. */
.Loctave:
    cmp     r11, r9
    bne     .Lsplit
.Lone_octave:
    str     r3, [r1, #DEPTH_OUTLINE_REST + 20 - DEPTH_OUTLINE_ZEROS]
    sub     r3, r1, #DEPTH_OUTLINE_ZEROS
    find_octave r11, r8, r10, r7, r9, .Lnearer, .Lfarther
    ldr     r3, [r1, #DEPTH_OUTLINE_REST + 20 - DEPTH_OUTLINE_ZEROS]
    ldrd    r9, r10, [r1, #DEPTH_OUTLINE_ALONG - DEPTH_OUTLINE_ZEROS]
    shift_by r7, r9, r10, r6
    mov     lr, r9                  /* step */
    mov     r6, r11
    stm     r1, {r6, r7, r8, lr}
    b       .Lcode
.Lnearer:
    mov     r3, #-1
    mov     lr, #0
    b       .Lpixels
.Lfarther:
    mov     r3, #65536
    mov     lr, #0
    b       .Lpixels

    /* The columns until r9 are in the octave of the first: found by halving. */
.Lsplit:
    str     r2, [r1, #DEPTH_OUTLINE_REST - DEPTH_OUTLINE_ZEROS]
    ldrd    r6, r7, [r1, #DEPTH_OUTLINE_ALONG - DEPTH_OUTLINE_ZEROS]
    mov     r8, r3
    add     r9, r3, r0
    sub     r9, r9, #1
.Lhalve:
    sub     r10, r9, r8
    cmp     r10, #1
    bls     .Lhalved
    add     r10, r8, r10, lsr #1
    umull   lr, r2, r6, r10
    mla     r2, r7, r10, r2
    adds    lr, lr, r4
    adc     r2, r2, r5
    clz     r2, r2
    cmp     r2, r11
    ite     eq
    moveq   r8, r10
    movne   r9, r10
    b       .Lhalve
.Lhalved:
    ldr     r2, [r1, #DEPTH_OUTLINE_REST - DEPTH_OUTLINE_ZEROS]
    sub     r6, r9, r3              /* pixels of the first octave */
    add     r8, r2, r6
    strd    r8, r9, [r1, #DEPTH_OUTLINE_REST - DEPTH_OUTLINE_ZEROS]
    strd    r4, r5, [r1, #DEPTH_OUTLINE_REST + 8 - DEPTH_OUTLINE_ZEROS]
    sub     r0, r0, r6
    str     r0, [r1, #DEPTH_OUTLINE_REST + 16 - DEPTH_OUTLINE_ZEROS]
    mov     r0, r6
    add     r12, r12, #1            /* the rest comes before the rows below */
    orr     r12, r12, #REST_OF_ROW
    b       .Lone_octave
