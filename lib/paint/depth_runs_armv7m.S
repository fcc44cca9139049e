/* SPDX-License-Identifier: MIT */
/* fxl_depth_keep_visible and fxl_depth_skip_hidden for Armv7-M and Armv8-M Mainline.
 * lib/paint/depth_cells.h states what they require and do. A visible pixel takes 6 instructions, a
 * hidden one 4, and eight of them 3 more. */
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

    .section .text.fxl_depth_keep_visible, "ax", %progbits
    .global fxl_depth_keep_visible
    .type fxl_depth_keep_visible, %function
    .thumb_func

/* r0: cells, r1: count, r2: code, r3: step; returns the number of visible pixels. */
fxl_depth_keep_visible:
    push    {r4, lr}
    mov     first, cells
    subs    count, count, #8
    blo     .Lkeep_rest
.Lkeep_eight:
    .irp    pixel, 0, 1, 2, 3, 4, 5, 6, 7
    ldrh    cell, [cells]
    lsrs    near, code, #16
    cmp     near, cell
    bls     .Lkeep_end
    strh    near, [cells], #2
    add     code, code, step
    .endr
    subs    count, count, #8
    bhs     .Lkeep_eight
.Lkeep_rest:
    adds    count, count, #8
    beq     .Lkeep_end
.Lkeep_pixel:
    ldrh    cell, [cells]
    lsrs    near, code, #16
    cmp     near, cell
    bls     .Lkeep_end
    strh    near, [cells], #2
    add     code, code, step
    subs    count, count, #1
    bne     .Lkeep_pixel
.Lkeep_end:
    sub     r0, cells, first
    lsrs    r0, r0, #1
    pop     {r4, pc}

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
