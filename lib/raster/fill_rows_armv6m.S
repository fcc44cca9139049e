/* SPDX-License-Identifier: MIT */
/* fxl_fill_trapezoid for Armv6-M. lib/raster/fill.h states what it requires and
 * does; it writes the same bytes as lib/raster/fill.c.
 *
 * Both edges are kept as addresses: the row's address is added to x, and the stride is added
 * to the step. So a row's span goes from one address to the other, and a step is two
 * additions an edge. The lower registers have the values that change; the upper registers
 * have the steps. Every store is aligned. */
#include "../math/family.h"
#include "../math/offsets.h"
#include "../math/registers_armv6m.h"

#if FXL_KERNELS_ARMV6M

/* fill_rows_rgb565_armv6m.S has this text with another name, and FXL_PIXELS_OF_16_BITS. Edges are
 * halves of addresses there, so a step of an edge is a pixel, too. */
#ifdef FXL_PIXELS_OF_16_BITS
#define SHORT_ROW 16 /* bytes */
#else
#define FILL_TRAPEZOID fxl_fill_trapezoid
#define SHORT_ROW      8
    .global fxl_fill_trapezoid
#endif

    .syntax unified
    .thumb

left        .req r0     /* address of the left edge's pixel */
right       .req r1     /* address of the right edge's pixel: one past the span */
left_fraction       .req r2
right_fraction      .req r3
pixel       .req r4     /* the next address to store to */
bytes       .req r5     /* bytes still to be stored */
colour      .req r6     /* in each of four bytes */
spare       .req r7
left_step           .req r8     /* with the stride */
left_step_fraction  .req r9
right_step          .req r10    /* with the stride */
right_step_fraction .req r11
rows        .req r12    /* rows still to be filled */

/* Stores bytes from left on until pixel is a multiple of four; then bytes is the rest. */
    .macro align_pixel
#ifdef FXL_PIXELS_OF_16_BITS
    lsls    pixel, left, #1
    lsrs    spare, left, #1
    bcc     2f
    strh    colour, [pixel]
    adds    pixel, #2
    subs    bytes, #2
2:
#else
    movs    pixel, left
    lsrs    spare, pixel, #1
    bcc     1f
    strb    colour, [pixel]
    adds    pixel, #1
1:
    lsrs    spare, pixel, #2
    bcc     2f
    strh    colour, [pixel]
    adds    pixel, #2
2:
    subs    bytes, right, pixel
#endif
    .endm

    .section .text.FILL_TRAPEZOID, "ax", %progbits
    .type FILL_TRAPEZOID, %function
    .thumb_func

/* r0: band, r1: trapezoid, r2: colour */
FILL_TRAPEZOID:
    save_registers
    movs    r4, #TRAPEZOID_END_ROW
    ldrsh   r3, [r1, r4]
    movs    r4, #TRAPEZOID_FIRST_ROW
    ldrsh   r4, [r1, r4]
    subs    r3, r3, r4
    mov     rows, r3
    ldrh    r5, [r0, #BAND_FIRST_ROW]
    subs    r4, r4, r5
    ldrh    r5, [r0, #BAND_STRIDE]
    muls    r4, r5
    ldr     r6, [r0, #BAND_PIXELS]
#ifdef FXL_PIXELS_OF_16_BITS
    lsrs    r6, r6, #1
    adds    r4, r4, r6          /* half of the address of the first row */
#else
    adds    r4, r4, r6          /* address of the first row */
    lsls    r6, r2, #8
    orrs    r2, r6
#endif
    lsls    r6, r2, #16
    orrs    r2, r6
    mov     lr, r2
    adds    r1, #TRAPEZOID_EDGES
    ldm     r1!, {r0, r2, r6, r7}
    adds    left, left, r4
    adds    r6, r6, r5
    mov     left_step, r6
    mov     left_step_fraction, r7
    ldr     r6, [r1, #EDGE_STEP]
    ldr     r7, [r1, #EDGE_STEP_FRACTION]
    adds    r6, r6, r5
    mov     right_step, r6
    mov     right_step_fraction, r7
    ldr     right_fraction, [r1, #EDGE_FRACTION]
    ldr     right, [r1]
    adds    right, right, r4
    mov     colour, lr

.Lrow:
    subs    bytes, right, left
#ifdef FXL_PIXELS_OF_16_BITS
    lsls    bytes, bytes, #1
#endif
    cmp     bytes, #SHORT_ROW
    blo     .Lshort
    cmp     bytes, #64
    bhs     .Llong
    align_pixel
    /* The tail of 0 to 3 bytes, from the right end back; then all words. */
.Lrest:
#ifndef FXL_PIXELS_OF_16_BITS
    lsrs    spare, bytes, #1
    bcc     1f
    subs    bytes, #1
    strb    colour, [pixel, bytes]
1:
#endif
    lsrs    spare, bytes, #2
    bcc     2f
    subs    bytes, #2
    strh    colour, [pixel, bytes]
2:
    lsrs    bytes, bytes, #1
    negs    bytes, bytes
    adds    bytes, #2 * 15
    add     pc, bytes
    nop
    .irp    word, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0
    str     colour, [pixel, #4 * \word]
    .endr

.Lnext:
    mov     spare, left_step_fraction
    adds    left_fraction, left_fraction, spare
    mov     spare, left_step
    adcs    left, spare
    mov     spare, right_step_fraction
    adds    right_fraction, right_fraction, spare
    mov     spare, right_step
    adcs    right, spare
    mov     spare, rows
    subs    spare, #1
    mov     rows, spare
    bne     .Lrow
    restore_and_return

    /* Fewer than 8 pixels, perhaps none. */
.Lshort:
#ifdef FXL_PIXELS_OF_16_BITS
    lsls    pixel, left, #1
#else
    lsls    bytes, bytes, #1
#endif
    negs    bytes, bytes
    adds    bytes, #2 * 7
    add     pc, bytes
    nop
    .irp    place, 6, 5, 4, 3, 2, 1, 0
#ifdef FXL_PIXELS_OF_16_BITS
    strh    colour, [pixel, #2 * \place]
#else
    strb    colour, [left, #\place]
#endif
    .endr
    b       .Lnext

    /* 64 bytes and more: four registers at a time. */
.Llong:
    cmp     bytes, #0
    blt     .Lcrossed
    align_pixel
    subs    bytes, #64
    blo     .Llong_end
    push    {r0-r3}
    movs    r0, colour
    movs    r1, colour
    movs    r2, colour
    movs    r3, colour
.Llong_block:
    stm     pixel!, {r0-r3}
    stm     pixel!, {r0-r3}
    stm     pixel!, {r0-r3}
    stm     pixel!, {r0-r3}
    subs    bytes, #64
    bhs     .Llong_block
    pop     {r0-r3}
.Llong_end:
    adds    bytes, #64
    b       .Lrest

    /* The edges crossed: exchange them. Straight edges do not cross a second time. */
.Lcrossed:
    movs    spare, left
    movs    left, right
    movs    right, spare
    movs    spare, left_fraction
    movs    left_fraction, right_fraction
    movs    right_fraction, spare
    mov     spare, left_step
    mov     left_step, right_step
    mov     right_step, spare
    mov     spare, left_step_fraction
    mov     left_step_fraction, right_step_fraction
    mov     right_step_fraction, spare
    b       .Lrow

    .size FILL_TRAPEZOID, . - FILL_TRAPEZOID

#endif
