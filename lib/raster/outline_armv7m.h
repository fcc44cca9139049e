/* SPDX-License-Identifier: MIT */
/* The text of the kernels for Armv7-M that draw a whole outline: the survey, and both chains with
 * their edges, trapezoid by trapezoid. The arithmetic, with its bounds, is that of
 * lib/raster/edge.h and lib/raster/edge_divide.h. A file includes this one right after the label of
 * its function, and defines before
 *
 *   NO_ROW            what is returned of an outline that reaches no row of the band; of others 1
 *   enter_outline     a macro: r0: the first point, r4: the width of the band, r5: the count of points;
 *                     r2: band, r3: as it was given. It may go to .Lcolumns, which goes to .Lother
 *   begin_filling     a macro: makes of r3, the fourth argument, what FRAME_COLOUR keeps; r2: band,
 *                     r6: the first row, r12: the band's first row; r4, r5, r8, r10, r11, lr are
 *                     free
 *   find_base         a macro: r7: the stride, r6: the place of column 0 of row 0 of the
 *                     screen, plus 1, in the units of the edges; r2: band, r12: its first row
 *   leave_other       a macro: returns where the outline is not scanned between two chains, which
 *                     survey in lib/raster/scan.c defines; r0: points, r1: their end
 *   begin_rows_below  a macro: the label .Lrows_below
 *   fill_rows         a macro: continues where the rows of a trapezoid are filled. r4-r11: the
 *                     edges, r12: rows less 1. That continues at .Lrows_below, where r4-r11 are
 *                     those of the row below
 *
 * and, if it draws small triangles itself, SMALL_ROWS: one of so many rows or fewer continues at its
 * .Lsmall, which may go to .Ltwo_chains with r0-r3, r6-r9 and r11 as they were. If its fill_rows lists the
 * rows, LISTS_ROWS: it continues at its .Lall_listed below the last one, and returns from there. */

#define ROW_OF_LEFT  (FRAME_LEFT + 4)
#define ROW_OF_RIGHT (FRAME_RIGHT + 4)
#define STEP         8 /* in an edge of the frame */

/* Outlines of as many rows and more are drawn by fxl_draw_by_active_edges. An edge of fewer than
 * 256 rows is lower than 2^24, so it holds for all of them, and nothing is set up by
 * fxl_edge_set_far. */
#if FXL_IS_COMPACT
#define OUTLINE_ROWS_MAX 255
#else
#define OUTLINE_ROWS_MAX 1020 /* below FXL_EDGE_HEIGHT_MAX >> 16, and a constant of cmp */
#endif

