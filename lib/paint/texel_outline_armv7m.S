/* SPDX-License-Identifier: MIT */
/* fxl_draw_texel_outline for Armv7-M and Armv8-M Mainline. lib/paint/smooth_outline.h states what it
 * requires and does; lib/paint/texel_outline.c paints the same pixels, by paint_any. A triangle takes 101
 * instructions, and a row 46, before the pixels; a visible texel of 16 bits 20, with light 37, and 30 if the dark
 * colour is 0; one of the palette 21, 38 and 32; a hidden one 9 or 10. */
#include "../math/family.h"

#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT

#include "../math/offsets.h"
#include "black_texels_armv7m.h"
#include "cell_edges_armv7m.h"

/* What pixels depend on, from the member `cells` on. */
#define OF(member) (TEXEL_OUTLINE_##member - TEXEL_OUTLINE_CELLS)

    .syntax unified
    .thumb

/* The stack frame. An outline is drawn as triangles from its first point on. The points of each are taken from the
 * highest one, T, on: T, N, P. r0-r11, from 0 on, are the changes of the edge functions from column to column and row
 * to row, their values in column FRAME_COLUMN - 1 of a row, the outline, the row and its first cell:
 *
 *         column  row  value
 *   T-N   r10     r5   r8
 *   N-P   r11     r6   r2
 *   P-T   r0      r4   r7
 */
#define FRAME_ROW      4
#define FRAME_OF       12
#define FRAME_FIRST    48 /* of an outline: its first point, and the second one of the triangle */
#define FRAME_POINT    52
#define FRAME_BAND     56
#define FRAME_ANSWER   60
#define FRAME_END      64 /* the last row plus 1; then bytes of a row of cells */
#define FRAME_COLUMN   72
#define FRAME_RESUME   76 /* what follows the pixels */
#define FRAME_LEFT     80 /* triangles of an outline from this one on, negated; 0: it is one triangle */
#define FRAME_REST     84 /* the rest of a row: what follows it, and its code */
#define FRAME_REST_END 92
#define FRAME_LIT      92 /* what pixels need that black is mixed with, as in the outline but for the cells */
#define FRAME_SIZE     120

    .section .text.fxl_draw_texel_outline, "ax", %progbits
    .global fxl_draw_texel_outline
    .type fxl_draw_texel_outline, %function
    .thumb_func

