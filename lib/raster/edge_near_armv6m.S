/* SPDX-License-Identifier: MIT */
/* fxl_edge_set_near and fxl_scan_begin_edge for Armv6-M. The arithmetic, with its bounds, is that of
 * lib/raster/edge_divide.h and lib/raster/edge_divide.h. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV6M


    .syntax unified
    .thumb

/* Offsets on the stack; above these are r4 to r7 and lr. */
#define START       0       /* top.x - 1/2 */
#define LAST        4
#define EDGE        8

height      .req r4         /* 2^16 to 2^26 - 1 */
reciprocal  .req r5
shift       .req r6
dx          .req r12

/* Makes an estimate exact: while the rest r0 is not within 0..height - 1, it moves by the height
 * and the quotient by one. */
    .macro  settle quotient
1:  cmp     r0, height
    blo     3f
    bpl     2f
    adds    r0, r0, height                  /* below 0: the estimate was too large */
    subs    \quotient, \quotient, #1
    b       1b
2:  subs    r0, r0, height
    adds    \quotient, \quotient, #1
    b       1b
3:
    .endm

/* r2: the next 16 bits of the quotient; r0 becomes the rest. Overwrites r3. */
    .macro  digit
    movs    r2, r0
    lsls    r2, r2, shift
    lsrs    r2, r2, #16
    muls    r2, reciprocal
    lsrs    r2, r2, #15
    lsls    r0, r0, #16
    movs    r3, r2
    muls    r3, height
    subs    r0, r0, r3
    settle  r2
    .endm

/* Adds the value's zeros above its highest 1 to shift: `count` of them, if there are as many. */
    .macro  skip_zeros count
    lsrs    r0, r1, #32 - \count
    bne     1f
    lsls    r1, r1, #\count
    adds    shift, shift, #\count
1:
    .endm

    .section .text.fxl_edge_set_near, "ax", %progbits

/* place fill-rule: the first column of an edge in a row, for Armv6-M */
/* fxl_edge_divide. Input: r0: the dividend. Results: r1: whole, r2: fraction. Overwrites r0, r3
 * and r7. */
    .type divide, %function
    .thumb_func
divide:
    asrs    r7, r0, #31
    eors    r0, r0, r7
    subs    r0, r0, r7
    movs    r1, #0
    cmp     r0, height
    blo     .Lsign
    movs    r2, #35
    subs    r2, r2, shift
    lsrs    r1, r0, #12
    muls    r1, reciprocal
    lsrs    r1, r1, r2
    movs    r2, r1
    muls    r2, height
    subs    r0, r0, r2
    settle  r1
.Lsign:
    cmp     r7, #0
    beq     .Ldigits
    negs    r1, r1
    cmp     r0, #0
    beq     .Ldigits
    subs    r1, r1, #1
    subs    r0, height, r0
.Ldigits:
    digit
    lsls    r7, r2, #16
    digit
    orrs    r2, r2, r7
    movs    r3, #0
    adds    r2, r2, #1
    adcs    r1, r1, r3
    bx      lr
    .size divide, . - divide

    .global fxl_edge_set_near
    .type fxl_edge_set_near, %function
    .thumb_func

