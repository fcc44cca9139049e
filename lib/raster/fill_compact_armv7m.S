/* SPDX-License-Identifier: MIT */
/* The same as fill_rows_armv7m.S in a quarter of the bytes, for a library that is compiled for size
 * (-Os). It writes the same bytes, and takes more instructions for a row: there is one text for
 * rows of all lengths. */
#include "../math/family.h"
#include "../math/offsets.h"
#include "draw_frame_armv7m.h"

#if FXL_KERNELS_ARMV7M && FXL_FILLS_COMPACT
#include "fill_entry_armv7m.h"

    b.w     fxl_fill_rows
    .size fxl_fill_trapezoid, . - fxl_fill_trapezoid

    .section .text.fxl_fill_rows, "ax", %progbits
    .global fxl_fill_rows
    .hidden fxl_fill_rows
    .type fxl_fill_rows, %function
    .thumb_func

/* Fills rows as fxl_fill_rows of fill_rows_armv7m.S does. */
fxl_fill_rows:
.Lrow:
    subs    bytes, right, left
    blt     .Lcrossed
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
    it      mi
    strbmi  colour, [pixel]
.Lnext:
    step_edges
    bcs     .Lrow
    b.w     fxl_draw_rows_below

.Lshort:
    subs    bytes, bytes, #1
    bmi     .Lnext
    strb    colour, [left, bytes]
    b       .Lshort

.Lcrossed:
    exchange_edges
    b       .Lrow

    .size fxl_fill_rows, . - fxl_fill_rows

#endif
