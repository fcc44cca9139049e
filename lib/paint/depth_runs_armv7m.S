/* SPDX-License-Identifier: MIT */
/* fxl_depth_keep_visible and fxl_depth_skip_hidden for Armv7-M and Armv8-M Mainline.
 * lib/paint/depth_cells.h states what they require and do. A visible pixel takes 3 instructions where
 * nothing was drawn before, and 6 elsewhere; a hidden one 4, and eight of them 3 more. */
#include "../math/family.h"

#if FXL_KERNELS_ARMV7M

    .syntax unified
    .thumb

cells   .req r0     /* of the next pixel */
count   .req r1     /* pixels still to be tested, less 8 */
code    .req r2
step    .req r3
cell    .req r12
first   .req lr     /* the first cell */
near    .req r4
last    .req r8     /* the last cell at which eight pixels begin */

    .section .text.fxl_depth_keep_visible, "ax", %progbits
    .global fxl_depth_keep_visible
    .type fxl_depth_keep_visible, %function
    .thumb_func

/* On to where a pixel is hidden. */
    .macro keep_pixel
    ldrh    cell, [cells]
    lsrs    near, code, #16
    cmp     near, cell
    bls     .Lkeep_end
    strh    near, [cells], #2
    add     code, code, step
    .endm

/* r0: cells, r1: count, r2: code, r3: step; returns the number of visible pixels. From the test of
 * eight pixels on, r1: the end of the cells. */
fxl_depth_keep_visible:
    push    {r4-r8, lr}
    mov     first, cells
    mla     near, step, count, code
    sub     near, near, step        /* the last code */
    add     count, cells, count, lsl #1
    sub     last, count, #16
    cmp     cells, last
    bhi     .Lkeep_rest
    /* Rounded down, a code may be below 1 as the cell of a pixel where nothing was drawn. */
    cmp     code, #65536
    it      hs
    cmphs   near, #65536
    blo     .Lkeep_rest
    tst     cells, #2
    beq     .Lkeep_eight
    keep_pixel
    cmp     cells, last
    bhi     .Lkeep_rest
    /* Where nothing was drawn, all are visible. */
.Lkeep_eight:
    ldm     cells, {r4-r7}
    orr     cell, r4, r5
    orr     cell, cell, r6
    orrs    cell, cell, r7
    bne     .Lkeep_each
    .irp    two, r4, r5, r6, r7
    lsr     cell, code, #16
    add     \two, code, step
    bfi     \two, cell, #0, #16
    add     code, code, step, lsl #1
    .endr
    stm     cells!, {r4-r7}
    cmp     cells, last
    bls     .Lkeep_eight
.Lkeep_rest:
    cmp     cells, count
    bhs     .Lkeep_end
.Lkeep_pixel:
    keep_pixel
    cmp     cells, count
    blo     .Lkeep_pixel
.Lkeep_end:
    sub     r0, cells, first
    lsrs    r0, r0, #1
    pop     {r4-r8, pc}
.Lkeep_each:
    .rept   8
    keep_pixel
    .endr
    cmp     cells, last
    bls     .Lkeep_eight
    b       .Lkeep_rest

    .size fxl_depth_keep_visible, . - fxl_depth_keep_visible

    .section .text.fxl_depth_skip_hidden, "ax", %progbits
    .global fxl_depth_skip_hidden
    .type fxl_depth_skip_hidden, %function
    .thumb_func

/* r0: cells, r1: count, r2: code, r3: step; returns the number of hidden pixels. The first visible
 * pixel is known only once its cell is loaded and passed. */
fxl_depth_skip_hidden:
    push    {r4, lr}
    mov     first, cells
    subs    count, count, #8
    blo     .Lskip_rest
.Lskip_eight:
    .irp    pixel, 0, 1, 2, 3, 4, 5, 6, 7
    ldrh    cell, [cells], #2
    cmp     cell, code, lsr #16
    blo     .Lskip_found
    add     code, code, step
    .endr
    subs    count, count, #8
    bhs     .Lskip_eight
.Lskip_rest:
    adds    count, count, #8
    beq     .Lskip_end
.Lskip_pixel:
    ldrh    cell, [cells], #2
    cmp     cell, code, lsr #16
    blo     .Lskip_found
    add     code, code, step
    subs    count, count, #1
    bne     .Lskip_pixel
.Lskip_end:
    sub     r0, cells, first
    lsrs    r0, r0, #1
    pop     {r4, pc}
.Lskip_found:
    sub     cells, cells, #2
    b       .Lskip_end

    .size fxl_depth_skip_hidden, . - fxl_depth_skip_hidden

#endif
