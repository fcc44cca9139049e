/* SPDX-License-Identifier: MIT */
/* fxl_placement_rows for Armv7-M and Armv8-M Mainline: 71 instructions, and 115 as the compiler has it.
 * A sum is rounded by two: the shift that leaves its lower word's upper two bits puts bit 29, the
 * half, into the carry. */
#include "../math/family.h"

#if FXL_PLACEMENTS_IN_ASSEMBLY


    .syntax unified
    .thumb

row     .req r0     /* of the view */
of      .req r1
to      .req r2
x0      .req r3     /* a column of the orientation, and the next */
x1      .req r4
y0      .req r5
y1      .req r6
z0      .req r7
z1      .req r8
low     .req r12
high    .req lr

/* The next entry: the row's r9-r11 along a column. */
    .macro entry x, y, z
    smull   low, high, r9, \x
    smlal   low, high, r10, \y
    smlal   low, high, r11, \z
    lsrs    low, low, #30
    adc     low, low, high, lsl #2
    .endm

    .macro two_entries
    ldm     row!, {r9-r11}
    entry   x0, y0, z0
    str     low, [to], #4
    entry   x1, y1, z1
    str     low, [to], #8
    .endm

    .macro last_entry
    ldm     row!, {r9-r11}
    entry   x0, y0, z0
    str     low, [to], #12
    .endm

    .section .text.fxl_placement_rows, "ax", %progbits
    .global fxl_placement_rows
    .type fxl_placement_rows, %function
    .thumb_func

fxl_placement_rows:
    push    {r4-r11, lr}
    ldrd    x0, x1, [of]
    ldrd    y0, y1, [of, #12]
    ldrd    z0, z1, [of, #24]
    two_entries
    two_entries
    two_entries
    ldr     x0, [of, #8]
    ldr     y0, [of, #20]
    ldr     z0, [of, #32]
    sub     row, row, #36
    sub     to, to, #28             /* the last entry of the first row */
    last_entry
    last_entry
    last_entry
    pop     {r4-r11, pc}

    .size fxl_placement_rows, . - fxl_placement_rows

#endif
