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

/* For kernels that draw only where rows are cleared. \outline: its cells are at an offset;
 * \first: the first row, \end: the last row plus 1; the others are overwritten, \at by the cells. */
    .macro test_clear cells, outline=r3, first=r6, end=r7, at=r4, from=r5, to=r8
    ldr     \at, [\outline, #\cells]
    ldrsh   \from, [\at, #DEPTH_HEAD_CLEAR_FROM - DEPTH_HEAD_SIZE]
    ldrsh   \to, [\at, #DEPTH_HEAD_CLEAR_TO - DEPTH_HEAD_SIZE]
    cmp     \first, \from
    it      ge
    cmpge   \to, \end
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

/* --- small triangles -----------------------------------------------------------
 *
 * Points are taken relative to the first centre of the box, in 16.16: below 9 pixels, 2^20, so
 * a product is below 2^40. With them the edge function from a to b is a.x b.y - a.y b.x, above 0
 * inside. As lib/raster/scan.h says, a unit is taken off that of a right edge, 16 bits are dropped
 * by rounding down, and the function then changes by dx from row to row, and by -dy from column to
 * column. Exact. */

/* The edge function of the edge from a to b in \low, and -dy. b.x is \bx, and so on; those of y and
 * \ax are negated. \negated may be \ax. */
    .macro edge_function low, high, ax, ay, bx, by, negated
    smull   \low, \high, \bx, \ay
    smlal   \low, \high, \ax, \by
    sub     \negated, \by, \ay
    adds    \low, \low, \negated, asr #31
    adc     \high, \high, \negated, asr #31
    lsr     \low, \low, #16
    orr     \low, \low, \high, lsl #16
    .endm

/* At .Lsmall of outline_armv7m.h: whether the box of a triangle lies in the band, and has so many columns and
 * centres at most; else on to .Ltwo_chains. lr: the row in the band, r10: the first column, r12: columns, r5: cells a row. */
    .macro small_box columns, centres
    ldrh    r12, [r2, #BAND_FIRST_ROW]
    ldrh    lr, [r2, #BAND_ROWS]
    ldr     r4, [r0]
    ldr     r5, [r0, #8]
    add     lr, lr, r12
    cmp     r6, r12
    blt     .Ltwo_chains
    cmp     r7, lr
    bgt     .Ltwo_chains
    sub     lr, r6, r12
    cmp     r4, r5                  /* r10: the least x, r12: the greatest */
    ittee   lt
    movlt   r10, r4
    movlt   r12, r5
    movge   r10, r5
    movge   r12, r4
    ldr     r4, [r0, #16]
    cmp     r4, r10
    it      lt
    movlt   r10, r4
    cmp     r4, r12
    it      gt
    movgt   r12, r4
    add     r10, r10, r11
    add     r12, r12, r11
    asr     r10, r10, #16           /* the first column */
    rsb     r12, r10, r12, asr #16  /* columns */
    mul     r4, r8, r12
    sub     r4, r4, #1              /* 2^32 - 1: no centre */
    cmp     r12, #\columns
    it      ls
    cmpls   r4, #\centres - 1
    bhi     .Ltwo_chains
    ldrh    r5, [r2, #BAND_WIDTH]
    .endm

/* Points r4-r9, x and y of each, relative to the centre r10, r11; y is negated. */
    .macro relative_points
    sub     r4, r4, r10
    sub     r6, r6, r10
    sub     r8, r8, r10
    sub     r5, r11, r5
    sub     r7, r11, r7
    sub     r9, r11, r9
    .endm

/* Of the edges of such points: the functions at the centre, r1, r2, r7, their changes
 * from column to column, r10, r11, r0, and from row to row, r5, r6, r4. Goes to \turned where the
 * triangle does not go clockwise by more than rounding takes away. */
    .macro functions_of_points turned=.Lsmall_not
    rsb     r10, r4, #0
    rsb     r11, r6, #0
    rsb     r0, r8, #0
    edge_function r1, r2, r10, r5, r6, r7, r10
    edge_function r2, r12, r11, r7, r8, r9, r11
    edge_function r7, r12, r0, r9, r4, r5, r0
    adds    r5, r1, r2              /* twice the area, or somewhat less */
    adds    r5, r5, r7
    bmi     \turned
    sub     r5, r6, r4              /* dx of each */
    sub     r6, r8, r6
    sub     r4, r4, r8
    .endm

/* The same of the points at r0, r10, r11: the first centre. */
    .macro edge_functions
    ldm     r0, {r4-r9}
    relative_points
    functions_of_points
    .endm
