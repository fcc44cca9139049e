/* SPDX-License-Identifier: MIT */
/* fxl_draw_texel_outline for Armv7-M and Armv8-M Mainline. lib/paint/smooth_outline.h states what it
 * requires and does; lib/paint/texel_outline.c paints the same pixels, by paint_any. A row takes 40
 * instructions before its pixels, a visible pixel 21, with light 43, and 39 if the dark colour is 0,
 * and a hidden one 9 or 10. */
#include "../math/family.h"

#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT

#include "../math/offsets.h"
#include "../raster/draw_frame_armv7m.h"
#include "cell_edges_armv7m.h"

/* What pixels depend on, from the member `cells` on. */
#define OF(member) (TEXEL_OUTLINE_##member - TEXEL_OUTLINE_CELLS)

    .syntax unified
    .thumb

    .section .text.fxl_draw_texel_outline, "ax", %progbits
    .global fxl_draw_texel_outline
    .type fxl_draw_texel_outline, %function
    .thumb_func

/* At the first row, r6: the words of cell 0 of the band, as if it were in that row, less their change
 * from row to row, which is less a row of cells. r12: the band's first row. */
    .macro begin_filling
    ldrh    r10, [r2, #BAND_WIDTH]
    sub     r11, r6, r12
    mul     r11, r11, r10           /* the row's first cell */
    .irp    word, 0, 4, 8, 12
    ldr     r4, [r3, #\word]
    ldr     r5, [r3, #TEXEL_OUTLINE_DOWN + \word]
    ldr     r8, [r3, #TEXEL_OUTLINE_ALONG + \word]
    mla     r4, r5, r6, r4
    mls     r4, r8, r11, r4
    mls     r5, r8, r10, r5
    sub     r4, r4, r5
    str     r4, [r3, #\word]
    str     r5, [r3, #TEXEL_OUTLINE_DOWN + \word]
    .endr
    .endm

    .macro  fill_rows
    b       .Lrow
    .endm

/* The pixel is tested. r3: the code, r11: the cell, which becomes the next one. */
    .macro  test_pixel text, bent
    .if     \bent
    ldr     r1, [lr, #OF(BORDER)]
    subs    r1, r3, r1
    ite     lo
    addlo   r1, r1, r3
    movhs   r1, r3
    lsr     r1, r1, #16
    .else
    lsr     r1, r3, #16
    .endif
    ldrh    r0, [r11], #2
    cmp     r1, r0
    bls     .Lhidden\text
    strh    r1, [r11, #-2]
    .endm

/* r0: the place of the texel. r4, r5: u, v. Overwrites r1. */
    .macro  find_place
    ldrd    r0, r1, [lr, #OF(MASKS)]
    and     r0, r0, r4, lsr #24
    and     r1, r1, r5, lsr #16
    add     r0, r0, r1
    .endm

    .macro  next_pixel text
.Lhidden\text:
    add     r3, r3, r7
    add     r4, r4, r8
    add     r5, r5, r9
    .endm

/* Pixels without light. r2: to the pixel, r6: texels, r10: palette, r12: the end of the cells. */
    .macro  paint_row text, wide, bent
    ldrd    r6, r10, [lr, #OF(TEXELS)]
    ldr     r2, [lr, #OF(PIXELS)]
.Lpixel\text:
    test_pixel \text, \bent
    find_place
    .if     \wide
    ldrh    r0, [r6, r0, lsl #1]
    .else
    ldrb    r0, [r6, r0]
    ldrh    r0, [r10, r0, lsl #1]
    .endif
    strh    r0, [r11, r2]
    next_pixel \text
    cmp     r11, r12
    blo     .Lpixel\text
    b       .Lpixels_done
    .endm

/* The same with light, r6, and its step, r10; the end of the cells is in the record too. */
    .macro  paint_lit_row text, wide, bent, dark
    str     r12, [lr, #OF(END)]
.Lpixel\text:
    test_pixel \text, \bent
    find_place
    ldrd    r1, r2, [lr, #OF(TEXELS)]
    .if     \wide
    ldrh    r0, [r1, r0, lsl #1]
    .else
    ldrb    r0, [r1, r0]
    ldrh    r0, [r2, r0, lsl #1]
    .endif
    ldr     r1, [lr, #OF(PART_OF_LEVEL)]
    umull   r2, r1, r6, r1          /* the part */
    and     r2, r0, #0x7E0
    lsr     r12, r0, #11
    and     r0, r0, #31
    orr     r0, r0, r12, lsl #19
    .if     \dark
    ldr     r12, [lr, #OF(GREEN_STEP)]
    add     r2, r2, r12
    .endif
    ldr     r12, [lr, #OF(GREEN_DARK)]
    mla     r2, r2, r1, r12
    .if     \dark
    ldr     r12, [lr, #OF(RED_STEP)]
    add     r0, r0, r12
    .endif
    ldr     r12, [lr, #OF(RED_DARK)]
    mla     r0, r0, r1, r12
    lsr     r2, r2, #13
    bfi     r0, r2, #13, #6         /* green above blue */
    lsr     r2, r0, #27
    lsr     r0, r0, #8
    bfi     r0, r2, #11, #5
    ldr     r12, [lr, #OF(PIXELS)]
    strh    r0, [r11, r12]
    ldr     r12, [lr, #OF(END)]
    next_pixel \text
    add     r6, r6, r10
    cmp     r11, r12
    blo     .Lpixel\text
    b       .Lpixels_done
    .endm

/* r0: points, r1: count, r2: band, r3: outline; returns whether it was drawn. */
fxl_draw_texel_outline:
#include "../raster/outline_armv7m.h"

    /* The right edge is not right of the left one. */
.Lexchanged_row:
    mov     r2, r8
    rsb     r0, r0, #0
    b       .Lspan

.Lpixels_done:
    ldr     r1, [sp, #FRAME_OUTLINE]
    ldr     r12, [r1, #TEXEL_OUTLINE_ROWS]
    ldm     sp, {r4-r11}
    subs    r12, r12, #1
    bmi     .Lrows_below
.Lrow:
    mov     r2, r4
    subs    r0, r8, r4
    blt     .Lexchanged_row
.Lspan:                             /* r0: pixels, r2: the first cell */
    ldr     lr, [sp, #FRAME_OUTLINE]
    step_edges
    stm     sp, {r4-r11}
    str     r12, [lr, #TEXEL_OUTLINE_ROWS]
    ldm     lr, {r3-r10}            /* code, u, v, light, and what a row adds */
    add     r3, r3, r7
    add     r4, r4, r8
    add     r5, r5, r9
    add     r6, r6, r10
    stm     lr, {r3-r6}
    cmp     r0, #0
    beq     .Lpixels_done
    add     lr, lr, #TEXEL_OUTLINE_ALONG
    ldm     lr!, {r7-r11}           /* what a pixel adds, and the cells of the band */
    sub     lr, lr, #4
    mla     r3, r7, r2, r3
    mla     r4, r8, r2, r4
    mla     r5, r9, r2, r5
    mla     r6, r10, r2, r6
    add     r11, r11, r2, lsl #1
    add     r12, r11, r0, lsl #1
    ldr     r1, [lr, #OF(KIND)]
    tbh     [pc, r1, lsl #1]
.Lkinds:
    .irp    number, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 10, 11
    .short  (.Lkind\number - .Lkinds) / 2
    .endr
.Lkind0:
    paint_row 0, 0, 0
.Lkind1:
    paint_row 1, 1, 0
.Lkind2:
    paint_lit_row 2, 0, 0, 1
.Lkind3:
    paint_lit_row 3, 1, 0, 1
.Lkind4:
    paint_row 4, 0, 1
.Lkind5:
    paint_row 5, 1, 1
.Lkind6:
    paint_lit_row 6, 0, 1, 1
.Lkind7:
    paint_lit_row 7, 1, 1, 1
.Lkind10:
    paint_lit_row 10, 0, 0, 0
.Lkind11:
    paint_lit_row 11, 1, 0, 0

    .size fxl_draw_texel_outline, . - fxl_draw_texel_outline

#endif
