/* SPDX-License-Identifier: MIT */
/* Part of plain_rows_armv7m.h: texels that are keyed, stippled or of 4 bits, of a texture of any
 * size. special_texels.h is the portable text. Assembly. */
#ifndef FXL_SPECIAL_TEXELS_ARMV7M_H
#define FXL_SPECIAL_TEXELS_ARMV7M_H

/* clang-format off */

/* Four pixels are painted a turn, and the first turn begins within the four. r7, r8: how far a
 * position is shifted to the column and to the row; r9: free; r10: the kind's own; r11: where
 * `pixels` ends. */
#define F_PUSHED   20

    .macro  begin_special
    push    {r7-r11}
    add     r11, pixels, #(16 << WIDE)
    ldrd    r7, r8, [sp, #(F_COLUMN + F_PUSHED)]
    .endm

/* Leaves out F_BEFORE pixels of 16, of so many bytes of code each, from \first on. */
    .macro  go_special first, bytes
    ldr     r3, [sp, #(F_BEFORE + F_PUSHED)]
    ldr     r9, [sp, #(F_SHORT + F_PUSHED)]
    str     r9, [sp, #(F_BEFORE + F_PUSHED)]
    bic     r9, r3, #3
    add     pixels, pixels, r9, lsl #WIDE
    and     r3, r3, #3
    movs    r9, #\bytes
    mul     r3, r3, r9
    adr     r9, \first + 1
    add     r3, r3, r9
    bx      r3
    .endm

    .macro  end_special first
    adds    pixels, #(4 << WIDE)
    cmp     pixels, r11
    bne     \first
    pop     {r7-r11}
    ldr     pc, [sp, #F_NEXT]
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

    .macro  store_special_if condition, i
    it      \condition
    .if     WIDE
    strh\condition\().w r3, [pixels, #(2 * \i)]
    .else
    strb\condition\().w r3, [pixels, #\i]
    .endif
    add     p, step
    .endm

    .align  2
.Lkeyed:
    begin_special
    go_special .Lkeyed_pixels, 26
    .align  2
.Lkeyed_pixels:
    .irp i, 1, 2, 3, 4
    find_special
    load_special
    cmp     r3, table
    store_special_if ne, \i
    .endr
    end_special .Lkeyed_pixels

/* r10: whether the pixel 4 n + i of the 16 is drawn, in bit i. */
    .align  2
.Lstippled:
    begin_special
    ldr     r3, [sp, #(F_ROW + F_PUSHED)]
    ldrd    r9, r10, [r3, #PAINT_ROW_PIXELS] /* and y */
    sub     r9, pixels, r9
    ubfx    r9, r9, #WIDE, #2
    and     r10, r10, #3
    lsl     r10, r10, #2
    ldr     r3, [sp, #(F_FACE + F_PUSHED)]
    ldr     r3, [r3, #SEGMENT_FACE_LIGHT_MAX] /* the pattern */
    lsr     r3, r3, r10
    and     r3, r3, #15
    orr     r3, r3, r3, lsl #4
    lsr     r10, r3, r9
    go_special .Lstippled_pixels, 28
    .align  2
.Lstippled_pixels:
    .irp i, 1, 2, 3, 4
    find_special
    load_special
    tst     r10, #(1 << (\i & 3))
    store_special_if ne, \i
    .endr
    end_special .Lstippled_pixels

/* r10: the colours. */
    .align  2
.Lfour_bits:
    begin_special
    ldr     r3, [sp, #(F_FACE + F_PUSHED)]
    ldr     r10, [r3, #SEGMENT_FACE_IN_BEAM] /* the colours */
    go_special .Lfour_bits_pixels, (38 + 4 * WIDE)
    .align  2
.Lfour_bits_pixels:
    .irp i, 1, 2, 3, 4
    find_special
    lsrs    r3, r3, #1
    ldrb.w  r3, [texels, r3]
    ite     cs
    lsrcs.w r3, r3, #4
    andcc.w r3, r3, #15
    ldrb.w  r3, [r10, r3]
    .if     WIDE
    ldrh.w  r3, [table, r3, lsl #1]
    strh.w  r3, [pixels, #(2 * \i)]
    .else
    strb.w  r3, [pixels, #\i]
    .endif
    add     p, step
    .endr
    end_special .Lfour_bits_pixels

/* clang-format on */

#endif
