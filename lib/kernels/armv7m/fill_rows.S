/* SPDX-License-Identifier: MIT */
/* fxl_fill_rows for ARMv7-M and ARMv8-M Mainline: UMULL and UDIV not needed,
 * STRD, STM, TBB and 14 registers are. See lib/src/fill_rows.h.
 *
 * Both edges are kept as addresses, x added to where the row begins and stride
 * to the step: so a row's span is from one address to the other, and a step is
 * two additions an edge. Every store is aligned. */

    .syntax unified
    .thumb

/* fxl_trapezoid; the header holds them against the structure. */
#define FIRST_ROW   0
#define END_ROW     2
#define EDGES       4

left        .req r0     /* address of the left edge's pixel */
right       .req r1     /* of the right edge's: one past the span */
pixel       .req r2     /* where to store next */
colour      .req r3     /* four times */
bytes       .req r4     /* still to be stored */
left_fraction       .req r5
right_fraction      .req r6
left_step           .req r7     /* stride added */
right_step          .req r8
left_step_fraction  .req r9
right_step_fraction .req r10
rows        .req r11    /* to be done */
spare       .req r12

    .section .text.fxl_fill_rows, "ax", %progbits
    .global fxl_fill_rows
    .type fxl_fill_rows, %function
    .thumb_func

