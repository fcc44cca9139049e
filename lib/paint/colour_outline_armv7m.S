/* SPDX-License-Identifier: MIT */
/* fxl_draw_colour_outline for Armv7-M and Armv8-M Mainline. It finds the rows of an outline first, and then fills
 * them, so that neither keeps what the other has in registers. A row takes 11 instructions where it is
 * found and 20 before its pixels, a visible pixel 13, and a hidden one 6. */
#include "../math/family.h"

#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT

    .syntax unified
    .thumb

#include "../math/offsets.h"
#include "../raster/draw_frame_armv7m.h"

/* In the frame, above what all kernels of outlines have there: rows are listed, and filled when all are, or
 * LIST_ROWS of them. */
#define LIST_ORIGIN 76 /* the cell of the face's column in the next row */
#define LIST_WIDTH  80 /* cells a row */
#define LIST_END    84 /* the outline's last row plus 1 */
#define LIST_ABOVE  88 /* the row above the first one */
#define LIST_NEXT   92
#define LIST_CELL   96 /* that of the face's column in the row above */
#define LIST_DOWN   100 /* from the end of a row's cells to the same column of the next row: what it adds to code and green;
                           then what a row adds to red and blue */
#define LIST_BEGIN  116
#define LIST_ROWS   16
#define LISTED      12 /* of a row: pixels, columns from the face's to the first one, its cell */

#define LISTS_ROWS
#undef FRAME_SIZE
#define FRAME_SIZE (LIST_BEGIN + (LIST_ROWS + 1) * LISTED)

#include "cell_edges_armv7m.h"