/* Looks at every vertex: survey of lib/raster/scan.c. */
    .macro survey
    ldr     r5, [r1, #SCREEN_POINT_Y - 8]
    add     r5, r5, r11
    asrs    r5, r5, #16
    mov     r6, r5
    mov     r7, r5
    movs    r8, #0
    mov     r9, r1
    mov     r10, r0
.Lvertex:
    ldrd    r12, lr, [r10], #8
    add     r12, r12, r11
    cmp     r12, r4
    bhs     .Lother
    add     lr, lr, r11
    asr     lr, lr, #16
    subs    r5, lr, r5
    ble     .Lupward
    add     r8, r8, r5
    mov     r5, lr
    cmp     r5, r7
    it      gt
    movgt   r7, r5
    cmp     r10, r1
    bne     .Lvertex
    b       .Lsurveyed
.Lcolumns:
    b       .Lother
.Lupward:
    mov     r5, lr
    cmp     r5, r6
    itt     lt
    movlt   r6, r5
    movlt   r9, r10
    cmp     r10, r1
    bne     .Lvertex
.Lsurveyed:
    sub     lr, r7, r6
    cmp     lr, r8
    bne     .Lother
    .endm

/* place fill-rule: outlines and rows for Armv7-M; half a pixel is a number here */
/* The survey: r0: points, r1: their end, r4: x + 1/2 - 2^-16 is below this, r5: row of the vertex
 * before, r6: first row, r7: last row plus 1, r8: rows of the downward edges, r9: one past the
 * highest vertex, r10: the next vertex. */
    push    {r4-r11, lr}
    sub     sp, sp, #FRAME_SIZE
    enter_outline
    movw    r11, #32767
    adds    r4, r4, #1
    lsls    r4, r4, #16
    add     r1, r0, r5, lsl #3
#if !FXL_IS_COMPACT
    cmp     r5, #3
    beq     .Ltriangle
#endif
.Lsurvey:
    survey
.Ltwo_chains:
    cmp     r8, #OUTLINE_ROWS_MAX
    bge     .Lother

    ldrh    r12, [r2, #BAND_FIRST_ROW]
    ldrh    lr, [r2, #BAND_ROWS]
    add     lr, lr, r12
    cmp     r7, lr
    it      gt
    movgt   r7, lr
    cmp     r6, r12
    it      lt
    movlt   r6, r12
    cmp     r6, r7
    bge     .Lno_row
    begin_filling
    lsl     r11, r6, #16
    sub     r8, r9, #8              /* where both chains begin */
    sub     r9, r6, #1              /* no edge yet: both end above the first row */
    subs    r4, r7, #1
    find_base
    add     r12, r11, #32768        /* from here on, the y of the row's centres in 16.16 */
    add     lr, sp, #FRAME_BEGIN
    stm     lr, {r0, r1, r3-r9}
    strd    r8, r9, [sp, #FRAME_RIGHT]

    /* Along the left chain, backward through the points, to the edge that ends below the row's
     * centre. */
.Lset_left:
    ldr     r2, [sp, #FRAME_LEFT]
    ldrd    r0, r1, [sp, #FRAME_BEGIN]
.Lleft_edge:
    ldrd    r4, r5, [r2]
    cmp     r2, r0
    it      eq
    moveq   r2, r1
    ldrd    r6, r7, [r2, #-8]!
    subs    r8, r7, r12
    ble     .Lleft_edge
    sub     r8, r8, #1
    asr     r8, r8, #16
    add     r0, r8, r12, asr #16
    strd    r2, r0, [sp, #FRAME_LEFT]
    mov     r3, sp
    b       .Lset_edge

#if !FXL_IS_COMPACT
    /* A triangle goes down once. */
.Ltriangle:
    ldm     r0, {r5-r10}            /* x, y of each */
    add     r5, r5, r11
    add     r7, r7, r11
    add     r9, r9, r11
    cmp     r5, r4
    itt     lo
    cmplo   r7, r4
    cmplo   r9, r4
    bhs     .Lother
    mov     r12, r6                 /* the greatest y */
    cmp     r8, r12
    it      gt
    movgt   r12, r8
    cmp     r10, r12
    it      gt
    movgt   r12, r10
    add     r9, r0, #8
    cmp     r8, r6                  /* r6: the least y */
    itt     lt
    movlt   r6, r8
    addlt   r9, r0, #16
    cmp     r10, r6
    itt     lt
    movlt   r6, r10
    movlt   r9, r1
    add     r6, r6, r11
    add     r7, r12, r11
    asrs    r6, r6, #16
    asrs    r7, r7, #16
    sub     r8, r7, r6
#ifdef SMALL_ROWS
    cmp     r8, #SMALL_ROWS
    bls     .Lsmall
#endif
    b       .Ltwo_chains
#endif

.Lno_row:
    movs    r0, #NO_ROW
    add     sp, sp, #FRAME_SIZE
    pop     {r4-r11, pc}

.Lother:
    leave_other

    /* The rows of a trapezoid are filled, and the edges are on the row below it. */
    begin_rows_below
    ldrd    r1, r0, [sp, #FRAME_LAST]
    cmp     r0, r1
    bge     .Lover
    stm     sp, {r4-r11}
    lsl     r12, r0, #16
    add     r12, r12, #65536 + 32768
    ldr     r1, [sp, #ROW_OF_LEFT]
    cmp     r1, r0
    ble     .Lset_left
.Ltest_right:
    ldr     r1, [sp, #ROW_OF_RIGHT]
    cmp     r1, r12, asr #16
    bge     .Lready

    /* The same along the right chain, forward through the points. */
.Lset_right:
    ldr     r2, [sp, #FRAME_RIGHT]
    ldrd    r0, r1, [sp, #FRAME_BEGIN]
.Lright_edge:
    ldrd    r4, r5, [r2], #8
    cmp     r2, r1
    it      eq
    moveq   r2, r0
    ldrd    r6, r7, [r2]
    subs    r8, r7, r12
    ble     .Lright_edge
    sub     r8, r8, #1
    asr     r8, r8, #16
    add     r0, r8, r12, asr #16
    strd    r2, r0, [sp, #FRAME_RIGHT]
    add     r3, sp, #EDGE_SIZE

    /* r3: the edge in the frame, r4, r5: its top, r6, r7: its bottom, r8: the rows from this one
     * on, less 1. */
.Lset_edge:
    sub     r9, r7, r5              /* height */
    subs    r6, r6, r4              /* dx */
    sub     r5, r12, r5             /* the centre less the top: whole rows, and t */
    clz     r1, r9                  /* shift */
    adds    r8, r8, r5, lsr #16     /* the edge's rows above this one and from it on, less 1 */
#if !FXL_IS_COMPACT
    beq     .Lone_row
#endif
#if !FXL_IS_COMPACT
    lsrs    r8, r8, r1              /* not 0: more rows than the edge holds for */
    bne     .Lset_far
#endif
    /* The sum of fxl_edge_dividend times 2^16, so that its upper word is the dividend: 4 dx, below
     * 2^29, by 2^14 t, and the height by 2^16 part. */
    lsls    r6, r6, #2
    lsl     r8, r5, #16
    lsrs    r8, r8, #2
    smull   r10, r11, r6, r8
    sub     r4, r4, #32768          /* start */
    lsls    r7, r4, #16
    umlal   r10, r11, r7, r9
    cmp     r10, #1
    sbc     r10, r11, #0
    lsl     r10, r10, #2            /* the first row's dividend times four */

    lsl     r7, r9, r1
    mvn     r8, #0x8000
    lsrs    r0, r7, #16
    udiv    r0, r8, r0
    lsls    r0, r0, #15
    umull   r8, r2, r0, r7
    negs    r2, r2
    umull   r8, r0, r0, r2          /* the reciprocal */
    rsb     r2, r1, #32
    mvn     r7, #0x80000000
    lsrs    r7, r7, r2              /* 2^(shift - 1) - 1 */

/* Input: \whole: the dividend times four. Results: \whole, and r8: the fraction, whose carry the
 * caller adds to \whole. */
    .macro  divide whole
    smull   r8, \whole, \whole, r0
    lsl     r11, \whole, r1
    lsr     r8, r8, r2
    orrs    r8, r8, r11
    asrs    \whole, \whole, r2
    subs    r8, r8, r7
    sbc     \whole, \whole, #0
    mls     r11, r8, r9, r9         /* the rest of the dividend, with half added */
    udiv    r11, r11, r9
    adds    r8, r8, r11
    .endm

    divide  r10
    adc     r10, r10, r4, asr #16
    ldrd    r4, lr, [sp, #FRAME_BASE]
    asr     r11, r12, #16
    mla     r4, r11, lr, r4
    add     r4, r4, r10             /* the address of the first pixel: the base has the 1 */
    strd    r4, r8, [r3]
    divide  r6
    adc     r6, r6, lr              /* the step, with the stride */
    strd    r6, r8, [r3, #STEP]
    lsrs    r5, r5, #16
    bne     .Ladvance
.Lside_done:
    cmp     sp, r3
    beq     .Ltest_right

.Lready:
    ldm     sp, {r4-r11}
    ldr     r0, [sp, #ROW_OF_LEFT]
    ldr     r1, [sp, #ROW_OF_RIGHT]
    ldrd    r2, r3, [sp, #FRAME_COLOUR]
    cmp     r0, r1
    it      gt
    movgt   r0, r1
    cmp     r0, r3
    it      gt
    movgt   r0, r3
    str     r0, [sp, #FRAME_UNTIL]
    sub     r12, r0, r12, asr #16   /* rows, less 1 */
    fill_rows

.Lover:
    bne     .Lexchanged
#ifdef LISTS_ROWS
    b       .Lall_listed
#else
    movs    r0, #1
    add     sp, sp, #FRAME_SIZE
    pop     {r4-r11, pc}
#endif

.Lexchanged:
    eor     r0, r0, #FRAME_EXCHANGED
    str     r0, [sp, #FRAME_UNTIL]
    stm     sp, {r4-r11}
    ldm     sp, {r8-r11}
    add     r0, sp, #EDGE_SIZE
    ldm     r0, {r4-r7}
    b       .Lrows_below

#if !FXL_IS_COMPACT
    /* The edge crosses only this row: compute its first pixel, and no step. */
.Lone_row:
    smull   r7, r8, r6, r5
    sub     r4, r4, #32768          /* start */
    uxth    r10, r4
    umlal   r7, r8, r10, r9
    subs    r7, r7, #1
    sbc     r8, r8, #0
    lsrs    r7, r7, #16
    orr     r7, r7, r8, lsl #16     /* the dividend */
    sdiv    r8, r7, r9
    mls     r7, r8, r9, r7
    add     r8, r8, r7, asr #31     /* downward */
    add     r8, r8, r4, asr #16
    ldrd    r4, lr, [sp, #FRAME_BASE]
    asr     r11, r12, #16
    mla     r4, r11, lr, r4
    add     r4, r4, r8
    str     r4, [r3]
    b       .Lside_done
#endif

    /* The edge began r5 rows above the row. */
.Ladvance:
    mov     r0, r5
    ldm     r3, {r4-r7}
    sub     r6, r6, lr
    mla     r4, r6, r0, r4
    movs    r1, #0
    umlal   r5, r1, r7, r0
    add     r4, r4, r1
    strd    r4, r5, [r3]
    b       .Lside_done

#if !FXL_IS_COMPACT
    /* Start the edge from its exact remainder: fxl_edge_set_far(top, bottom, row, rows, edge). */
.Lset_far:
    sub     r5, r12, r5
    add     r6, r6, r4
    add     r7, r5, r9
    mov     r8, r3
    mov     r9, r12
    push    {r4-r7}                 /* top and bottom */
    mov     r0, sp
    add     r1, sp, #8
    asr     r2, r9, #16
    sub     r3, r7, r9
    subs    r3, r3, #1
    asrs    r3, r3, #16
    adds    r3, r3, #1
    mov     r10, r3
    push    {r7, r8}                /* the edge, and a word for alignment */
    str     r8, [sp]
    bl      fxl_edge_set_far
    add     sp, sp, #24
    mov     r3, r8
    mov     r12, r9
    ldrd    r4, lr, [sp, #FRAME_BASE]
    asr     r11, r12, #16
    mla     r4, r11, lr, r4
    sub     r4, r4, #1
    ldr     r5, [r3]
    add     r4, r4, r5
    str     r4, [r3]
    ldr     r5, [r3, #STEP]
    add     r5, r5, lr
    str     r5, [r3, #STEP]
    cmp     r0, r10
    beq     .Lside_done
    /* The same edge is set again below the rows for which it holds. */
    add     r0, r0, r11
    subs    r0, r0, #1
    ldrd    r4, r5, [sp, #FRAME_BEGIN]
    cmp     sp, r3
    bne     .Lright_again
    ldr     r1, [sp, #FRAME_LEFT]
    adds    r1, r1, #8
    cmp     r1, r5
    it      eq
    moveq   r1, r4
    strd    r1, r0, [sp, #FRAME_LEFT]
    b       .Lside_done
.Lright_again:
    ldr     r1, [sp, #FRAME_RIGHT]
    cmp     r1, r4
    it      eq
    moveq   r1, r5
    subs    r1, r1, #8
    strd    r1, r0, [sp, #FRAME_RIGHT]
    b       .Lside_done
#endif
