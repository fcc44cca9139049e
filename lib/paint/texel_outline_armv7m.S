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

/* What pixels depend on, from the member `cells` on, and their change. */
#define OF(member) (TEXEL_OUTLINE_##member - TEXEL_OUTLINE_CELLS)

    .syntax unified
    .thumb

    .section .text.fxl_draw_texel_outline, "ax", %progbits
    .global fxl_draw_texel_outline
    .type fxl_draw_texel_outline, %function
    .thumb_func

/* Where the loops of pixels go on after a row; r3: the outline. Overwrites r4. */
    .macro resume_at place
    adr     r4, \place
    adds    r4, r4, #1              /* Thumb */
    str     r4, [r3, #TEXEL_OUTLINE_RESUME]
    .endm

/* At the first row, r6: the words of cell 0 of the band, as if it were in that row, less their change
 * from row to row, which is less a row of cells. r12: the band's first row. */
    .macro begin_filling
    ldrh    r10, [r2, #BAND_WIDTH]
    sub     r11, r6, r12
    mul     r11, r11, r10           /* the row's first cell */
    add     lr, r3, #TEXEL_OUTLINE_DOWN
.Lnext_word:
    ldr     r8, [r3, #TEXEL_OUTLINE_ALONG]
    ldr     r5, [r3, #TEXEL_OUTLINE_DOWN]
    ldr     r4, [r3]
    mla     r4, r5, r6, r4
    mls     r4, r8, r11, r4
    mls     r5, r8, r10, r5
    sub     r4, r4, r5
    str     r5, [r3, #TEXEL_OUTLINE_DOWN]
    str     r4, [r3], #4
    cmp     r3, lr
    bne     .Lnext_word
    sub     r3, r3, #TEXEL_OUTLINE_DOWN
    resume_at .Lpixels_done
    .endm

    .macro  fill_rows
    b       .Lrow
    .endm

/* The pixel is tested. r3: the code, r11: the cell, which becomes the next one. */
    .macro  test_pixel text
    lsr     r1, r3, #16
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
    .macro  paint_row text, wide
    ldrd    r6, r10, [lr, #OF(TEXELS)]
    ldr     r2, [lr, #OF(PIXELS)]
.Lpixel\text:
    test_pixel \text
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
    ldr     pc, [lr, #OF(RESUME)]
    .endm

/* The texel in r0 and the part of it in r1, of lit pixels; r6: light, r10: its step. */
    .macro  find_lit_texel text, wide
    test_pixel \text
    find_place
    ldrd    r1, r2, [lr, #OF(TEXELS)]
    .if     \wide
    ldrh    r0, [r1, r0, lsl #1]
    .else
    ldrb    r0, [r1, r0]
    ldrh    r0, [r2, r0, lsl #1]
    .endif
    ldr     r1, [lr, #OF(PART_OF_LEVEL)]
    umull   r2, r1, r6, r1
    and     r2, r0, #0x7E0
    .endm

/* On to the next one. */
    .macro  next_lit_pixel text
    next_pixel \text
    add     r6, r6, r10
    cmp     r11, r12
    blo     .Lpixel\text
    ldr     pc, [lr, #OF(RESUME)]
    .endm

/* The end of the cells, r12, is in the record too. */
    .macro  paint_lit_row text, wide
    str     r12, [lr, #OF(END)]
.Lpixel\text:
    find_lit_texel \text, \wide
    lsr     r12, r0, #11
    and     r0, r0, #31
    orr     r0, r0, r12, lsl #19
    ldr     r12, [lr, #OF(GREEN_STEP)]
    add     r2, r2, r12
    ldr     r12, [lr, #OF(GREEN_DARK)]
    mla     r2, r2, r1, r12
    ldr     r12, [lr, #OF(RED_STEP)]
    add     r0, r0, r12
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
    next_lit_pixel \text
    .endm

/* The same where the dark colour is 0: halves of a part are all that is added, and red is from bit 16 on. */
    .macro  paint_black_row text, wide
.Lpixel\text:
    find_lit_texel \text, \wide
    orr     r0, r0, r0, lsl #5
    bfc     r0, #5, #11
    mul     r2, r2, r1
    mul     r0, r0, r1
    add     r2, r2, #1 << 12
    add     r0, r0, #0x00800080
    lsr     r2, r2, #13
    lsr     r1, r0, #24
    orr     r2, r2, r1, lsl #6
    lsr     r0, r0, #8
    bfi     r0, r2, #5, #11
    ldr     r1, [lr, #OF(PIXELS)]
    strh    r0, [r11, r1]
    next_lit_pixel \text
    .endm

/* Triangles with so many rows at most: their rows are found by edge functions. */
#define SMALL_ROWS 32

/* In the stack frame of such a triangle, whose points are taken from the highest one, T, on: T, N, P. r0-r11: the
 * changes of the edge functions from column to column and row to row, their values in column
 * SMALL_COLUMN - 1 of a row, the outline, the row and its first cell:
 *
 *         column  row  value
 *   T-N   r10     r5   r1
 *   N-P   r11     r6   r2
 *   P-T   r0      r4   r7
 */
#define SMALL_END    52 /* the last row plus 1; then bytes of a row of cells */
#define SMALL_COLUMN 60

/* r0: points, r1: count, r2: band, r3: outline; returns whether it was drawn. */
fxl_draw_texel_outline:
#include "../raster/outline_armv7m.h"

    /* r0: points, r1: their end, r2: band, r3: outline, r6: first row, r7: last row plus 1, r8: rows, r9: one past
     * T. Points are taken relative to a centre of the first row that is 64 columns or more left of T and left of
     * the others: x is below 2^23, y below 2^21.1, so a function is below 2^29.1. */
.Lsmall:
    ldr     r12, [r2, #BAND_FIRST_ROW]
    uxth    lr, r12
    add     r12, lr, r12, lsr #16
    cmp     r6, lr
    it      ge
    cmpge   r12, r7
    blt     .Ltwo_chains
    cmp     r8, #0
    beq     .Ltwo_chains
    stm     sp, {r0-r3, r6-r9}
    ldrh    r4, [r2, #BAND_WIDTH]
    sub     r5, r6, lr
    mul     r5, r5, r4
    ldr     lr, [r3, #TEXEL_OUTLINE_CELLS]
    add     lr, lr, r5, lsl #1      /* the row's first cell */
    lsl     r4, r4, #1
    strd    r7, r4, [sp, #SMALL_END]
/* place fill-rule: small triangles with texels for Armv7-M */
    lsl     r11, r6, #16
    add     r11, r11, #32768
    ldrd    r4, r5, [r9, #-8]
    cmp     r9, r1
    it      eq
    moveq   r9, r0
    ldrd    r6, r7, [r9], #8
    cmp     r9, r1
    it      eq
    moveq   r9, r0
    ldrd    r8, r9, [r9]
    sub     r10, r4, #64 << 16
    bfc     r10, #0, #16
    asr     r12, r10, #16
    add     r12, r12, #1
    str     r12, [sp, #SMALL_COLUMN]
    add     r10, r10, #32768
    relative_points
    cmp     r6, #128 << 16
    it      lo
    cmplo   r8, #128 << 16
    bhs     .Lsmall_not
    functions_of_points
    cmp     r10, #0
    itt     ne
    cmpne   r11, #0
    cmpne   r0, #0
    beq     .Lsmall_not             /* a level edge */
    mov     r9, lr
    adr     lr, .Lsmall_next
    adds    lr, lr, #1
    str     lr, [r3, #TEXEL_OUTLINE_RESUME]
    ldr     r8, [sp, #16]
    stm     sp, {r0-r11}

    /* A row. T-N is a right edge, P-T a left one, and N-P the second of either kind. Where there is one of a kind, the
     * column is on its outer side in all rows: a left edge is below 0 there, a right one is not. With two of
     * a kind a row may be beyond one of them: then the column may be inside of a left one, which counts as 1; a
     * right one is further right than the other. */
.Lsmall_row:
    cmp     r11, #0
    bgt     .Lsmall_left
    mvn     r5, r7
    udiv    r5, r5, r0              /* columns outside of left edges, less 1 */
    sdiv    r4, r1, r10             /* columns inside of right edges, less 1, negated */
    sdiv    r6, r2, r11
    cmp     r4, r6
    it      lt
    movlt   r4, r6
.Lsmall_span:
    adds    r0, r4, r5
    bpl     .Lsmall_next            /* no pixel */
    rsb     r0, r0, #0              /* pixels */
    ldr     r2, [sp, #SMALL_COLUMN]
    add     r2, r2, r5              /* the first one's column */
    add     r11, r9, r2, lsl #1
    mov     r1, r8
    add     lr, r3, #TEXEL_OUTLINE_ALONG
    ldm     r3, {r3-r10}            /* code, u, v, light, and what a row adds */
    mla     r3, r7, r1, r3
    mla     r4, r8, r1, r4
    mla     r5, r9, r1, r5
    mla     r6, r10, r1, r6
    ldm     lr!, {r7-r10}           /* what a pixel adds */
    b       .Lpixels

.Lsmall_left:
    mvn     r5, r7
    mvn     r6, r2
    bic     r5, r5, r5, asr #31
    bic     r6, r6, r6, asr #31
    udiv    r5, r5, r0
    udiv    r6, r6, r11
    cmp     r5, r6
    it      lo
    movlo   r5, r6
    sdiv    r4, r1, r10
    b       .Lsmall_span

.Lsmall_next:
    ldm     sp, {r0-r11}
    ldrd    r12, lr, [sp, #SMALL_END]
    add     r8, r8, #1
    cmp     r8, r12
    beq     .Lover
    add     r1, r1, r5
    add     r2, r2, r6
    add     r7, r7, r4
    add     r9, r9, lr
    stm     sp, {r0-r9}
    b       .Lsmall_row

.Lsmall_not:
    ldm     sp, {r0-r3, r6-r9}
    movw    r11, #32767
    b       .Ltwo_chains

    /* The right edge is not right of the left one. */
.Lexchanged_row:
    mov     r2, r8
    rsb     r0, r0, #0
    b       .Lspan

.Lno_pixel:
    add     lr, lr, #TEXEL_OUTLINE_CELLS
.Lpixels_done:                      /* lr: the outline's cells */
    ldm     sp, {r4-r11}
    ldr     r12, [lr, #OF(ROWS)]
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
    beq     .Lno_pixel
    add     lr, lr, #TEXEL_OUTLINE_ALONG
    ldm     lr!, {r7-r10}           /* what a pixel adds */
    ldr     r11, [lr]               /* cells of the band */
    add     r11, r11, r2, lsl #1
.Lpixels:                           /* r11: the first cell */
    mla     r3, r7, r2, r3
    mla     r4, r8, r2, r4
    mla     r5, r9, r2, r5
    mla     r6, r10, r2, r6
    add     r12, r11, r0, lsl #1
    ldr     r1, [lr, #OF(KIND)]
.Lkind:
    tbh     [pc, r1, lsl #1]
.Lkinds:
    .irp    number, 0, 1, 2, 3, _bent, _bent, _bent, _bent, 0, 1, 10, 11, _bent, _bent, _bent, _bent
    .short  (.Lkind\number - .Lkinds) / 2
    .endr

    /* Codes have a border: those below it, of pixels beyond it, are doubled. Where the row crosses it, r2 pixels are
     * drawn first, and then the rest, likewise. r0: pixels, r3-r12: as the loops have them. */
.Lkind_bent:
    ldr     r1, [lr, #OF(BORDER)]
    subs    r2, r3, r1
    itee    hs
    rsbhs   r1, r7, #0
    mvnlo   r2, r2
    movlo   r1, r7
    cmp     r1, #0
    ble     .Lone_side
    udiv    r2, r2, r1
    add     r2, r2, #1
    cmp     r2, r0
    bhs     .Lone_side
    str     r12, [lr, #OF(REST_END)]
    add     r12, r11, r2, lsl #1
    mla     r2, r7, r2, r3
    ldr     r1, [lr, #OF(RESUME)]
    strd    r1, r2, [lr, #OF(REST_RESUME)]
    adr     r1, .Lrest
    adds    r1, r1, #1              /* Thumb */
    str     r1, [lr, #OF(RESUME)]
.Lone_side:
    ldr     r1, [lr, #OF(BORDER)]
    subs    r2, r3, r1
    itt     lo
    addlo   r3, r3, r2
    lsllo   r7, r7, #1
    ldr     r1, [lr, #OF(KIND)]
    bic     r1, r1, #4
    b       .Lkind

.Lrest:
    ldrd    r1, r3, [lr, #OF(REST_RESUME)] /* and the code */
    str     r1, [lr, #OF(RESUME)]
    ldr     r7, [lr, #OF(ALONG)]
    ldr     r12, [lr, #OF(REST_END)]
    sub     r0, r12, r11
    lsr     r0, r0, #1
    b       .Lkind_bent

.Lkind0:
    paint_row 0, 0
.Lkind1:
    paint_row 1, 1
.Lkind2:
    paint_lit_row 2, 0
.Lkind3:
    paint_lit_row 3, 1
.Lkind10:
    paint_black_row 10, 0
.Lkind11:
    paint_black_row 11, 1

    .size fxl_draw_texel_outline, . - fxl_draw_texel_outline

#endif
