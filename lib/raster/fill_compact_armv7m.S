/* SPDX-License-Identifier: MIT */
/* The same as fill_rows_armv7m.S in a quarter of the bytes, for a library that is compiled for size
 * (-Os). It writes the same bytes, and takes more instructions for a row: there is one text for
 * rows of all lengths. */
#include "../math/family.h"
#include "../math/offsets.h"
#include "draw_frame_armv7m.h"

#if FXL_KERNELS_ARMV7M && FXL_FILLS_COMPACT
#include "fill_entry_armv7m.h"

    b.w     FILL_ROWS
    .size FILL_TRAPEZOID, . - FILL_TRAPEZOID

    .section .text.FILL_ROWS, "ax", %progbits
#ifndef FXL_PIXELS_OF_16_BITS
    .global fxl_fill_rows
#endif
    .hidden FILL_ROWS
    .type FILL_ROWS, %function
    .thumb_func

/* Fills rows as fxl_fill_rows of fill_rows_armv7m.S does. */
FILL_ROWS:
.Lrow:
    subs    bytes, right, left
    blt     .Lcrossed
#ifdef FXL_PIXELS_OF_16_BITS
    lsls    bytes, bytes, #1        /* bytes, on such a row alone */
    lsls    pixel, left, #1
    cmp     bytes, #8
    blo     .Lshort
    tst     pixel, #2
    itt     ne
    strhne  colour, [pixel], #2
    subne   bytes, bytes, #2
#else
    mov     pixel, left
    cmp     bytes, #8
    blo     .Lshort
    tst     pixel, #1
    it      ne
    strbne  colour, [pixel], #1
    tst     pixel, #2
    it      ne
    strhne  colour, [pixel], #2
    sub     bytes, right, pixel
#endif
    subs    bytes, bytes, #16
    blo     .Lend
.Lblock:
    strd    colour, colour, [pixel], #8
    strd    colour, colour, [pixel], #8
    subs    bytes, bytes, #16
    bhs     .Lblock
    /* Bits 3 to 0 of the rest, one after the other in the carry and sign flags. */
.Lend:
    lsls    spare, bytes, #29
    it      cs
    strdcs  colour, colour, [pixel], #8
    it      mi
    strmi   colour, [pixel], #4
    lsls    spare, bytes, #31
    it      cs
    strhcs  colour, [pixel], #2
#ifndef FXL_PIXELS_OF_16_BITS
    it      mi
    strbmi  colour, [pixel]
#endif
.Lnext:
    step_edges
    bcs     .Lrow
    b.w     DRAW_ROWS_BELOW

.Lshort:
#ifdef FXL_PIXELS_OF_16_BITS
    subs    bytes, bytes, #2
    bmi     .Lnext
    strh    colour, [pixel, bytes]
#else
    subs    bytes, bytes, #1
    bmi     .Lnext
    strb    colour, [left, bytes]
#endif
    b       .Lshort

.Lcrossed:
    exchange_edges
    b       .Lrow

    .size FILL_ROWS, . - FILL_ROWS

#endif
