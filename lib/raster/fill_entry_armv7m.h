/* SPDX-License-Identifier: MIT */
/* What the two texts of fxl_fill_trapezoid and fxl_fill_rows for Armv7-M share: the registers, the
 * entry, and the steps from row to row. Included once by each, where its code begins. Each text is
 * assembled once more for RGB565, with FXL_PIXELS_OF_16_BITS: fill_rows_rgb565_armv7m.S. */

#ifdef FXL_PIXELS_OF_16_BITS
#define FILL_TRAPEZOID  fxl_fill_trapezoid_rgb565
#define FILL_ROWS       fxl_fill_rows_rgb565
#define DRAW_ROWS_BELOW fxl_draw_rows_below_rgb565
#else
#define FILL_TRAPEZOID  fxl_fill_trapezoid
#define FILL_ROWS       fxl_fill_rows
#define DRAW_ROWS_BELOW fxl_draw_rows_below
#endif

/* clang-format off */

    .syntax unified
    .thumb

pixel       .req r0     /* the next address to store to, aligned to four */
bytes       .req r1     /* bytes still to be stored; of 16 bits: pixels */
colour      .req r2     /* in each of four bytes, or in both halves */
spare       .req r3
left        .req r4     /* address of the left edge's pixel; of 16 bits: half of the address */
left_fraction       .req r5
left_step           .req r6     /* with the stride */
left_step_fraction  .req r7
right       .req r8     /* address of the right edge's pixel: one past the span */
right_fraction      .req r9
right_step          .req r10    /* with the stride */
right_step_fraction .req r11
rows        .req r12    /* rows still to be filled, less 1 */

/* To the row below. The carry is set while there is one. */
    .macro step_edges
    adds    left_fraction, left_fraction, left_step_fraction
    adc     left, left, left_step
    adds    right_fraction, right_fraction, right_step_fraction
    adc     right, right, right_step
    subs    rows, rows, #1
    .endm

/* The edges crossed: exchange them. Edges that are crossed on the first row may be exchanged
 * once more. */
    .macro exchange_edges
    ldr     r0, [sp, #FRAME_UNTIL]
    eor     r0, r0, #FRAME_EXCHANGED
    str     r0, [sp, #FRAME_UNTIL]
    stm     sp, {r4-r11}
    mov     r4, r8
    mov     r5, r9
    mov     r6, r10
    mov     r7, r11
    ldm     sp, {r8-r11}
    .endm

    .section .text.FILL_TRAPEZOID, "ax", %progbits
    .global FILL_TRAPEZOID
    .type FILL_TRAPEZOID, %function
    .thumb_func

/* r0: band, r1: trapezoid, r2: colour */
FILL_TRAPEZOID:
    push    {r4-r11, lr}
    sub     sp, sp, #FRAME_SIZE
    ldrsh   rows, [r1, #TRAPEZOID_END_ROW]
    ldrsh   r4, [r1], #TRAPEZOID_EDGES
    ldrh    r5, [r0, #BAND_FIRST_ROW]
    ldrh    lr, [r0, #BAND_STRIDE]
    ldr     r3, [r0, #BAND_PIXELS]
    sub     rows, rows, r4
    sub     rows, rows, #1
    subs    r4, r4, r5
#ifdef FXL_PIXELS_OF_16_BITS
    lsrs    r3, r3, #1
#else
    orr     colour, colour, colour, lsl #8
#endif
    mla     r0, r4, lr, r3
    orr     colour, colour, colour, lsl #16
    ldm     r1, {r4-r11}
    add     left, left, r0
    add     right, right, r0
    add     left_step, left_step, lr
    add     right_step, right_step, lr
    str     lr, [sp, #FRAME_STRIDE]
    strd    rows, rows, [sp, #FRAME_LAST] /* equal, so no other trapezoid follows */
    /* clang-format on */
