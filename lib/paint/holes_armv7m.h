/* SPDX-License-Identifier: MIT */
/* Part of plain_rows_armv7m.h: texels that are keyed or stippled, in a depth buffer of 16 bits. The
 * depth of a pixel that is drawn is kept with it. special_texels_armv7m.h has the same without a
 * depth buffer. Assembly. */
#ifndef FXL_HOLES_ARMV7M_H
#define FXL_HOLES_ARMV7M_H

/* clang-format off */

/* What paints pixels of a kind. */
    .macro  hole_code code
    adr     r4, \code + 1
    .if     !WIDE
    ldr     r6, [r0, #TABLE]
    cmp     r6, #0
    it      ne
    adrne   r4, \code\()_tabled + 1
    .endif
    str     r4, [sp, #.LF_CODE]
    str     r4, [sp, #.LF_FULL]
    b       .Lrow_alone
    .endm

    .type   HOLES, %function
    .thumb_func

/* r0: face, r1: row, r2: x0, r3: x1, on the stack: depths */
HOLES:
    push    {r4-r11, lr}
    sub     sp, #.LF_SIZE
    adr     r4, .Lreturn + 1
    strd    r4, r1, [sp, #.LF_DONE]
    bl      .Lprepare
    ldr     r4, [sp, #(.LF_SIZE + 36)]
    ldm     r4, {r7-r10}                /* step, cells, code, or_equal */
    ldr     r5, [sp, #(.LF_COLUMN + 4)]
    orr     r5, r5, r10, lsl #16        /* a shift is the lowest byte */
    str     r5, [sp, #(.LF_COLUMN + 4)]
    ldr     r4, [sp, #.LF_ROW]
    ldrd    r5, r11, [r4, #PAINT_ROW_PIXELS] /* and y */
    .if     WIDE
    str     r7, [sp, #.LF_TABLE]
    sub     r8, r8, r5
    lsr     r5, r5, #1
    .else
    str     r7, [sp, #.LF_HOLES_STEP]
    sub     r8, r8, r5, lsl #1
    .endif
    mls     r9, r7, r5, r9
    add     r9, r9, r7
    strd    r8, r9, [sp, #.LF_HOLES]
    ldrb    r4, [r0, #SEGMENT_FACE_KIND]
    cmp     r4, #1
    beq     1f
    mov     r6, r3
    mov     r3, r11
    ldr     r10, [sp, #.LF_OWN]
    find_pattern
    mov     r3, r6
    rsb     r5, r5, #0
    and     r5, r5, #3
    lsr     r10, r10, r5                /* bit i: of addresses that are i, modulo 4 pixels */
    str     r10, [sp, #.LF_OWN]
    hole_code .Lstippled_hole
1:  hole_code .Lkeyed_hole

/* A pixel that is hidden takes 6 instructions. */
    .macro  test_hole i
    ldrh.w  r9, [r12, #(2 * \i)]
    sub.w   r9, r9, r8, lsr #16         /* or_equal */
    cmp.w   r9, lr, lsr #16
    bge.n   1f
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
    ldr.w   r9, [sp, #(.LF_HOLES_STEP + F_HELD)]
    add     lr, r9
    .endif
    .endm

    .macro  begin_holes
    begin_special 1
    leave_special 1
    ldrd    r12, lr, [sp, #(.LF_HOLES + F_HELD)]
    .if     WIDE
    add     r9, r3, pixels, lsr #1
    add     r12, r12, pixels
    mla     lr, r9, r6, lr
    .else
    ldr     r10, [sp, #(.LF_HOLES_STEP + F_HELD)]
    add     r9, r3, pixels
    add     r12, r12, pixels, lsl #1
    mla     lr, r9, r10, lr
    .endif
    ldr     r10, [sp, #(.LF_OWN + F_HELD)]
    .endm

    .macro  keyed_hole label, tabled, bytes
    .align  2
.Lkeyed_hole\label:
    begin_holes
    go_special .Lkeyed_hole_pixels\label, \bytes
    .align  2
.Lkeyed_hole_pixels\label:
    .irp i, 1, 2, 3, 4
    test_hole \i
    find_special
    load_special
    cmp     r3, r10
    beq.n   1f
    keep_hole \tabled, \i
1:  next_hole
    .endr
    check_bytes .Lkeyed_hole_pixels\label, \bytes
    end_special 1, .Lkeyed_hole_pixels\label
    .endm

    .macro  stippled_hole label, tabled, bytes
    .align  2
.Lstippled_hole\label:
    begin_holes
    ubfx    r9, pixels, #WIDE, #2
    lsr     r10, r10, r9
    go_special .Lstippled_hole_pixels\label, \bytes
    .align  2
.Lstippled_hole_pixels\label:
    .irp i, 1, 2, 3, 4
    tst     r10, #(1 << (\i & 3))
    beq.n   1f
    test_hole \i
    find_special
    load_special
    keep_hole \tabled, \i
1:  next_hole
    .endr
    check_bytes .Lstippled_hole_pixels\label, \bytes
    end_special 1, .Lstippled_hole_pixels\label
    .endm

    .if     WIDE
    keyed_hole , 0, 50
    stippled_hole , 0, 52
    .else
    keyed_hole , 0, 54
    stippled_hole , 0, 56
    keyed_hole _tabled, 1, 58
    stippled_hole _tabled, 1, 60
    .endif

/* clang-format on */

#endif
