/* SPDX-License-Identifier: MIT */
/* fxl_paint_depth_sheet_8 and fxl_paint_depth_sheet_16 for Armv6-M. lib/paint/depth_outline.h states what they
 * require and do. A row takes 32 instructions beside its pixels, a visible pixel 7.
 *
 * Edges are numbers of cells, so a step has the width too, and a code is that of cell 0. All are less 8 cells:
 * the eight pixels that end at an edge begin there. */
#include "../math/family.h"
#include "../math/offsets.h"
#include "../math/registers_armv6m.h"

#if FXL_KERNELS_ARMV6M && !FXL_IS_COMPACT

    .syntax unified
    .thumb

/* Offsets on the stack, the next row's first; from LINE to WIDTH as in fxl_depth_sheet. r8 to r11 have the
 * steps of the edges, r12 and lr the code's change a row, r7 the rows of a trapezoid. */
#define EDGES 0
#define LINE  16
#define WORDS 24        /* filling, step, pixels */
#define FIRST 36
#define DOWN  40
#define WIDTH 48
#define SCAN  52
#define EDGE  56
#define ROW   72
#define ROWS  76
#define FRAME 84

/* r0: cells, r1: filling, r3: step, r4: pixels, r5: code. Overwrites r2 and r6. */
    .macro  pixel place, bits
    ldrh    r2, [r0, #2 * \place]
    lsrs    r6, r5, #16
    cmp     r6, r2
    bls     9f
    strh    r6, [r0, #2 * \place]
    .if     \bits == 16
    strh    r1, [r4, #2 * \place]
    .else
    strb    r1, [r4, #\place]
    .endif
9:
    .endm

/* Goes to the edge of a side that crosses row r5, if another one does; r6 becomes its end, if that is less.
 * r4: the scan. Overwrites the other lower registers. */
    .macro  side number, step, step_fraction
    movs    r0, #SCAN_CHAINS + CHAIN_SIZE * \number + CHAIN_END_ROW
    ldrsh   r0, [r4, r0]
    cmp     r0, r5
    bgt     1f
    movs    r0, r4
    movs    r1, r4
    adds    r1, #SCAN_CHAINS + CHAIN_SIZE * \number
    movs    r2, r5
    add     r3, sp, #EDGE
    bl      fxl_scan_begin_edge
    add     r7, sp, #EDGE
    ldm     r7, {r1-r3, r7}
    str     r2, [sp, #EDGES + 8 * \number + 4]
    mov     \step_fraction, r7
    ldr     r2, [sp, #FIRST]
    adds    r1, r1, r2
    str     r1, [sp, #EDGES + 8 * \number]
    ldr     r2, [sp, #WIDTH]
    adds    r3, r3, r2
    mov     \step, r3
1:  cmp     r0, r6
    bge     1f
    movs    r6, r0
1:
    .endm

    .macro  add_row low, high, change_low, change_high
    mov     r6, \change_low
    adds    \low, \low, r6
    mov     r6, \change_high
    adcs    \high, r6
    .endm

    .macro  sheet bits
    .section .text.fxl_paint_depth_sheet_\bits, "ax", %progbits
    .type   fxl_paint_depth_sheet_\bits, %function
    .thumb_func

/* r0: sheet, r1: scan */
fxl_paint_depth_sheet_\bits:
    save_registers
    sub     sp, #FRAME
    str     r1, [sp, #SCAN]
    movs    r2, #SCAN_TRAPEZOID + TRAPEZOID_END_ROW
    ldrsh   r2, [r1, r2]
    str     r2, [sp, #ROW]
    add     r1, sp, #LINE
    ldm     r0!, {r2-r7}
    stm     r1!, {r2-r7}
    ldm     r0!, {r2-r4}
    stm     r1!, {r2-r4}

.Ltrapezoid_\bits:
    ldr     r4, [sp, #SCAN]
    ldr     r5, [sp, #ROW]
    movs    r6, #SCAN_END_ROW
    ldrsh   r6, [r4, r6]
    cmp     r5, r6
    blt     1f
    b       .Ldone_\bits
1:  side    0, r8, r9
    side    1, r10, r11
    str     r6, [sp, #ROW]
    subs    r7, r6, r5
    ldr     r0, [sp, #WIDTH]
    muls    r0, r7
    ldr     r1, [sp, #FIRST]
    adds    r1, r1, r0
    str     r1, [sp, #FIRST]
    ldr     r0, [sp, #DOWN]
    mov     r12, r0
    ldr     r0, [sp, #DOWN + 4]
    mov     lr, r0
    mov     r0, sp
    ldm     r0, {r0-r5}
    add     r6, sp, #WORDS

.Lrow_\bits:
    cmp     r0, r2
    ble     .Lother_\bits
.Lordered_\bits:                        /* r2: the first pixel, r0: the end */
    ldm     r6!, {r1, r3, r4}
    subs    r6, r2, r0
    muls    r2, r3
    adds    r5, r5, r2
    .if     \bits == 8
    adds    r4, r4, r0
    .endif
    lsls    r0, r0, #1
    .if     \bits == 16
    adds    r4, r4, r0
    .endif
    adds    r6, #8
    bmi     .Llong_\bits
.Lshort_\bits:
    movs    r2, #14                     /* bytes of a pixel's instructions */
    muls    r6, r2
    add     pc, r6
    nop
    .irp    place, 0, 1, 2, 3, 4, 5, 6
    pixel   \place, \bits
    adds    r5, r5, r3
    .endr
    pixel   7, \bits
.Lnext_\bits:
    mov     r0, sp
    ldm     r0, {r0-r5}
    add_row r1, r0, r9, r8
    add_row r3, r2, r11, r10
    add_row r4, r5, r12, lr
    mov     r6, sp
    stm     r6!, {r0-r5}
    subs    r7, #1
    bne     .Lrow_\bits
    b       .Ltrapezoid_\bits

.Lother_\bits:
    beq     .Lnext_\bits
    movs    r1, r0
    movs    r0, r2
    movs    r2, r1
    b       .Lordered_\bits

    /* More than 8 pixels: fours, up to the last 5 to 8. */
.Llong_\bits:
    str     r7, [sp, #ROWS]
    movs    r7, r6
    lsls    r6, r6, #1
    adds    r0, r0, r6
    .if     \bits == 8
    adds    r4, r4, r7
    .else
    adds    r4, r4, r6
    .endif
1:  .irp    place, 0, 1, 2, 3
    pixel   \place, \bits
    adds    r5, r5, r3
    .endr
    adds    r0, #8
    adds    r4, #\bits / 2
    adds    r7, #4
    bmi     1b
    movs    r6, r7
    lsls    r2, r7, #1
    subs    r0, r0, r2
    .if     \bits == 8
    subs    r4, r4, r7
    .else
    subs    r4, r4, r2
    .endif
    ldr     r7, [sp, #ROWS]
    b       .Lshort_\bits

.Ldone_\bits:
    add     sp, #FRAME
    restore_and_return

    .size   fxl_paint_depth_sheet_\bits, . - fxl_paint_depth_sheet_\bits
    .endm

    .global fxl_paint_depth_sheet_8
    .global fxl_paint_depth_sheet_16
    sheet   8
    sheet   16

#endif
