/* SPDX-License-Identifier: MIT */
/* fxl_paint_colour_run and fxl_draw_colour_outline for Armv7-M and Armv8-M Mainline. A run takes 7
 * instructions a pixel, and 2 for each eight of them; compilers take 9. A row of an outline takes
 * 38 before its pixels, a visible pixel 15, and a hidden one 9. */
#include "../math/family.h"

#if FXL_KERNELS_ARMV7M

    .syntax unified
    .thumb

pixels     .req r1
count      .req r2     /* then eights */
both       .req r3
green      .req r4
step       .req r5
green_step .req r6
colour     .req r7
channel    .req r12

    .section .text.fxl_paint_colour_run, "ax", %progbits
    .global fxl_paint_colour_run
    .type fxl_paint_colour_run, %function
    .thumb_func

    .macro paint_pixel
    lsrs    colour, green, #26
    and     channel, both, #0xf800
    orr     colour, channel, colour, lsl #5
    orr     colour, colour, both, lsr #27
    add     both, both, step
    add     green, green, green_step
    strh    colour, [pixels], #2
    .endm

/* r0: words, r1: pixels, r2: count. What is left over eights is painted first. */
fxl_paint_colour_run:
    push    {r4-r7}
    ldm     r0, {both, green, step, green_step}
    adds    count, #7
    and     r0, count, #7
    lsrs    count, #3
    tbb     [pc, r0]
.Lparts:
    .byte   (.Lpixel7 - .Lparts) / 2, (.Lpixel6 - .Lparts) / 2
    .byte   (.Lpixel5 - .Lparts) / 2, (.Lpixel4 - .Lparts) / 2
    .byte   (.Lpixel3 - .Lparts) / 2, (.Lpixel2 - .Lparts) / 2
    .byte   (.Lpixel1 - .Lparts) / 2, (.Lpixel0 - .Lparts) / 2
    .irp    number, 0, 1, 2, 3, 4, 5, 6, 7
.Lpixel\number:
    paint_pixel
    .endr
    subs    count, #1
    bne     .Lpixel0
    pop     {r4-r7}
    bx      lr

    .size fxl_paint_colour_run, . - fxl_paint_colour_run

#if !FXL_IS_COMPACT

#include "../math/offsets.h"
#include "../raster/draw_frame_armv7m.h"
#include "cell_edges_armv7m.h"

    .section .text.fxl_draw_colour_outline, "ax", %progbits
    .global fxl_draw_colour_outline
    .type fxl_draw_colour_outline, %function
    .thumb_func

/* At the first row, r6: its words, less the change from row to row. */
    .macro begin_filling
    test_clear COLOUR_OUTLINE_CELLS
    ldm     r3, {r4, r5, r8, r10, r11}
    .irp    number, r4, r5, r8, r10, r11
    ldr     lr, [r3, #COLOUR_OUTLINE_CODE_DOWN + .Lword]
    mla     \number, lr, r6, \number
    .set    .Lword, .Lword + 4
    .endr
    stm     r3, {r4, r5, r8, r10, r11}
    .endm
    .set    .Lword, 0

    .macro fill_rows
    b       .Lrow
    .endm

/* The pixels of a row. r2: the end of the cells, r3: the code, r4: the cell, r5: green, r6: both,
 * r9: to the pixel, r10: step, r11: green step, r12: the code's step, lr: the border. */
    .macro  paint_row_of_colours text, bent
.Lpixel\text:
    .if     \bent
    subs    r1, r3, lr
    ite     lo
    addlo   r1, r1, r3
    movhs   r1, r3
    lsr     r1, r1, #16
    .else
    lsr     r1, r3, #16
    .endif
    ldrh    r0, [r4], #2
    cmp     r1, r0
    bls     .Lhidden\text
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
    cmp     r4, r2
    blo     .Lpixel\text
    .endm

/* r0: points, r1: count, r2: band, r3: outline; returns whether it was drawn. */
fxl_draw_colour_outline:
#include "../raster/outline_armv7m.h"

    return_not_clear

    /* The right edge is not right of the left one. */
.Lexchanged_row:
    mov     r2, r8
    rsb     r0, r0, #0
    b       .Lspan

.Lrow:
    mov     r2, r4
    subs    r0, r8, r4
    blt     .Lexchanged_row
.Lspan:                             /* r0: pixels, r2: the first cell */
    ldr     r1, [sp, #FRAME_OUTLINE]
    step_edges
    stm     sp, {r4-r11}
    str     r12, [r1, #COLOUR_OUTLINE_ROWS]
    ldm     r1, {r3-r12}            /* code, red, green, blue, origin, and what a row adds */
    add     r3, r3, r8
    add     r4, r4, r9
    add     r5, r5, r10
    add     r6, r6, r11
    add     r7, r7, r12
    stm     r1!, {r3-r7}
    cbz     r0, .Lpixels_done
    adds    r1, r1, #COLOUR_OUTLINE_CELLS - COLOUR_OUTLINE_CODE_DOWN
    ldm     r1, {r8-r12, lr}        /* cells, pixels, steps, the code's step, border */
    sub     r7, r2, r7              /* columns from the face's */
    asrs    r4, r4, #11
    asrs    r6, r6, #11
    add     r6, r4, r6, lsl #16
    mla     r6, r10, r7, r6
    lsls    r5, r5, #4
    mla     r5, r11, r7, r5
    mla     r3, r12, r2, r3
    add     r4, r8, r2, lsl #1
    add     r2, r4, r0, lsl #1
    cmp     lr, #0
    bne     .Lpixel_bent
    paint_row_of_colours _linear, 0

.Lpixels_done:
    ldr     r1, [sp, #FRAME_OUTLINE]
    ldr     r12, [r1, #COLOUR_OUTLINE_ROWS]
    ldm     sp, {r4-r11}
    subs    r12, r12, #1
    bpl     .Lrow
    b       .Lrows_below

    paint_row_of_colours _bent, 1
    b       .Lpixels_done

    .size fxl_draw_colour_outline, . - fxl_draw_colour_outline

#endif

#endif
