/* SPDX-License-Identifier: MIT */
/* fxl_row_to_16 for Armv6-M. lib/include/fixel/pixels.h states what it requires and does.
 * Pixels are loaded 16 at a time. If all 16 have one colour, they take 21 instructions; others take
 * 72 or a few more. Noise of 320 pixels a row takes 4.6 instructions a pixel. */
#include "../math/family.h"

#if FXL_KERNELS_ARMV6M


    .syntax unified
    .thumb

pixels  .req r0
limit   .req r1     /* the last address at which 16 pixels may begin */
table   .req r2
out     .req r3
run     .req r8     /* the pixel of the last run, in each of four bytes */
colour  .req r9     /* of that run, twice */

    .section .text.fxl_row_to_16, "ax", %progbits
    .global fxl_row_to_16
    .type fxl_row_to_16, %function
    .thumb_func

/* r0: pixels, r1: count, r2: table, r3: out. Below the pixels lie at least 16 bytes of memory, so
 * the limit does not pass 0. */
fxl_row_to_16:
    push    {r4-r7, lr}
    mov     r4, run
    mov     r5, colour
    push    {r4, r5}
    adds    limit, pixels
    subs    limit, #16
.Lhead:
    cmp     pixels, limit
    bhi     .Lrest
    lsls    r4, pixels, #30
    beq     .Laligned
    ldrb    r4, [pixels]
    lsls    r4, r4, #1
    ldrh    r4, [table, r4]
    strh    r4, [out]
    adds    pixels, #1
    adds    out, #2
    b       .Lhead
.Laligned:
    lsls    r4, out, #30
    bne     .Lrest
    movs    r4, #1                      /* no run has this word */
    mov     run, r4

.Lblock:
    ldr     r4, [pixels]
    ldr     r5, [pixels, #4]
    cmp     r4, r5
    bne     .Lmixed
    ldr     r5, [pixels, #8]
    cmp     r4, r5
    bne     .Lmixed
    ldr     r5, [pixels, #12]
    cmp     r4, r5
    bne     .Lmixed
    cmp     r4, run
    bne     .Lnew_run
.Lfill:
    mov     r4, colour
    movs    r5, r4
    movs    r6, r4
    movs    r7, r4
    stm     out!, {r4-r7}
    stm     out!, {r4-r7}
    adds    pixels, #16
    cmp     pixels, limit
    bls     .Lblock

    /* Fewer than 16 pixels; all of them where pixels and out are not aligned alike. */
.Lrest:
    adds    limit, #16                  /* the end of the pixels */
    cmp     pixels, limit
    beq     .Lend
.Lpixel:
    ldrb    r4, [pixels]
    lsls    r4, r4, #1
    ldrh    r4, [table, r4]
    strh    r4, [out]
    adds    pixels, #1
    adds    out, #2
    cmp     pixels, limit
    bne     .Lpixel
.Lend:
    pop     {r4, r5}
    mov     run, r4
    mov     colour, r5
    pop     {r4-r7, pc}

    /* All words are r4. They are a run if its four bytes are equal. */
.Lnew_run:
    movs    r5, r4
    movs    r6, #8
    rors    r5, r6
    cmp     r4, r5
    bne     .Lmixed
    mov     run, r4
    uxtb    r4, r4
    lsls    r4, r4, #1
    ldrh    r4, [table, r4]
    lsls    r5, r4, #16
    orrs    r4, r5
    mov     colour, r4
    b       .Lfill

.Lmixed:
    .irp    pixel, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
    ldrb    r4, [pixels, #\pixel]
    lsls    r4, r4, #1
    ldrh    r4, [table, r4]
    strh    r4, [out, #2 * \pixel]
    .endr
    adds    pixels, #16
    adds    out, #32
    cmp     pixels, limit
    bls     .Lblock
    b       .Lrest

    .size fxl_row_to_16, . - fxl_row_to_16

#endif
