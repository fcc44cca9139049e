/* SPDX-License-Identifier: MIT */
/* Part of plain_rows_armv7m.h: texels that are keyed, stippled or of 4 bits, of a texture of any
 * size. special_texels.h is the portable text. Assembly. */
#ifndef FXL_SPECIAL_TEXELS_ARMV7M_H
#define FXL_SPECIAL_TEXELS_ARMV7M_H

/* clang-format off */

/* Four pixels are painted a turn, and the first turn begins within the four. r7, r8: how far a
 * position is shifted to the column and to the row; r9: free; r10: the kind's own; r11: where
 * `pixels` ends. deep: 1 where depths are kept (holes_armv7m.h): there r12 is the address of the cell
 * before the four that are next, and lr the code of the next pixel. */
#define F_PUSHED   20
#define F_HELD     28                   /* the same, deep */

    .macro  begin_special deep
    .if     \deep
    push    {r7-r12, lr}
    .else
    push    {r7-r11}
    .endif
    add     r11, pixels, #(16 << WIDE)
    ldrd    r7, r8, [sp, #(.LF_COLUMN + F_PUSHED + 8 * \deep)]
    .endm

/* Leaves out F_BEFORE pixels of 16: `pixels` goes on by fours, and r3 are the rest of them. */
    .macro  leave_special deep
    ldr     r3, [sp, #(.LF_BEFORE + F_PUSHED + 8 * \deep)]
    cbz     r3, 1f
    ldr     r9, [sp, #(.LF_SHORT + F_PUSHED + 8 * \deep)]
    str     r9, [sp, #(.LF_BEFORE + F_PUSHED + 8 * \deep)]
    bic     r9, r3, #3
    add     pixels, pixels, r9, lsl #WIDE
    and     r3, r3, #3
1:
    .endm

/* Goes to the first of four pixels that is not left out, each of so many bytes of code. */
    .macro  go_special first, bytes
    cbz     r3, \first
    movs    r9, #\bytes
    mul     r3, r3, r9
    adr     r9, \first + 1
    add     r3, r3, r9
    bx      r3
    .endm

    .macro  end_special deep, first
    adds    pixels, #(4 << WIDE)
    .if     \deep
    adds    r12, #8
    .endif
    cmp     pixels, r11
    bne     \first
    .if     \deep
    pop     {r7-r12, lr}
    .else
    pop     {r7-r11}
    .endif
    ldr     pc, [sp, #.LF_NEXT]
    .endm

/* clang knows how long a branch is only after all `.if`: GNU as checks for it. */
    .macro  check_bytes first, bytes
#ifndef __clang__
    .if     . - \first - 4 * \bytes
    .error  "bytes of the code of a pixel"
    .endif
#endif
    .endm

/* r3 = the number of the texel at the position; 12 bytes. */
    .macro  find_special
    lsr.w   r3, p, r8
    ands    r3, mask
    lsr.w   r9, p, r7
    add     r3, r3, r9
    .endm

    .macro  load_special
    .if     WIDE
    ldrh.w  r3, [texels, r3, lsl #1]
    .else
    ldrb.w  r3, [texels, r3]
    .endif
    .endm

    .macro  load_of_16
    .if     WIDE
    ldrh.w  r3, [table, r3, lsl #1]
    .else
    ldrb.w  r3, [table, r3]
    .endif
    .endm

    .macro  store_special i
    .if     WIDE
    strh.w  r3, [pixels, #(2 * \i)]
    .else
    strb.w  r3, [pixels, #\i]
    .endif
    .endm

    .macro  store_special_if condition, i
    it      \condition
    .if     WIDE
    strh\condition\().w r3, [pixels, #(2 * \i)]
    .else
    strb\condition\().w r3, [pixels, #\i]
    .endif
    add     p, step
    .endm

/* Keyed texels. r10: the key. */
    .macro  keyed label, tabled, bytes
    .align  2
.Lkeyed\label:
    begin_special 0
    ldr     r10, [sp, #(.LF_OWN + F_PUSHED)]
    leave_special 0
    go_special .Lkeyed_pixels\label, \bytes
    .align  2
.Lkeyed_pixels\label:
    .irp i, 1, 2, 3, 4
    find_special
    load_special
    cmp     r3, r10
    .if     \tabled
    it      ne
    ldrbne  r3, [table, r3]
    .endif
    store_special_if ne, \i
    .endr
    check_bytes .Lkeyed_pixels\label, \bytes
    end_special 0, .Lkeyed_pixels\label
    .endm

/* The pattern of four columns of a row, many times. r10: that of the face, r3: y. */
    .macro  find_pattern
    and     r3, r3, #3
    lsl     r3, r3, #2
    lsr     r10, r10, r3
    and     r10, r10, #15
    orr     r10, r10, r10, lsl #4
    orr     r10, r10, r10, lsl #8
    .endm

/* A pixel that is not drawn takes 3 instructions. */
    .macro  stippled label, tabled, bytes
    .align  2
.Lstippled\label:
    begin_special 0
    ldr     r3, [sp, #(.LF_ROW + F_PUSHED)]
    ldrd    r9, r3, [r3, #PAINT_ROW_PIXELS] /* and y */
    ldr     r10, [sp, #(.LF_OWN + F_PUSHED)]
    find_pattern
    sub     r9, pixels, r9
    ubfx    r9, r9, #WIDE, #2
    lsr     r10, r10, r9                /* bit i: whether the pixel 4 n + i of the 16 is drawn */
    leave_special 0
    go_special .Lstippled_pixels\label, \bytes
    .align  2
.Lstippled_pixels\label:
    .irp i, 1, 2, 3, 4
    tst     r10, #(1 << (\i & 3))
    beq.n   1f
    find_special
    load_special
    .if     \tabled
    ldrb.w  r3, [table, r3]
    .endif
    store_special \i
1:  add     p, step
    .endr
    check_bytes .Lstippled_pixels\label, \bytes
    end_special 0, .Lstippled_pixels\label
    .endm

    keyed   , 0, 26
    stippled , 0, (28 + 0)
    .if     !WIDE
    keyed   _tabled, 1, 30
    stippled _tabled, 1, 32
    .endif

/* Texels of 4 bits. table: what each of the 16 becomes. A texture of any size: */
    .align  2
.Lfour_bits:
    begin_special 0
    leave_special 0
    go_special .Lfour_bits_pixels, 38
    .align  2
.Lfour_bits_pixels:
    .irp i, 1, 2, 3, 4
    find_special
    lsrs    r3, r3, #1
    ldrb.w  r3, [texels, r3]
    ite     cs
    lsrcs.w r3, r3, #4
    andcc.w r3, r3, #15
    load_of_16
    store_special \i
    add     p, step
    .endr
    check_bytes .Lfour_bits_pixels, 38
    end_special 0, .Lfour_bits_pixels

/* A texture of 2^log columns that is no higher. mask: half of the mask of rows; r7: how far a byte is
 * shifted to the texel, r8: 4; r9: where `pixels` ends. */
#define F_FEW_PUSHED 12
#define FOUR_BITS    (164 + 8 * WIDE)   /* bytes of the code for a width */
    .macro  four_bits log
    .align  2
.Lfour_bits_\log:
    push    {r7-r9}
    add     r9, pixels, #(16 << WIDE)
    mov     r8, #4
    ldr     r3, [sp, #(.LF_BEFORE + F_FEW_PUSHED)]
    cbz     r3, .Lfour_bits_pixels_\log
    ldr     r7, [sp, #(.LF_SHORT + F_FEW_PUSHED)]
    str     r7, [sp, #(.LF_BEFORE + F_FEW_PUSHED)]
    bic     r7, r3, #3
    add     pixels, pixels, r7, lsl #WIDE
    and     r3, r3, #3
    movs    r7, #(26 + 2 * WIDE)
    muls    r3, r7, r3
    adr     r7, .Lfour_bits_pixels_\log + 1
    add     r3, r3, r7
    bx      r3
    .align  2
.Lfour_bits_pixels_\log:
    .irp i, 1, 2, 3, 4
    and.w   r3, mask, p, lsr #(17 - 2 * \log)
    add.w   r3, r3, p, lsr #(33 - \log)
    ldrb    r3, [texels, r3]
    and.w   r7, r8, p, lsr #(30 - \log)
    lsrs    r3, r7
    and.w   r3, r3, #15
    .if     WIDE
    ldrh.w  r3, [table, r3, lsl #1]
    strh.n  r3, [pixels, #(2 * \i)]
    .else
    ldrb    r3, [table, r3]
    strb.n  r3, [pixels, #\i]
    .endif
    add     p, step
    .endr
    check_bytes .Lfour_bits_pixels_\log, (26 + 2 * WIDE)
    adds    pixels, #(4 << WIDE)
    cmp     pixels, r9
    bne     .Lfour_bits_pixels_\log
    pop     {r7-r9}
    ldr     pc, [sp, #.LF_NEXT]
    .endm

    four_bits 5
    .org    .Lfour_bits_5 + FOUR_BITS
    four_bits 6
    .org    .Lfour_bits_5 + 2 * FOUR_BITS
    four_bits 7
    .org    .Lfour_bits_5 + 3 * FOUR_BITS
    four_bits 8

    .if     WIDE
/* Plain texels of RGB565, of a texture of any size: all 16 pixels without a loop. */
    .align  2
.Lcolours:
    push    {r7-r9}
    ldrd    r7, r8, [sp, #(.LF_COLUMN + F_FEW_PUSHED)]
    ldr     r3, [sp, #(.LF_BEFORE + F_FEW_PUSHED)]
    cbz     r3, .Lcolours_pixels
    ldr     r9, [sp, #(.LF_SHORT + F_FEW_PUSHED)]
    str     r9, [sp, #(.LF_BEFORE + F_FEW_PUSHED)]
    add     r3, r3, r3, lsl #2
    adr     r9, .Lcolours_pixels + 1
    add     r3, r9, r3, lsl #2
    bx      r3
    .align  2
.Lcolours_pixels:
    .irp i, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16
    .if     \i == 5
    check_bytes .Lcolours_pixels, 20
    .endif
    find_special
    ldrh.w  r3, [texels, r3, lsl #1]
    .if     \i < 16
    strh.n  r3, [pixels, #(2 * \i)]
    .else
    strh    r3, [pixels, #(2 * \i)]!
    .endif
    add     p, step
    .endr
    pop     {r7-r9}
    ldr     pc, [sp, #.LF_NEXT]
    .endif

/* clang-format on */

#endif
