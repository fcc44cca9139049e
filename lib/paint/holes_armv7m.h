/* SPDX-License-Identifier: MIT */
/* Part of plain_rows_armv7m.h: texels that are keyed or stippled, in a depth buffer of 16 bits. The
 * depth of a pixel that is drawn is kept with it. special_texels_armv7m.h has the same without a
 * depth buffer. Assembly. */
#ifndef FXL_HOLES_ARMV7M_H
#define FXL_HOLES_ARMV7M_H

/* clang-format off */

#define F_HOLES       F_PLAIN         /* the fxl_hole_depths; then the step of the codes */
#define F_HOLES_STEP  (F_PLAIN + 4)
#define F_HELD        28              /* bytes that are pushed */

    .type   HOLES, %function
    .thumb_func

/* r0: face, r1: row, r2: x0, r3: x1, on the stack: depths */
HOLES:
    push    {r4-r11, lr}
    sub     sp, #F_SIZE
    adr     r4, .Lreturn + 1
    strd    r4, r1, [sp, #F_DONE]
    ldr     r6, [sp, #(F_SIZE + 36)]
    ldr     r7, [r6]
    strd    r6, r7, [sp, #F_HOLES]
    bl      .Lprepare
    ldrb    r4, [r0, #SEGMENT_FACE_KIND]
    .if     !WIDE
    ldr     r6, [r0, #TABLE]
    cmp     r6, #0
    bne     1f
    .endif
    cmp     r4, #1
    ite     eq
    adreq   r4, .Lkeyed_hole + 1
    adrne   r4, .Lstippled_hole + 1
    .if     !WIDE
    b       2f
1:  cmp     r4, #1
    ite     eq
    adreq   r4, .Lkeyed_hole_tabled + 1
    adrne   r4, .Lstippled_hole_tabled + 1
2:
    .endif
    str     r4, [sp, #F_CODE]
    str     r4, [sp, #F_FULL]
    b       .Lrow_alone

/* r12: the cell of the pixel before the four that are next, lr: the code of the first pixel. Wide
 * pixels have the step of codes in r6. */
    .macro  begin_holes
    push    {r7-r12, lr}
    add     r11, pixels, #(16 << WIDE)
    ldrd    r7, r8, [sp, #(F_COLUMN + F_HELD)]
    ldr     r3, [sp, #(F_BEFORE + F_HELD)]
    ldr     r9, [sp, #(F_SHORT + F_HELD)]
    str     r9, [sp, #(F_BEFORE + F_HELD)]
    bic     r9, r3, #3
    add     pixels, pixels, r9, lsl #WIDE
    and     r9, r3, #3
    ldr     r3, [sp, #(F_ROW + F_HELD)]
    ldr     r3, [r3, #PAINT_ROW_PIXELS]
    sub     r3, pixels, r3
    .if     WIDE
    asrs    r3, r3, #1
    .endif
    ldr     r12, [sp, #(F_HOLES + F_HELD)]
    ldm     r12, {r10, r12, lr}         /* step, cells, code */
    add     r12, r12, r3, lsl #1
    add     r3, r3, r9
    adds    r3, r3, #1
    mla     lr, r10, r3, lr
    .if     WIDE
    mov     r6, r10
    .endif
    .endm

/* Goes to the first of four pixels that are not left out; r9: how many are. */
    .macro  go_holes first, bytes
    movs    r3, #\bytes
    mul     r9, r9, r3
    adr     r3, \first + 1
    add     r3, r3, r9
    bx      r3
    .endm

    .macro  keep_hole tabled, i
    .if     \tabled
    ldrb.w  r3, [table, r3]
    .endif
    lsr.w   r9, lr, #16
    store_special \i
    strh.w  r9, [r12, #(2 * \i)]
    .endm

    .macro  next_hole
    add     p, step
    .if     WIDE
    add     lr, r6
    .else
    ldr.w   r9, [sp, #(F_HOLES_STEP + F_HELD)]
    add     lr, r9
    .endif
    .endm

    .macro  end_holes first
    adds    pixels, #(4 << WIDE)
    adds    r12, #8
    cmp     pixels, r11
    bne     \first
    pop     {r7-r12, lr}
    ldr     pc, [sp, #F_NEXT]
    .endm

    .macro  keyed_hole label, tabled, bytes
    .align  2
.Lkeyed_hole\label:
    begin_holes
    ldr     r3, [sp, #(F_FACE + F_HELD)]
    ldr     r10, [r3, #SEGMENT_FACE_LIGHT_MAX] /* the key */
    go_holes .Lkeyed_hole_pixels\label, \bytes
    .align  2
.Lkeyed_hole_pixels\label:
    .irp i, 1, 2, 3, 4
    find_special
    load_special
    cmp     r3, r10
    beq.n   1f
    keep_hole \tabled, \i
1:  next_hole
    .endr
    check_bytes .Lkeyed_hole_pixels\label, \bytes
    end_holes .Lkeyed_hole_pixels\label
    .endm

    .macro  stippled_hole label, tabled, bytes
    .align  2
.Lstippled_hole\label:
    begin_holes
    push    {r9}
    find_pattern (F_HELD + 4)
    pop     {r9}
    go_holes .Lstippled_hole_pixels\label, \bytes
    .align  2
.Lstippled_hole_pixels\label:
    .irp i, 1, 2, 3, 4
    tst     r10, #(1 << (\i & 3))
    beq.n   1f
    find_special
    load_special
    keep_hole \tabled, \i
1:  next_hole
    .endr
    check_bytes .Lstippled_hole_pixels\label, \bytes
    end_holes .Lstippled_hole_pixels\label
    .endm

    .if     WIDE
    keyed_hole , 0, 36
    stippled_hole , 0, 38
    .else
    keyed_hole , 0, 40
    stippled_hole , 0, 42
    keyed_hole _tabled, 1, 44
    stippled_hole _tabled, 1, 46
    .endif

/* clang-format on */

#endif
