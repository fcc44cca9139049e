/* SPDX-License-Identifier: MIT */
/* What plain_rows_armv6m.S and the code of the pixels that it goes to have in common, for Armv6-M:
 * the frame, and macros of pixels. Assembly. Code of pixels has these registers, paints the last ones of
 * 16 pixels, and goes to lr. It keeps r2, r8 to r12 and lr, and the frame but F_SHORT and F_SPARE. */
#ifndef FXL_PLAIN_ROWS_ARMV6M_H
#define FXL_PLAIN_ROWS_ARMV6M_H

/* clang-format off */

texels  .req r0
p       .req r1     /* the position */
pixels  .req r2     /* of the first of 16 pixels */
step    .req r4
mask    .req r5
palette .req r7

/* The frame. The values at the end of the segment that is next, and what a segment adds to them. */
#define F_W         0
#define F_U         8
#define F_V         16
#define F_W_STEP    24
#define F_U_STEP    32
#define F_V_STEP    40
#define F_U_DROP    48
#define F_V_DROP    52
#define F_TEXELS    56 /* then F_PIXELS, F_MASK, F_CODE and F_TABLE */
#define F_PIXELS    60 /* the first of 16 pixels whose last ones are the segment's */
#define F_MASK      64
#define F_CODE      68 /* what paints a whole segment */
#define F_TABLE     72
#define F_ROUND     76 /* half of what F_SHIFT drops */
#define F_SHIFT     80
#define F_U_SHIFT   84 /* F_U_DROP less the zeros of the weight */
#define F_V_SHIFT   88
#define F_U_0       92 /* U and V at the beginning of the segment */
#define F_V_0       96
#define F_SKIP      100 /* columns of the next segment that are not painted */
#define F_COLUMNS   104 /* of a segment, less 1 */
#define F_BACK      108 /* bytes of 16 pixels that a segment has not */
#define F_WIDTH     112 /* bytes of a segment's pixels */
#define F_LAST      116 /* the last F_PIXELS of a whole segment; then the first one beyond the run */
#define F_STOP      120
#define F_PIXEL     124 /* bytes of the code of a pixel; 0: a loop */
#define F_CODE_0    128 /* the code of 16 pixels */
#define F_WHOLE     132 /* what follows where the next segment is whole */
#define F_SHORT     136 /* for a loop: bytes of 16 pixels that are not painted */
#define F_COLUMN    140 /* for a loop: how far a position is shifted to the column; then, to the row */
#define F_ROW       144
#define F_SPARE     148
#define F_LOG       152 /* of the segments that the frame is for; above 4: none */
#define F_FACE      156
#define F_RECORD    160 /* the row, or the rows */
#define F_DONE      164 /* what follows a run */
#define F_X         168 /* the end of the run; then that of the row */
#define F_X_END     172
#define F_WIDE      176 /* 1: a pixel has 16 bits; else 0 */
#define F_PAINT     180 /* the loop */
#define F_IN_BEAM   184
#define F_SIZE      188

/* A line's frame has fxl_line_run in the place of the values: u, v, their changes in 16 columns; then: */
#define F_STEP      16

/* fxl_run and fxl_line_run */
#define RUN_X0      0 /* then x1 */
#define RUN_CODE    8
#define RUN_LOG     12
#define LINE_U      12
#define LINE_STEP   28

/* fxl_texel_code: of 16 pixels, and the same by a palette; the loop */
#define CODE_WIDE    0
#define CODE_PLAIN   4
#define CODE_PALETTE 16
#define CODE_LOOP    28

/* Pixels of a texture of any size, of 2^wide bytes. r6: the bytes of 16 pixels that are left out. The macro paint_texel
 * makes a pixel of the texel whose offset is in r3; it may overwrite r6. */
    .macro  paint_loop wide
    mov     r3, lr
    str     r3, [sp, #F_SPARE]
    mov     r3, r12
    str     r3, [sp, #F_SHORT]
    mov     lr, step
    adds    r6, r6, r2
    adds    r2, #(16 << \wide)
    mov     r12, r2
    mov     r2, r6
2:  ldr     r6, [sp, #F_ROW]
    movs    r3, p
    lsrs    r3, r6
    ands    r3, mask
    ldr     r6, [sp, #F_COLUMN]
    movs    r4, p
    lsrs    r4, r6
    adds    r3, r3, r4
    paint_texel
    adds    r2, #(1 << \wide)
    add     p, lr
    cmp     r2, r12
    bne     2b
    subs    r2, #(16 << \wide)
    ldr     r3, [sp, #F_SPARE]
    mov     lr, r3
    ldr     r3, [sp, #F_SHORT]
    mov     r12, r3
    bx      lr
    .endm

/* The pixels of a texture that is 2^log texels wide and no higher. */
    .macro  sixteen log, paint
    .irp    i, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
    .if     \log == 8
    movs    r3, p
    .else
    lsrs    r3, p, #(16 - 2 * \log)
    .endif
    ands    r3, mask
    lsrs    r6, p, #(32 - \log)
    adds    r3, r3, r6
    \paint  \i
    adds    p, p, step
    .endr
    bx      lr
    .endm

/* clang-format on */
#endif