/* The pixel is tested. r3: the code, r11: the cell, which becomes the next one. */
    .macro  test_pixel text
    lsr     r1, r3, #16
    ldrh    r0, [r11], #2
    cmp     r1, r0
    bls     .Lhidden\text
    strh    r1, [r11, #-2]
    .endm

/* r0: the place of the texel. r4, r5: u, v. Overwrites r1. */
    .macro  find_place of=lr, more=0
    ldrd    r0, r1, [\of, #OF(MASKS) + \more]
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
    ldrd    r2, r6, [lr, #OF(PIXELS)]
    .if     \wide == 0
    ldr     r10, [lr, #OF(PALETTE)]
    .endif
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
    ldr     pc, [sp, #FRAME_RESUME]
    .endm

/* The texel in r0 and the part of it in r1, of lit pixels; r6: light, r10: its step. */
    .macro  find_lit_texel text, wide, of=lr, more=0
    test_pixel \text
    find_place \of, \more
    .if     \wide
    ldrd    r1, r2, [\of, #OF(TEXELS) + \more]
    ldrh    r0, [r1, r0, lsl #1]
    umull   r2, r1, r6, r2
    .else
    ldr     r1, [\of, #OF(TEXELS) + \more]
    ldrb    r0, [r1, r0]
    ldrd    r1, r2, [\of, #OF(PART_OF_LEVEL) + \more]
    ldrh    r0, [r2, r0, lsl #1]
    umull   r2, r1, r6, r1
    .endif
    .endm

/* On to the next one. */
    .macro  next_lit_pixel text
    next_pixel \text
    add     r6, r6, r10
    cmp     r11, r12
    blo     .Lpixel\text
    ldr     pc, [sp, #FRAME_RESUME]
    .endm

/* The end of the cells, r12, is in the record too. */
    .macro  paint_lit_row text, wide
    str     r12, [lr, #OF(END)]
.Lpixel\text:
    find_lit_texel \text, \wide
    and     r2, r0, #0x7E0
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

/* The same where the dark colour is 0. */
    .macro  paint_black_row text, wide
    mov     lr, #HALF_STEPS
.Lpixel\text:
    find_lit_texel \text, \wide, sp, FRAME_LIT
    mix_black lr
    ldr     r1, [sp, #FRAME_LIT + OF(PIXELS)]
    strh    r0, [r11, r1]
    next_lit_pixel \text
    .endm

/* Triangles with so many rows at most. */
#define ROWS_MAX 64

/* r0: points, r1: count, r2: band, r3: outline; returns whether it was drawn. What is drawn twice
 * stays as it is, so an outline may be left to others after some of its triangles. */
fxl_draw_texel_outline:
    push    {r4-r11, lr}
    add     r12, r3, #TEXEL_OUTLINE_PIXELS
    ldm     r12, {r4-r9}
    push    {r4-r9}                 /* FRAME_LIT */
    sub     sp, sp, #FRAME_SIZE - 24
    adr     r4, .Lnext_row + 1
    subs    r5, r1, #3
    strd    r4, r5, [sp, #FRAME_RESUME]
    add     r1, r0, #8
    bne     .Lfan

    /* r0: the first point, r1: the second one of the triangle. */
.Ltriangle:
    ldrh    lr, [r2, #BAND_WIDTH]
    movw    r11, #32767
    ldrd    r4, r5, [r0]
    ldrd    r6, r7, [r1], #8
    ldrd    r8, r9, [r1]
    add     r1, lr, #1
    lsl     r1, r1, #16
    add     r10, r4, r11
    add     r12, r6, r11
    add     r0, r8, r11
    cmp     r10, r1
    itt     lo
    cmplo   r12, r1
    cmplo   r0, r1
    bhs     .Lnot_drawn             /* beside the band */
    cmp     r5, r7
    it      le
    cmple   r5, r9
    ble     .Lfrom_highest
    mov     r10, r4
    mov     r1, r5
    cmp     r7, r9
    bgt     .Lthird_is_highest
    mov     r4, r6
    mov     r5, r7
    mov     r6, r8
    mov     r7, r9
    mov     r8, r10
    mov     r9, r1
    b       .Lfrom_highest
.Lthird_is_highest:
    mov     r4, r8
    mov     r5, r9
    mov     r8, r6
    mov     r9, r7
    mov     r6, r10
    mov     r7, r1
.Lfrom_highest:
    mov     r12, r7                 /* the greatest y */
    cmp     r9, r7
    it      gt
    movgt   r12, r9
/* place fill-rule: small triangles with texels for Armv7-M */
    add     r10, r5, r11
    add     r12, r12, r11
    asr     r10, r10, #16           /* the first row */
    asr     r12, r12, #16
    sub     r0, r12, r10
    cmp     r0, #ROWS_MAX
    bhi     .Lnot_drawn
    ldr     r1, [r2, #BAND_FIRST_ROW]
    uxth    r0, r1
    add     r1, r0, r1, lsr #16
    cmp     r10, r0
    it      lt
    movlt   r10, r0
    cmp     r12, r1
    it      gt
    movgt   r12, r1
    cmp     r10, r12
    bge     .Ltriangle_done
    sub     r0, r10, r0
    mul     r0, r0, lr
    ldr     r1, [r3, #TEXEL_OUTLINE_CELLS]
    lsl     r11, lr, #1
    add     lr, r1, r0, lsl #1      /* the row's first cell */
    str     r10, [sp, #FRAME_ROW]
    strd    r12, r11, [sp, #FRAME_END]

    /* Points are taken relative to a centre of the first row that is 64 columns or more left of T and left of
     * the others: x is below 2^23, y below 2^22.1, so a function is below 2^30.1. */
    lsl     r11, r10, #16
    add     r11, r11, #32768
    sub     r10, r4, #64 << 16
    bfc     r10, #0, #16
    asr     r12, r10, #16
    add     r12, r12, #1
    str     r12, [sp, #FRAME_COLUMN]
    add     r10, r10, #32768
    relative_points
    cmp     r6, #128 << 16
    it      lo
    cmplo   r8, #128 << 16
    bhs     .Lnot_drawn
    functions_of_points
    cmp     r10, #0
    itt     ne
    cmpne   r11, #0
    cmpne   r0, #0
    beq     .Llevel_edge
.Lhave_edges:
    mov     r8, r1
    mov     r9, lr
    ldr     r1, [sp, #FRAME_ROW]
    stm     sp, {r0-r11}

    /* A row. T-N is a right edge, P-T a left one, and N-P the second of either kind. Where there is one of a kind, the
     * column is on its outer side in all rows: a left edge is below 0 there, a right one is not. With two of
     * a kind a row may be beyond one of them: then the column may be inside of a left one, which counts as 1; a
     * right one is further right than the other. */
.Lrow:
    cmp     r11, #0
    bgt     .Ltwo_left
    mvn     r5, r7
    udiv    r5, r5, r0              /* columns outside of left edges, less 1 */
    sdiv    r4, r8, r10             /* columns inside of right edges, less 1, negated */
    sdiv    r6, r2, r11
    cmp     r4, r6
    it      lt
    movlt   r4, r6
.Lspan:
    adds    r0, r4, r5
    bpl     .Lnext_row              /* no pixel; r0: pixels, negated */
    ldr     r2, [sp, #FRAME_COLUMN]
    add     r2, r2, r5              /* the first one's column */
    add     r11, r9, r2, lsl #1
    add     lr, r3, #TEXEL_OUTLINE_ALONG
    ldm     r3, {r3-r10}            /* code, u, v, light, and what a row adds */
    mla     r3, r7, r1, r3
    mla     r4, r8, r1, r4
    mla     r5, r9, r1, r5
    mla     r6, r10, r1, r6
    ldm     lr!, {r7-r10}           /* what a pixel adds */
    mla     r3, r7, r2, r3
    mla     r4, r8, r2, r4
    mla     r5, r9, r2, r5
    mla     r6, r10, r2, r6
    sub     r12, r11, r0, lsl #1
    ldr     r1, [lr, #OF(KIND)]
.Lkind:
    tbh     [pc, r1, lsl #1]
.Lkinds:
    .irp    number, 0, 1, 2, 3, _bent, _bent, _bent, _bent, 0, 1, 10, 11, _bent, _bent, _bent, _bent
    .short  (.Lkind\number - .Lkinds) / 2
    .endr

    /* Codes have a border: those below it, of pixels beyond it, are doubled. Where the row crosses it, r2 pixels are
     * drawn first, and then the rest, likewise. r0: pixels, negated, r3-r12: as the loops have them. */
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
    cmn     r2, r0
    bhs     .Lone_side
    str     r12, [sp, #FRAME_REST_END]
    add     r12, r11, r2, lsl #1
    mla     r2, r7, r2, r3
    ldr     r1, [sp, #FRAME_RESUME]
    strd    r1, r2, [sp, #FRAME_REST]
    adr     r1, .Lrest + 1
    str     r1, [sp, #FRAME_RESUME]
.Lone_side:
    ldr     r1, [lr, #OF(BORDER)]
    subs    r2, r3, r1
    itt     lo
    addlo   r3, r3, r2
    lsllo   r7, r7, #1
    ldr     r1, [lr, #OF(KIND)]
    bic     r1, r1, #4
    b       .Lkind

    .align  2
.Lrest:
    ldrd    r1, r3, [sp, #FRAME_REST] /* and the code */
    str     r1, [sp, #FRAME_RESUME]
    ldr     lr, [sp, #FRAME_OF]
    add     lr, lr, #TEXEL_OUTLINE_CELLS
    ldr     r7, [lr, #OF(ALONG)]
    ldr     r12, [sp, #FRAME_REST_END]
    sub     r0, r11, r12
    asr     r0, r0, #1
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

.Ltwo_left:
    mvn     r5, r7
    mvn     r6, r2
    bic     r5, r5, r5, asr #31
    bic     r6, r6, r6, asr #31
    udiv    r5, r5, r0
    udiv    r6, r6, r11
    cmp     r5, r6
    it      lo
    movlo   r5, r6
    sdiv    r4, r8, r10
    b       .Lspan

    .align  2
.Lnext_row:
    ldm     sp, {r0-r11}
    ldrd    r12, lr, [sp, #FRAME_END]
    adds    r1, r1, #1
    cmp     r1, r12
    beq     .Lrows_done
    add     r8, r8, r5
    add     r2, r2, r6
    add     r7, r7, r4
    add     r9, r9, lr
    stm     sp, {r0-r9}
    b       .Lrow

.Lrows_done:
    ldr     r1, [sp, #FRAME_LEFT]
    movs    r0, #1
    cbnz    r1, .Ldrawn
.Lreturn:
    add     sp, sp, #FRAME_SIZE
    pop     {r4-r11, pc}

.Ldrawn:
    str     r0, [sp, #FRAME_ANSWER]
.Ltriangle_done:
    ldr     r1, [sp, #FRAME_LEFT]
    movs    r0, #DEPTH_NO_ROW
    cmp     r1, #0
    beq     .Lreturn
    adds    r1, r1, #1
    str     r1, [sp, #FRAME_LEFT]
    ldr     r0, [sp, #FRAME_ANSWER]
    beq     .Lreturn
    ldrd    r0, r1, [sp, #FRAME_FIRST]
    ldr     r2, [sp, #FRAME_BAND]
    adds    r1, r1, #8
    str     r1, [sp, #FRAME_POINT]
    b       .Ltriangle

.Lsmall_not:                        /* it does not go clockwise, or has hardly any area */
.Lnot_drawn:
    movs    r0, #DEPTH_NOT_DRAWN
    b       .Lreturn

    /* An edge that crosses no centre's row leaves no column out. */
.Llevel_edge:
    cmp     r10, #0
    ittt    eq
    moveq   r1, #1 << 30
    mvneq   r10, #0
    moveq   r5, #0
    cmp     r11, #0
    ittt    eq
    moveq   r2, #1 << 30
    mvneq   r11, #0
    moveq   r6, #0
    cmp     r0, #0
    ittt    eq
    mvneq   r7, #0
    moveq   r0, #1
    moveq   r4, #0
    b       .Lhave_edges

    /* More than three points: a pixel is drawn if the outline winds around it, where all triangles go clockwise. */
.Lfan:
    mvn     r5, r5                  /* 2 - count */
    movs    r4, #DEPTH_NO_ROW
    strd    r2, r4, [sp, #FRAME_BAND]
    str     r5, [sp, #FRAME_LEFT]
    strd    r0, r1, [sp, #FRAME_FIRST]
    sub     r12, r1, r5, lsl #3     /* the last point */
.Lnext_corner:
    ldrd    r4, r5, [r0]
    ldrd    r6, r7, [r1], #8
    ldrd    r8, r9, [r1]
    sub     r6, r6, r4
    sub     r7, r7, r5
    sub     r8, r4, r8
    sub     r9, r9, r5
    smull   r10, r11, r6, r9
    smlal   r10, r11, r7, r8
    cmp     r11, #0
    blt     .Lnot_drawn
    cmp     r1, r12
    bne     .Lnext_corner
    add     r1, r0, #8
    b       .Ltriangle

    .size fxl_draw_texel_outline, . - fxl_draw_texel_outline

#endif
