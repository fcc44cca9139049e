/* SPDX-License-Identifier: MIT */
/* What the kernels of outlines in a depth buffer give to lib/raster/outline_armv7m.h: an edge is the
 * number of a cell of the band. FRAME_OUTLINE holds a fxl_depth_outline, or what begins with one. And
 * how they find a value's octave. */
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

/* For kernels that draw only where rows are cleared. r3: the outline, whose cells are at an offset;
 * r6: the first row, r7: the last row plus 1; r4, r5 and r8 are overwritten. */
    .macro test_clear cells
    ldr     r4, [r3, #\cells]
    ldrsh   r5, [r4, #DEPTH_HEAD_CLEAR_FROM - DEPTH_HEAD_SIZE]
    ldrsh   r8, [r4, #DEPTH_HEAD_CLEAR_TO - DEPTH_HEAD_SIZE]
    cmp     r6, r5
    it      ge
    cmpge   r8, r7
    blt     .Lnot_clear
    .endm

    .macro return_not_clear
.Lnot_clear:
    movs    r0, #DEPTH_NOT_CLEAR
    add     sp, sp, #FRAME_SIZE
    pop     {r4-r11, pc}
    .endm

/* Input: zeros: the leading zeros of a value's upper word; r3: the outline. Results: \bias, \drop. Goes
 * to \nearer or \farther if no octave has the value. \count and \mantissa are overwritten. */
    .macro find_octave zeros, bias, count, drop, mantissa, nearer, farther
    cmp     \zeros, #0              /* below 0 */
    beq     \farther
    ldrd    \bias, \count, [r3, #DEPTH_OUTLINE_ONE]
    rsb     \drop, \zeros, #64      /* the value's length in bits */
    subs    \bias, \bias, \drop     /* the octave's number */
    bmi     \nearer
    cmp     \bias, \count
    bge     \farther
    ldr     \mantissa, [r3, #DEPTH_OUTLINE_MANTISSA]
    sub     \count, \count, \bias
    sub     \count, \count, #2
    rsb     \drop, \zeros, #47
    sub     \drop, \drop, \mantissa
    add     \mantissa, \mantissa, #16
    lsl     \bias, \count, \mantissa
    add     \bias, \bias, #65536
    .endm

/* Results: \low, \high: the 32 lowest bits of (\high:\low) >> \drop, in \low. drop: 1 to 34. */
    .macro shift_by drop, low, high, spare
    rsbs    \spare, \drop, #32
    itee    pl
    lslpl   \high, \high, \spare
    rsbmi   \spare, \spare, #0
    asrmi   \high, \high, \spare
    lsr     \low, \low, \drop
    add     \low, \low, \high
    .endm
