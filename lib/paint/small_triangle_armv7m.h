/* SPDX-License-Identifier: MIT */
/* Small triangles of depth_outline_armv7m.h: all centres of the box by edge functions, without
 * edges and their divisions. It draws those whose box lies in the band, has one octave by a test of
 * its first value and the change along both sides, and that go clockwise by more than rounding takes
 * away; the chains draw the others. */

/* In the stack frame. First the changes of the edge functions from the end of a row to the next. */
#define SMALL_WIDTH   12 /* cells of a row of the band */
#define SMALL_LEFT    16 /* rows that are left */
#define SMALL_EDGES   20 /* r0, r1, r2, r7, r10, r11 of the first centre */
#define SMALL_COUNT   44 /* of columns */
#define SMALL_CELL    48 /* the number of the first cell of the row */
#define SMALL_ROW     52
#define SMALL_COLUMN  56
/* Until the codes are known: */
#define SMALL_POINTS  60 /* odd: it is a face of depth_face_armv7m.h, which has the points and the band elsewhere */
#define SMALL_BAND    64
#define SMALL_BEGIN   72 /* columns from the first centre on, in its row */
/* And then: the code of the row's first cell, and its change a row. */
#define SMALL_DOWN    60
#define SMALL_CODE    68

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

#if PIXEL_BITS == 16
/* The first centre that is covered: the row and the cells begin at its row, and r12 are the columns
 * from it on. Goes to .Lsmall_done if there is none. r4, r5, r6: from the end of a row to the next. */
    .macro find_covered
    ldr     r8, [sp, #SMALL_LEFT]
    b       .Lsmall_look
.Lsmall_next:
    add     r1, r1, r10
    add     r2, r2, r11
    add     r7, r7, r0
.Lsmall_look:
    orr     r9, r1, r2
    orrs    r9, r9, r7
    bpl     .Lsmall_covers
    subs    r12, r12, #1
    bne     .Lsmall_next
    subs    r8, r8, #1
    beq     .Lsmall_done
    add     r1, r1, r5
    add     r2, r2, r6
    add     r7, r7, r4
    mov     r12, lr
    b       .Lsmall_look
.Lsmall_covers:
    ldrd    r5, r9, [sp, #SMALL_WIDTH]
    subs    r9, r9, r8
    beq     .Lsmall_here
    str     r8, [sp, #SMALL_LEFT]
    ldrd    r4, r6, [sp, #SMALL_CELL]
    mla     r4, r9, r5, r4
    add     r6, r6, r9
    strd    r4, r6, [sp, #SMALL_CELL]
.Lsmall_here:
    .endm

/* Goes where the plane of a face is found, if it is not known. */
    .macro begin_plane
    ldr     r4, [sp, #SMALL_POINTS]
    lsls    r4, r4, #31
    bne     .Lface_plane
    .endm
#endif

/* What the survey of a triangle wants. r0: points, r2: band, r3: outline */
    .macro begin_survey
    ldrh    r4, [r2, #BAND_WIDTH]
    movw    r11, #32767
    add     r4, r4, #1
    lsl     r4, r4, #16
    add     r1, r0, #24
    .endm

    /* r0: points, r2: band, r3: outline, r6: first row, r7: last row plus 1, r8: rows, r11: 32767 */
.Lsmall:
    small_box SMALL_COLUMNS, SMALL_CENTRES
    mla     lr, lr, r5, r10
    strd    r0, r2, [sp, #SMALL_POINTS]

    /* r6: the first row, r10: the first column, r8: rows, r12: columns, lr: the number of the first
     * cell, r5: cells of a row of the band, r0: points, r3: the outline */
.Lsmall_box:
    strd    r5, r8, [sp, #SMALL_WIDTH]
    strd    r12, lr, [sp, #SMALL_COUNT]
    strd    r6, r10, [sp, #SMALL_ROW]
    mov     lr, r12
    lsl     r10, r10, #16
    lsl     r11, r6, #16
/* place fill-rule: small triangles for Armv7-M */
    add     r10, r10, #32768
    add     r11, r11, #32768
    edge_functions
    sub     r12, lr, #1
    mls     r5, r12, r10, r5
    mls     r6, r12, r11, r6
    mls     r4, r12, r0, r4
    stm     sp, {r4, r5, r6}        /* from the last column on to the next row */
#if PIXEL_BITS == 16
    mov     r12, lr
    find_covered
#endif
    add     r4, sp, #SMALL_EDGES
    stm     r4, {r0, r1, r2, r7, r10, r11}
#if PIXEL_BITS == 16
    str     r12, [sp, #SMALL_BEGIN]
    begin_plane
#endif

    /* If the first value of the box, less all that the others change along both sides, has the
     * octave of their sum, all values have it. Upper words: a change is rounded up. Values on the
     * screen are below 2^62, so both changes are below 2^30 + 8, and their sum is below 2^30 by the
     * comparison. */
.Lsmall_codes:
    ldrd    r4, r5, [r3, #DEPTH_OUTLINE_VALUE]
    ldrd    r0, r1, [r3, #DEPTH_OUTLINE_DOWN]
    ldrd    r2, r7, [r3, #DEPTH_OUTLINE_ALONG]
    ldrd    r6, r10, [sp, #SMALL_ROW]
    ldr     r12, [sp, #SMALL_COUNT]
    ldr     r8, [sp, #SMALL_LEFT]
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
    bhs     .Lsmall_several
    sub     lr, r11, r9
    add     r9, r11, r9
    eor     r9, r9, lr
    clz     r9, r9
    clz     r11, r11
    cmp     r9, r11
    ble     .Lsmall_several
    find_octave r11, r6, r8, r9, r12, .Lsmall_several, .Lsmall_several
    sub     r12, r9, #1
    cmp     r12, #31                /* drop: 1 to 32 */
    bhi     .Lsmall_several
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
    orr     r9, r2, r7              /* step */
    add     r5, r5, r6
    mla     r5, r9, r10, r5
    ldr     r12, [sp, #SMALL_COUNT]
#if PIXEL_BITS == 16
    ldr     lr, [sp, #SMALL_BEGIN]
#endif
    strd    r0, r1, [sp, #SMALL_DOWN]
    strd    r4, r5, [sp, #SMALL_CODE]
#if PIXEL_BITS == 16
    sub     r4, r12, lr
    mla     r8, r9, r4, r5
#else
    mov     lr, r12
    mov     r8, r5
#endif
    add     r3, r3, #DEPTH_OUTLINE_CELLS
    ldr     r5, [sp, #SMALL_CELL]
    ldm     r3, {r3, r4, r6}        /* cells, pixels, filling */
    add     r12, r12, r5
    add     r12, r3, r12, lsl #1
#if PIXEL_BITS == 16
    add     r3, r4, r12
#else
    add     r3, r4, r12, lsr #1
#endif
    add     r4, sp, #SMALL_EDGES
    ldm     r4, {r0, r1, r2, r7, r10, r11}

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
#if PIXEL_BITS == 16
    ldr     lr, [sp, #SMALL_COUNT]
#endif
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
    ldrd    r0, r2, [sp, #SMALL_POINTS]
#if PIXEL_BITS == 16
    lsls    r1, r0, #31
    bne     .Lface_whole
#endif
.Lsmall_survey:
    begin_survey
    b       .Lsurvey

.Lsmall_several:
    ldrd    r0, r2, [sp, #SMALL_POINTS]
#if PIXEL_BITS == 16
    lsls    r1, r0, #31
    bne     .Lface_several
#endif
    b       .Lsmall_survey