/* A cell's number is half of its address. */
    .macro begin_filling
    test_clear COLOUR_OUTLINE_CELLS
    lsr     r10, r4, #1
    ldr     r4, [r3, #COLOUR_OUTLINE_COLUMN]
    ldrh    r5, [r2, #BAND_WIDTH]
    sub     r8, r6, r12
    add     r4, r4, r10
    mla     r4, r5, r8, r4
    sub     r8, r6, #1
    add     r11, sp, #LIST_BEGIN
    add     lr, sp, #LIST_ORIGIN
    stm     lr, {r4, r5, r7, r8, r11}
    subs    r4, r4, r5
    str     r4, [sp, #LIST_CELL]
    add     r8, r6, #LIST_ROWS
    cmp     r7, r8
    it      gt
    movgt   r7, r8
    .endm

/* r5, r10: as begin_filling leaves them. */
    .purgem find_base
    .macro find_base
    mls     r6, r12, r5, r10
    mov     r7, r5
    adds    r6, r6, #1
    .endm

/* Lists the rows of a trapezoid. */
    .macro fill_rows
    ldrd    r1, r2, [sp, #LIST_ORIGIN]
    ldr     lr, [sp, #LIST_NEXT]
.Lrow:
    subs    r0, r8, r4
    blt     .Lexchanged_row
    subs    r3, r4, r1
    stm     lr!, {r0, r3, r4}
.Lrow_listed:
    add     r1, r1, r2
    step_edges
    subs    r12, r12, #1
    bpl     .Lrow
    str     r1, [sp, #LIST_ORIGIN]
    str     lr, [sp, #LIST_NEXT]
    b       .Lrows_below
    .endm

/* A pixel. r2: the end of the cells, r3: the code, r4: the cell, r5: green, r6: both,
 * r9: to the pixel, r10: step, r11: green step, r12: the code's step, lr: the border. */
    .macro  paint_pixel_of_colours text, bent
.Lpixel\text:
    .if     \bent
    subs    r1, r3, lr
    ite     lo
    addlo   r1, r1, r3
    movhs   r1, r3
    lsrs    r1, r1, #16
    ldrh    r0, [r4], #2
    cmp     r1, r0
    bls     .Lhidden\text
    .else
    ldrh    r0, [r4], #2
    cmp     r0, r3, lsr #16
    bhs     .Lhidden\text
    lsrs    r1, r3, #16
    .endif
    strh    r1, [r4, #-2]
    lsrs    r0, r5, #26
    and     r1, r6, #0xf800
    orr     r0, r1, r0, lsl #5
    orr     r0, r0, r6, lsr #27
    strh    r0, [r4, r9]
.Lhidden\text:
    add     r3, r3, r12
    add     r6, r6, r10
    add     r5, r5, r11
    .endm

/* The pixels of a row: eight at a time, of which the first time begins with what is over. */
    .macro  paint_row_of_colours text, bent
    .if     \bent == 0
    and     r0, r0, #7
    tbb     [pc, r0]
.Lfirsts:
    .irp    over, 8, 1, 2, 3, 4, 5, 6, 7
    .byte   (.Lpixel\over - .Lfirsts) / 2
    .endr
    no_pixels_of_row \text
    .irp    left, 8, 7, 6, 5, 4, 3, 2, 1
    paint_pixel_of_colours \left, 0
    .endr
    cmp     r4, r2
    bhs     .Llisted\text
    b       .Lpixel8
    .else
    paint_pixel_of_colours \text, 1
    cmp     r4, r2
    blo     .Lpixel\text
    b       .Llisted\text
    no_pixels_of_row \text
    .endif
    .endm

/* A row without any pixel, or the end of the list. */
    .macro  no_pixels_of_row text
.Lno_pixels\text:
    cmp     r2, #0
    beq     .Lfilled
    next_row_of_colours
    b       .Llisted\text
    .endm

/* The rows of the list. r3, r5: code and green of the cell r4 in the row above, r7, r8: red and blue of that
 * row in the face's column. */
    .macro  fill_listed text, bent
.Llisted\text:
    .if     \bent
    ldr     lr, [sp, #LIST_NEXT]
    .endif
    ldm     lr!, {r0, r1, r2}
    .if     \bent
    str     lr, [sp, #LIST_NEXT]
    .endif
    cbz     r0, .Lno_pixels\text
    sub     r6, r2, r4, lsr #1
    lsls    r4, r2, #1
    mla     r3, r12, r6, r3
    mla     r5, r11, r6, r5
    next_row_of_colours
    lsl     r2, r8, #5
    bfc     r2, #0, #16
    add     r2, r2, r7, asr #11
    mla     r6, r10, r1, r2
    add     r2, r4, r0, lsl #1
    .if     \bent
    ldr     lr, [sp, #FRAME_OUTLINE]
    ldr     lr, [lr, #COLOUR_OUTLINE_BORDER]
    .endif
    paint_row_of_colours \text, \bent
    .endm

    .macro  next_row_of_colours
    ldrd    r2, r6, [sp, #LIST_DOWN]
    add     r3, r3, r2
    add     r5, r5, r6
    ldrd    r2, r6, [sp, #LIST_DOWN + 8]
    add     r7, r7, r2
    add     r8, r8, r6
    .endm

    .section .text.fxl_draw_colour_outline, "ax", %progbits
    .global fxl_draw_colour_outline
    .type fxl_draw_colour_outline, %function
    .thumb_func

/* r0: points, r1: count, r2: band, r3: outline; returns whether it was drawn. */
fxl_draw_colour_outline:
#include "../raster/outline_armv7m.h"

    return_not_clear

    /* The right edge is not right of the left one. */
.Lexchanged_row:
    negs    r0, r0
    sub     r3, r8, r1
    stm     lr!, {r0, r3, r8}
    b       .Lrow_listed

.Lall_listed:
    stm     sp, {r4-r11}
    ldr     lr, [sp, #LIST_NEXT]
    movs    r0, #0
    str     r0, [lr]
    str     r0, [lr, #8]
    ldr     r1, [sp, #FRAME_OUTLINE]
    ldr     r0, [sp, #LIST_ABOVE]
    ldr     r2, [sp, #LIST_WIDTH]
    ldm     r1!, {r3-r12}           /* code, green; red, blue; column, the code's step */
    mla     r3, r4, r0, r3
    mla     r5, r6, r0, r5
    strd    r8, r10, [sp, #LIST_DOWN + 8]
    mla     r7, r8, r0, r7
    mla     r8, r10, r0, r9
    mla     r3, r12, r11, r3
    mls     r4, r12, r2, r4
    ldm     r1, {r9-r11, lr}        /* pixels, steps, border */
    lsls    r5, r5, #4
    lsls    r6, r6, #4
    mls     r6, r11, r2, r6
    strd    r4, r6, [sp, #LIST_DOWN]
    ldr     r4, [sp, #LIST_CELL]
    lsls    r4, r4, #1
    cmp     lr, #0
    add     lr, sp, #LIST_BEGIN
    bne     .Lfill_bent
    fill_listed _linear, 0

.Lfilled:
    ldrd    r6, r7, [sp, #LIST_END]
    adds    r7, r7, #LIST_ROWS
    subs    r0, r6, #1
    cmp     r7, r0
    blt     .Llist_again
    movs    r0, #1
    add     sp, sp, #FRAME_SIZE
    pop     {r4-r11, pc}

.Lfill_bent:
    str     lr, [sp, #LIST_NEXT]
    fill_listed _bent, 1

.Llist_again:                       /* r0: the last row, r7: the row above */
    ldrd    r4, r5, [sp, #LIST_ORIGIN]
    add     r6, sp, #LIST_BEGIN
    strd    r7, r6, [sp, #LIST_ABOVE]
    subs    r4, r4, r5
    str     r4, [sp, #LIST_CELL]
    adds    r7, r7, #LIST_ROWS
    cmp     r0, r7
    it      gt
    movgt   r0, r7
    str     r0, [sp, #FRAME_LAST]
    ldm     sp, {r4-r11}
    b       .Lrows_below

    .size fxl_draw_colour_outline, . - fxl_draw_colour_outline

#endif
