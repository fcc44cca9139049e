/* SPDX-License-Identifier: MIT */
/* What the kernels of outlines in a depth buffer give to lib/raster/outline_armv7m.h: an edge is the
 * number of a cell of the band. FRAME_OUTLINE holds a fxl_depth_outline, or what begins with one. */
#define FRAME_OUTLINE FRAME_COLOUR

#define NO_ROW DEPTH_NO_ROW

    .macro enter_outline
    movs    r5, r1
    ldrh    r4, [r2, #BAND_WIDTH]
    .endm

    .macro find_base
    ldrh    r7, [r2, #BAND_WIDTH]
    mul     r6, r12, r7
    rsb     r6, r6, #1
    .endm

    .macro leave_other
    movs    r0, #DEPTH_NOT_DRAWN
    add     sp, sp, #FRAME_SIZE
    pop     {r4-r11, pc}
    .endm

    .macro begin_rows_below
.Lrows_below:
    .endm

    .macro step_edges
    adds    r5, r5, r7
    adc     r4, r4, r6
    adds    r9, r9, r11
    adc     r8, r8, r10
    .endm
