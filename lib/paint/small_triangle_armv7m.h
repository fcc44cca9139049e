/* SPDX-License-Identifier: MIT */
/* Small triangles of depth_outline_armv7m.h: all centres of the box by edge functions, without
 * edges and their divisions. It draws those whose box lies in the band, has one octave by a test of
 * its first value and the change along both sides, and that go clockwise by more than rounding takes
 * away; the chains draw the others. */

/* In the stack frame: what the survey has found, and then the changes from the end of a row to the
 * next; the code of the row, its change a row, and the step. */
#define SMALL_WIDTH   12
#define SMALL_ROW     16
#define SMALL_LEFT    24 /* rows that are left */
#define SMALL_COLUMN  32
#define SMALL_COUNT   36 /* of columns */
#define SMALL_CELL    40 /* the number of the first cell */
#define SMALL_DOWN    44
#define SMALL_STEP    52
#define SMALL_CODE    56

/* A centre, so many before the end of a row, and on to the next one. */
    .macro small_centre length
    orr     r4, r1, r2
    orrs    r4, r4, r7
    bmi     .Lsmall_hidden\length
    ldrh    r4, [r12, #-2 * \length]
    lsr     r5, r8, #16
    cmp     r5, r4
    bls     .Lsmall_hidden\length
#if PIXEL_BITS == 16
    strh    r6, [r3, #-2 * \length]
#else
    strb    r6, [r3, #-\length]
#endif
    strh    r5, [r12, #-2 * \length]
.Lsmall_hidden\length:
    .if     \length > 1
    add     r1, r1, r10
    add     r2, r2, r11
    add     r7, r7, r0
    add     r8, r8, r9
    .endif
    .endm

    /* r0: points, r2: band, r3: outline, r6: first row, r7: last row plus 1, r8: rows, r11: 32767 */
.Lsmall:
    small_box SMALL_COLUMNS, SMALL_CENTRES
    mla     lr, lr, r5, r10
    stm     sp, {r0-r2, r5-r10, r12, lr}

    /* If the first value of the box, less all that the others change along both sides, has the
     * octave of their sum, all values have it. Upper words: a change is rounded up. Values on the
     * screen are below 2^62, so both changes are below 2^30 + 8, and their sum is below 2^30 by the
     * comparison. */
    ldrd    r4, r5, [r3, #DEPTH_OUTLINE_VALUE]
    ldrd    r0, r1, [r3, #DEPTH_OUTLINE_DOWN]
    ldrd    r2, r7, [r3, #DEPTH_OUTLINE_ALONG]
    umlal   r4, r5, r0, r6
    mla     r5, r1, r6, r5
    mov     r9, r4
    mov     r11, r5
    umlal   r9, r11, r2, r10
    mla     r11, r7, r10, r11
    eor     r9, r7, r7, asr #31
    eor     lr, r1, r1, asr #31
    sub     r12, r12, #1
    sub     r8, r8, #1
    mla     r9, r9, r12, r12
    mla     lr, lr, r8, r8
    add     r9, r9, lr
    cmp     r9, #0x40000000
    bhs     .Lsmall_not
    sub     lr, r11, r9
    add     r9, r11, r9
    eor     r9, r9, lr
    clz     r9, r9
    clz     r11, r11
    cmp     r9, r11
    ble     .Lsmall_not
    find_octave r11, r6, r8, r9, r12, .Lsmall_not, .Lsmall_not
    sub     r12, r9, #1
    cmp     r12, #31                /* drop: 1 to 32 */
    bhi     .Lsmall_not
    rsb     r12, r9, #32
    lsr     r8, r4, r9
    lsl     r4, r4, r12
    lsl     r5, r5, r12
    orr     r5, r5, r8
    lsr     r8, r0, r9
    lsl     r0, r0, r12
    lsl     r1, r1, r12
    orr     r1, r1, r8
    lsr     r2, r2, r9
    lsl     r7, r7, r12
    orr     r2, r2, r7              /* step */
    add     r5, r5, r6
    mla     r5, r2, r10, r5
    add     r12, sp, #SMALL_DOWN
    stm     r12, {r0, r1, r2, r4, r5}

    ldr     r0, [sp]
    ldr     r10, [sp, #SMALL_COLUMN]
    ldr     r11, [sp, #SMALL_ROW]
    ldr     lr, [sp, #SMALL_COUNT]
    lsl     r10, r10, #16
    lsl     r11, r11, #16
/* place fill-rule: small triangles for Armv7-M */
    add     r10, r10, #32768
    add     r11, r11, #32768
    edge_functions
    sub     r12, lr, #1
    mls     r5, r12, r10, r5
    mls     r6, r12, r11, r6
    mls     r4, r12, r0, r4
    stm     sp, {r4, r5, r6}        /* from the last column on to the next row */
    add     r3, r3, #DEPTH_OUTLINE_CELLS
    ldr     r12, [sp, #SMALL_CELL]
    ldm     r3, {r3, r4, r6}        /* cells, pixels, filling */
    ldr     r8, [sp, #SMALL_CODE + 4]
    ldr     r9, [sp, #SMALL_STEP]
    add     r12, r12, lr
    add     r12, r3, r12, lsl #1
#if PIXEL_BITS == 16
    add     r3, r4, r12
#else
    add     r3, r4, r12, lsr #1
#endif

    /* A row. r1, r2, r7: the edge functions, r10, r11, r0: their change a column, r8: the code, r9: its
     * step, r12: the end of the cells, r3: that of the pixels, r6: the filling, lr: columns */
.Lsmall_row:
    tbb     [pc, lr]
.Lsmalls:
    .irp    length, 0, 1, 2, 3, 4, 5, 6, 7, 8
    .if     \length == 0
    .byte   0
    .else
    .byte   (.Lsmall\length - .Lsmalls) / 2
    .endif
    .endr
    .align  1
    .irp    length, 8, 7, 6, 5, 4, 3, 2, 1
.Lsmall\length:
    small_centre \length
    .endr
    ldr     r4, [sp, #SMALL_LEFT]
    subs    r4, r4, #1
    beq     .Lsmall_done
    str     r4, [sp, #SMALL_LEFT]
    ldm     sp, {r4, r5, r8}
    add     r7, r7, r4
    add     r1, r1, r5
    add     r2, r2, r8
    ldrd    r4, r5, [sp, #SMALL_DOWN]
    ldr     r8, [sp, #SMALL_CODE]
    adds    r4, r4, r8
    ldr     r8, [sp, #SMALL_CODE + 4]
    adc     r8, r8, r5
    strd    r4, r8, [sp, #SMALL_CODE]
    ldr     r4, [sp, #SMALL_WIDTH]
    add     r12, r12, r4, lsl #1
#if PIXEL_BITS == 16
    add     r3, r3, r4, lsl #1
#else
    add     r3, r3, r4
#endif
    b       .Lsmall_row

.Lsmall_done:
    movs    r0, #1
    add     sp, sp, #FRAME_SIZE
    pop     {r4-r11, pc}

.Lsmall_not:
    ldm     sp, {r0-r2, r5-r9}
    movw    r11, #32767
    b       .Ltwo_chains
