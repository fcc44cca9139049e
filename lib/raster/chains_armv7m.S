/* SPDX-License-Identifier: MIT */
/* fxl_scan_next_trapezoid for Armv7-M and Armv8-M Mainline. lib/raster/scan.h
 * states what it requires and returns; it gives the same bits as
 * lib/raster/scan.c. The arithmetic, with its bounds, is that of
 * lib/raster/edge.h and lib/raster/edge_divide.h. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV7M && FXL_SCANS_BY_CHAINS


    .syntax unified
    .thumb

/* Offsets in fxl_scan. */
#define VERTEX      (SCAN_CHAINS + CHAIN_VERTEX) /* of chain 0; chain 1 is CHAIN_SIZE further on */
#define ONWARD      (SCAN_CHAINS + CHAIN_ONWARD)
#define CHAIN_END   (SCAN_CHAINS + CHAIN_END_ROW)
#define FIRST_ROW   (SCAN_TRAPEZOID + TRAPEZOID_FIRST_ROW)
#define LAST_END    (SCAN_TRAPEZOID + TRAPEZOID_END_ROW)
#define EDGES       (SCAN_TRAPEZOID + TRAPEZOID_EDGES)

    .section .text.fxl_scan_next_trapezoid, "ax", %progbits
    .global fxl_scan_next_trapezoid
    .type fxl_scan_next_trapezoid, %function
    .thumb_func

/* place fill-rule: outlines and rows for Armv7-M; half a pixel is a number here */
/* Input: r0: scan. In the loop over the two sides, r2: the least end row so far, r3: scan + 4
 * times the side, lr: the y of the row's centres in 16.16. */