/* r0: top, r1: bottom, r2: last, r3: edge */
fxl_edge_set_near:
    push    {r1-r7, lr}
    ldm     r0!, {r6, r7}
    ldm     r1!, {r3, height}
    subs    height, height, r7
    subs    r3, r3, r6
    mov     dx, r3
    movs    r5, #1
    lsls    r5, r5, #15
    subs    r6, r6, r5
    str     r6, [sp, #START]
    subs    r7, r5, r7
    uxth    r7, r7                          /* t */
    uxth    r0, r6                          /* part */
    uxth    r1, height
    muls    r1, r0                          /* a */
    lsrs    r2, height, #16
    muls    r2, r0
    uxth    r0, r3
    muls    r0, r7                          /* b */
    asrs    r3, r3, #16
    muls    r3, r7
    adds    r2, r2, r3
    lsrs    r3, r1, #16
    adds    r2, r2, r3
    lsrs    r3, r0, #16
    adds    r2, r2, r3
    uxth    r1, r1
    uxth    r0, r0
    adds    r1, r1, r0
    subs    r1, r1, #1
    asrs    r1, r1, #16
    adds    r2, r2, r1                      /* the first row's dividend */

    lsls    r1, height, #6
    movs    shift, #6
    skip_zeros 8
    skip_zeros 4
    skip_zeros 2
    skip_zeros 1
    ldr     r0, [sp, #LAST]
    lsrs    r0, r0, shift
    bne     .Lfar
    lsrs    r0, r1, #24                     /* 128 to 255 */
    ldr     r7, =reciprocals - 128
    ldrb    r5, [r7, r0]
    lsls    r5, r5, #8
    lsrs    r1, r1, #16
    muls    r1, r5
    movs    r7, #1
    lsls    r7, r7, #31
    subs    r7, r7, r1
    asrs    r7, r7, #9
    muls    r7, r5
    asrs    r7, r7, #22
    adds    r5, r5, r7

    movs    r0, r2
    bl      divide
    ldr     r0, [sp, #START]
    asrs    r0, r0, #16
    adds    r0, r0, #1
    adds    r1, r1, r0
    ldr     r3, [sp, #EDGE]
    stm     r3!, {r1, r2}
    str     r3, [sp, #EDGE]
    mov     r0, dx
    bl      divide
    ldr     r3, [sp, #EDGE]
    stm     r3!, {r1, r2}
    movs    r0, #1
    pop     {r1-r7, pc}
.Lfar:
    movs    r0, #0
    pop     {r1-r7, pc}

    .pool
    .size fxl_edge_set_near, . - fxl_edge_set_near

    .section .text.fxl_scan_begin_edge, "ax", %progbits
    .global fxl_scan_begin_edge
    .type fxl_scan_begin_edge, %function
    .thumb_func

/* r0: scan, r1: chain, r2: row, r3: edge */
fxl_scan_begin_edge:
    push    {r0-r7, lr}
    ldrb    r4, [r1, #CHAIN_VERTEX]
    ldrb    r5, [r1, #CHAIN_ONWARD]
    ldrb    r6, [r0, #SCAN_COUNT]
    ldr     r7, [r0, #SCAN_POINTS]
    ldr     r3, =32767
1:  lsls    r0, r4, #3
    adds    r4, r4, r5
    cmp     r4, r6
    blo     2f
    subs    r4, r4, r6
2:  lsls    r1, r4, #3
    adds    r1, r1, r7
    ldr     r5, [r1, #SCREEN_POINT_Y]
    adds    r5, r5, r3
    asrs    r5, r5, #16                     /* the row at which the edge ends */
    cmp     r5, r2
    ble     3f
    adds    r0, r0, r7
    ldr     r6, [r0, #SCREEN_POINT_Y]
    adds    r6, r6, r3
    asrs    r6, r6, #16                     /* its first row */
    cmp     r6, r2
    blt     .Lany
    subs    r2, r5, r6
    subs    r2, #1
    beq     .Lany                           /* one row */
    ldr     r3, [sp, #12]
    bl      fxl_edge_set_near
    cmp     r0, #0
    beq     .Lany
    ldr     r1, [sp, #4]
    strh    r5, [r1, #CHAIN_END_ROW]
    strb    r4, [r1, #CHAIN_VERTEX]
    movs    r0, r5
    b       4f
3:  ldr     r5, [sp, #4]                    /* it ends above: the next one */
    ldrb    r5, [r5, #CHAIN_ONWARD]
    b       1b
.Lany:
    mov     r4, sp
    ldm     r4!, {r0-r3}
    bl      fxl_scan_begin_any_edge
    ldr     r1, [sp, #4]
    movs    r0, #CHAIN_END_ROW
    ldrsh   r0, [r1, r0]
4:  add     sp, #16
    pop     {r4-r7, pc}

    .pool
    .size fxl_scan_begin_edge, . - fxl_scan_begin_edge

/* fxl_edge_reciprocals of edge_divide.h. */
    .section .rodata.edge_reciprocals, "a", %progbits
reciprocals:
    .byte   255, 253, 251, 249, 247, 245, 244, 242, 240, 238, 237, 235, 233, 232, 230, 228
    .byte   227, 225, 224, 222, 221, 219, 218, 216, 215, 213, 212, 211, 209, 208, 207, 205
    .byte   204, 203, 202, 200, 199, 198, 197, 196, 194, 193, 192, 191, 190, 189, 188, 187
    .byte   186, 185, 184, 183, 182, 181, 180, 179, 178, 177, 176, 175, 174, 173, 172, 171
    .byte   170, 169, 168, 168, 167, 166, 165, 164, 163, 163, 162, 161, 160, 159, 159, 158
    .byte   157, 156, 156, 155, 154, 153, 153, 152, 151, 151, 150, 149, 149, 148, 147, 147
    .byte   146, 145, 145, 144, 143, 143, 142, 142, 141, 140, 140, 139, 139, 138, 137, 137
    .byte   136, 136, 135, 135, 134, 133, 133, 132, 132, 131, 131, 130, 130, 129, 129, 128

#endif