/* r0: where the first row begins, r1: stride, r2: trapezoid, r3: colour */
fxl_fill_rows:
    push    {r4-r11, lr}
    ldrsh   rows, [r2, #END_ROW]
    ldrsh   spare, [r2, #FIRST_ROW]
    sub     rows, rows, spare
    orr     colour, colour, colour, lsl #8
    orr     colour, colour, colour, lsl #16
    mov     spare, r0
    mov     lr, r1
    ldrd    left, left_fraction, [r2, #EDGES]
    ldrd    left_step, left_step_fraction, [r2, #EDGES + 8]
    ldrd    right, right_fraction, [r2, #EDGES + 16]
    ldrd    right_step, right_step_fraction, [r2, #EDGES + 24]
    add     left, left, spare
    add     right, right, spare
    add     left_step, left_step, lr
    add     right_step, right_step, lr

.Lrow:
    sub     bytes, right, left
    cmp     bytes, #8
    blt     .Lshort

    /* To a multiple of four: 0 to 3 of the 8 bytes at least. */
    mov     pixel, left
    and     spare, left, #3
    tbb     [pc, spare]
.Lhead:
    .byte   (.Lhead0 - .Lhead) / 2, (.Lhead1 - .Lhead) / 2
    .byte   (.Lhead2 - .Lhead) / 2, (.Lhead3 - .Lhead) / 2
.Lhead3:
    strb    colour, [pixel], #1
    b       .Lhead0
.Lhead1:
    strb    colour, [pixel], #1
.Lhead2:
    strh    colour, [pixel], #2
.Lhead0:
    sub     bytes, right, pixel
    subs    bytes, #16
    blo     .Ltail
    cmp     bytes, #96
    bhs     .Llong
.Lblock:
    strd    colour, colour, [pixel], #8
    strd    colour, colour, [pixel], #8
    subs    bytes, #16
    bhs     .Lblock

    /* The last 0 to 15 bytes. */
.Ltail:
    adds    bytes, #16
    tbb     [pc, bytes]
.Lends:
    .byte   (.Lnext - .Lends) / 2, (.Lend1 - .Lends) / 2
    .byte   (.Lend2 - .Lends) / 2, (.Lend3 - .Lends) / 2
    .byte   (.Lend4 - .Lends) / 2, (.Lend5 - .Lends) / 2
    .byte   (.Lend6 - .Lends) / 2, (.Lend7 - .Lends) / 2
    .byte   (.Lend8 - .Lends) / 2, (.Lend9 - .Lends) / 2
    .byte   (.Lend10 - .Lends) / 2, (.Lend11 - .Lends) / 2
    .byte   (.Lend12 - .Lends) / 2, (.Lend13 - .Lends) / 2
    .byte   (.Lend14 - .Lends) / 2, (.Lend15 - .Lends) / 2

/* count bytes from an aligned pixel on, in as few stores as there can be. */
    .macro end_of_row count
    .set    .Ldone, 0
    .if     \count & 8
    strd    colour, colour, [pixel]
    .set    .Ldone, 8
    .endif
    .if     \count & 4
    str     colour, [pixel, #.Ldone]
    .set    .Ldone, .Ldone + 4
    .endif
    .if     \count & 2
    strh    colour, [pixel, #.Ldone]
    .set    .Ldone, .Ldone + 2
    .endif
    .if     \count & 1
    strb    colour, [pixel, #.Ldone]
    .endif
    b       .Lnext
    .endm

.Lend1:     end_of_row 1
.Lend2:     end_of_row 2
.Lend3:     end_of_row 3
.Lend4:     end_of_row 4
.Lend5:     end_of_row 5
.Lend6:     end_of_row 6
.Lend7:     end_of_row 7
.Lend8:     end_of_row 8
.Lend9:     end_of_row 9
.Lend10:    end_of_row 10
.Lend11:    end_of_row 11
.Lend12:    end_of_row 12
.Lend13:    end_of_row 13
.Lend14:    end_of_row 14
.Lend15:    end_of_row 15

    /* 112 bytes and more: eight registers at a time. */
.Llong:
    push    {r0, r5-r11}
    mov     r5, colour
    mov     r6, colour
    mov     r7, colour
    mov     r8, colour
    mov     r9, colour
    mov     r10, colour
    mov     r11, colour
    subs    bytes, #64 - 16
.Llong_block:
    stm     pixel!, {r3, r5-r11}
    stm     pixel!, {r3, r5-r11}
    subs    bytes, #64
    bhs     .Llong_block
    pop     {r0, r5-r11}
    adds    bytes, #64 - 16
    bpl     .Lblock
    b       .Ltail

    /* Fewer than 8 bytes, none, or the edges have changed sides. */
.Lshort:
    cmp     bytes, #0
    blt     .Lcrossed
    tbb     [pc, bytes]
.Lshorts:
    .byte   (.Lnext - .Lshorts) / 2, (.Lshort1 - .Lshorts) / 2
    .byte   (.Lshort2 - .Lshorts) / 2, (.Lshort3 - .Lshorts) / 2
    .byte   (.Lshort4 - .Lshorts) / 2, (.Lshort5 - .Lshorts) / 2
    .byte   (.Lshort6 - .Lshorts) / 2, (.Lshort7 - .Lshorts) / 2
.Lshort7:
    strb    colour, [left, #6]
.Lshort6:
    strb    colour, [left, #5]
.Lshort5:
    strb    colour, [left, #4]
.Lshort4:
    strb    colour, [left, #3]
.Lshort3:
    strb    colour, [left, #2]
.Lshort2:
    strb    colour, [left, #1]
.Lshort1:
    strb    colour, [left]

.Lnext:
    adds    left_fraction, left_fraction, left_step_fraction
    adc     left, left, left_step
    adds    right_fraction, right_fraction, right_step_fraction
    adc     right, right, right_step
    subs    rows, rows, #1
    bne     .Lrow
    pop     {r4-r11, pc}

    /* They change places; a second time they cannot cross. */
.Lcrossed:
    mov     spare, left
    mov     left, right
    mov     right, spare
    mov     spare, left_fraction
    mov     left_fraction, right_fraction
    mov     right_fraction, spare
    mov     spare, left_step
    mov     left_step, right_step
    mov     right_step, spare
    mov     spare, left_step_fraction
    mov     left_step_fraction, right_step_fraction
    mov     right_step_fraction, spare
    b       .Lrow

    .size fxl_fill_rows, . - fxl_fill_rows