fxl_scan_next_trapezoid:
    ldrsh   r1, [r0, #LAST_END]
    ldrsh   r2, [r0, #SCAN_END_ROW]
    cmp     r1, r2
    bge     .Lnone
    push    {r3-r11, lr}
    lsl     lr, r1, #16
    add     lr, lr, #32768
    mov     r3, r0
.Lside:
    ldrsh   r5, [r3, #CHAIN_END]
    cmp     r5, lr, asr #16
    ble     .Lbegin
    ldrsh   r6, [r0, #FIRST_ROW]
    rsb     r6, r6, lr, asr #16
.Ladvance:                          /* moves the edge down by r6 rows */
    sub     r7, r3, r0
    add     r7, r0, r7, lsl #2
    ldrd    r8, r9, [r7, #EDGES]
    ldrd    r10, r11, [r7, #EDGES + EDGE_STEP]
    mla     r8, r10, r6, r8
    movs    r4, #0
    umlal   r9, r4, r11, r6
    add     r8, r8, r4
    strd    r8, r9, [r7, #EDGES]
.Lside_done:
    cmp     r5, r2
    it      lt
    movlt   r2, r5
    cmp     r3, r0
    bne     .Lready
    adds    r3, r3, #CHAIN_SIZE
    b       .Lside
.Lready:
    asr     lr, lr, #16
    strh    lr, [r0, #FIRST_ROW]
    strh    r2, [r0, #LAST_END]
    adds    r0, r0, #FIRST_ROW
    pop     {r3-r11, pc}
.Lnone:
    ldrb    r1, [r0, #SCAN_BY_CHAINS]
    cbz     r1, .Lactive_edges
    movs    r0, #0
    bx      lr
.Lactive_edges:
    b.w     fxl_scan_next_of_active_edges

    /* Down the chain to the edge that ends below the row's centre. */
.Lbegin:
    ldrb    r6, [r3, #VERTEX]
    ldrb    r7, [r3, #ONWARD]
    ldrb    r1, [r0, #SCAN_COUNT]
    ldr     r9, [r0, #SCAN_POINTS]
    b       .Ltest_edge
.Lnext_edge:
    mov     r6, r10
.Ltest_edge:
    add     r10, r6, r7
    cmp     r10, r1
    it      hs
    subhs   r10, r10, r1
    add     r8, r9, r10, lsl #3
    ldrd    r11, r12, [r8]
    cmp     r12, lr
    ble     .Lnext_edge
    strb    r10, [r3, #VERTEX]
    sub     r12, r12, #1
    add     r5, r12, #32768
    asr     r5, r5, #16             /* the edge's end row */
    strh    r5, [r3, #CHAIN_END]
    add     r9, r9, r6, lsl #3
    ldrd    r6, r7, [r9]
    sub     r10, r12, r7
    adds    r10, r10, #1            /* height; no carry */
    sub     r11, r11, r6            /* dx */
    sub     r7, lr, r7              /* the centre less the top: whole rows, and t */
    clz     r1, r10
    sbc     r12, r5, lr, asr #16
    adds    r12, r12, r7, lsr #16   /* the edge's rows above this one and from it on, less 1 */
    beq     .Lone_row
    lsrs    r12, r12, r1            /* not 0: more rows than the edge holds for */
    bne     .Lset_far
    uxth    r12, r7
    lsrs    r7, r7, #16
    orr     r8, r1, r7, lsl #8      /* rows above; lowest byte: shift (shifts read this byte) */
    smull   r4, r5, r11, r12
    sub     r6, r6, #32768          /* start */
    uxth    r12, r6
    umlal   r4, r5, r12, r10
    subs    r4, r4, #1
    sbc     r5, r5, #0
    lsrs    r4, r4, #16
    lsls    r4, r4, #2
    orr     r4, r4, r5, lsl #18     /* the first row's dividend times four */

    lsl     r12, r10, r8
    mvn     r1, #0x8000
    lsr     r9, r12, #16
    udiv    r9, r1, r9
    lsl     r9, r9, #15
    umull   r1, r5, r9, r12
    negs    r5, r5
    umull   r1, r9, r9, r5          /* the reciprocal */
    mov     r12, #0x80000000
    rsb     r5, r8, #32
    lsr     r12, r12, r5
    sub     r12, r12, #1            /* 2^(shift - 1) - 1 */

/* Input: r4: the dividend times four, r12: as above. Results: \whole, and r1: the fraction, whose
 * carry the caller adds to \whole. */
    .macro  divide whole
    smull   r1, \whole, r4, r9
    lsl     r7, \whole, r8
    lsr     r1, r1, r5
    orrs    r1, r1, r7
    asr     \whole, \whole, r5
    subs    r1, r1, r12
    sbc     \whole, \whole, #0
    mls     r7, r1, r10, r10        /* the rest of the dividend, with half added */
    udiv    r7, r7, r10
    adds    r1, r1, r7
    .endm

    divide  r4
    adc     r4, r4, r6, asr #16
    adds    r4, r4, #1
    sub     r7, r3, r0
    add     r6, r0, r7, lsl #2
    strd    r4, r1, [r6, #EDGES]
    lsl     r4, r11, #2
    divide  r4
    adc     r4, r4, #0
    strd    r4, r1, [r6, #EDGES + EDGE_STEP]
    ldrsh   r5, [r3, #CHAIN_END]
    lsrs    r6, r8, #8
    beq     .Lside_done
    b       .Ladvance

    /* The edge crosses only this row: compute its first pixel, and no step. */
.Lone_row:
    smull   r4, r8, r11, r7
    sub     r6, r6, #32768          /* start */
    uxth    r12, r6
    umlal   r4, r8, r12, r10
    subs    r4, r4, #1
    sbc     r8, r8, #0
    lsrs    r4, r4, #16
    orr     r4, r4, r8, lsl #16     /* the dividend */
    sdiv    r8, r4, r10
    mls     r4, r8, r10, r4
    add     r8, r8, r4, asr #31     /* downward */
    movs    r1, #1
    add     r4, r1, r6, asr #16
    add     r4, r4, r8
    movs    r1, #0
    sub     r7, r3, r0
    add     r6, r0, r7, lsl #2
    strd    r4, r1, [r6, #EDGES]
    strd    r1, r1, [r6, #EDGES + EDGE_STEP]
    b       .Lside_done

    /* Start the edge from its exact remainder. r8: bottom, r9: top, r5: end row. */
.Lset_far:
    push    {r0, r2, r3, lr}
    sub     r7, r3, r0
    add     r7, r0, r7, lsl #2
    add     r7, r7, #EDGES
    str     r7, [sp, #-8]!
    asr     r2, lr, #16
    subs    r3, r5, r2
    mov     r0, r9
    mov     r1, r8
    bl      fxl_edge_set_far
    mov     r7, r0
    add     sp, sp, #8
    pop     {r0, r2, r3, lr}
    add     r7, r7, lr, asr #16
    cmp     r7, r5
    beq     .Lside_done
    mov     r5, r7                  /* the same edge is set again from that row on */
    strh    r5, [r3, #CHAIN_END]
    ldr     r6, [r0, #SCAN_POINTS]
    sub     r6, r9, r6
    lsrs    r6, r6, #3
    strb    r6, [r3, #VERTEX]
    b       .Lside_done

    .size fxl_scan_next_trapezoid, . - fxl_scan_next_trapezoid

#endif
