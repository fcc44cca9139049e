/* SPDX-License-Identifier: MIT */
/* The text of fxl_draw_smooth_outline_8 and fxl_draw_smooth_outline_16 for Armv7-M and Armv8-M
 * Mainline. lib/paint/smooth_outline.h states what they require and do; their pixels are those of
 * paint_lights in paint_pixels.c and paint_rgb565.c. A file defines PIXEL_BITS, and includes this
 * one right after the label of its function. A row takes 38 instructions before its pixels, a
 * visible pixel 14, of 16 bits 18, and a hidden one 8. */
#include "../math/family.h"
#include "../math/offsets.h"
#include "../raster/draw_frame_armv7m.h"
#include "cell_edges_armv7m.h"

/* At the first row, r6: its words, less the change from row to row. */
    .macro begin_filling
    test_clear SMOOTH_OUTLINE_CELLS
    ldm     r3, {r4, r5, r8, r10}
    mla     r4, r5, r6, r4
    mla     r10, r8, r6, r10
    str     r4, [r3, #SMOOTH_OUTLINE_CODE]
    str     r10, [r3, #SMOOTH_OUTLINE_LIGHT]
    .endm

    .macro fill_rows
    b       .Lrow
    .endm

#define OUTLINE_OF_ROW (FRAME_OUTLINE + 36) /* below what a row keeps: r4-r12 */

/* The pixel of r4 is tested: r3: its code. Goes to .Lhidden\text, or keeps the code. */
    .macro  test_pixel text
    lsr     r1, r3, #16
    test_code \text
    .endm

/* r1: the code of the cell. */
    .macro  test_code text
    ldrh    r0, [r4], #2
    cmp     r1, r0
    bls     .Lhidden\text
    strh    r1, [r4, #-2]
    .endm

/* The same where codes may have a border. */
    .macro  test_bent_pixel text
    ldr     r1, [sp, #OUTLINE_OF_ROW]
    ldr     r1, [r1, #SMOOTH_OUTLINE_BORDER]
    subs    r1, r3, r1
    ite     lo
    addlo   r1, r1, r3
    movhs   r1, r3
    lsr     r1, r1, #16
    test_code \text
    .endm

/* On to the next pixel, whose cell is that of r4; r6, r7: light, along. */
    .macro  next_pixel text
.Lhidden\text:
    add     r3, r3, lr
    add     r6, r6, r7
#if PIXEL_BITS == 8
    adds    r5, r5, #1
#endif
    cmp     r4, r2
    blo     .Lpixel\text
    .endm

#if PIXEL_BITS == 16

/* light: not below 0; r8: the part of a level, r9-r12: the mixture. */
    .macro  paint_light light
    umull   r1, r0, \light, r8
    mla     r1, r10, r0, r9
    mla     r0, r12, r0, r11
    lsr     r0, r0, #13
    bfi     r1, r0, #13, #6         /* green above blue */
    lsr     r0, r1, #27
    lsr     r1, r1, #8
    bfi     r1, r0, #11, #5
    strh    r1, [r4, r5]
    .endm

#endif

#include "../raster/outline_armv7m.h"

    return_not_clear

    /* The right edge is not right of the left one. */
.Lno_pixel:
    beq     .Lempty
    mov     r2, r8
    rsb     r0, r0, #0
    b       .Lspan
.Lempty:
    step_edges
    ldr     r1, [sp, #FRAME_OUTLINE]
    ldrd    r0, r2, [r1, #SMOOTH_OUTLINE_CODE]
    ldrd    r3, lr, [r1, #SMOOTH_OUTLINE_DOWN]
    add     r0, r0, r2
    add     lr, lr, r3
    str     r0, [r1, #SMOOTH_OUTLINE_CODE]
    str     lr, [r1, #SMOOTH_OUTLINE_LIGHT]
    b       .Lnext_row

.Lrow_done:
    pop     {r4-r12}
.Lnext_row:
    subs    r12, r12, #1
    bmi     .Lrows_below
.Lrow:
    mov     r2, r4
    subs    r0, r8, r4
    ble     .Lno_pixel
.Lspan:                             /* r0: pixels, r2: the first cell */
    ldr     r1, [sp, #FRAME_OUTLINE]
    step_edges
    push    {r4-r12}                /* no call is below */
#if PIXEL_BITS == 16
    ldm     r1, {r3-r12}            /* code, its change, that of light, light, along, by, mixture */
#else
    ldm     r1, {r3-r8}
    ldr     r9, [r1, #SMOOTH_OUTLINE_LAST]
#endif
    add     r3, r3, r4
    add     r6, r6, r5
    str     r3, [r1, #SMOOTH_OUTLINE_CODE]
    str     r6, [r1, #SMOOTH_OUTLINE_LIGHT]
    ldrd    r4, r5, [r1, #SMOOTH_OUTLINE_CELLS]
    ldrd    lr, r1, [r1, #SMOOTH_OUTLINE_CODE_ALONG]
    mla     r3, lr, r2, r3
    add     r4, r4, r2, lsl #1
    mla     r6, r7, r2, r6
    add     r2, r4, r0, lsl #1
#if PIXEL_BITS == 8
    add     r5, r5, r4, lsr #1
#endif
    /* Light is linear: where that of both ends is of the ramp, all is. Codes that
     * have a border are tested by the loop of other light. */
    subs    r0, r0, #1
    mla     r0, r7, r0, r6
    cmp     r6, r1
    it      lo
    cmplo   r0, r1
    bhs     .Lpixel_held

#if PIXEL_BITS == 16
.Lpixel:
    test_pixel
    paint_light r6
    next_pixel
    b       .Lrow_done

.Lpixel_held:
    test_bent_pixel _held
    ldr     r1, [sp, #OUTLINE_OF_ROW]
    ldr     r1, [r1, #SMOOTH_OUTLINE_LAST]
    bic     r0, r6, r6, asr #31
    cmp     r0, r1
    it      gt
    movgt   r0, r1
    paint_light r0
    next_pixel _held
    b       .Lrow_done
#else
.Lpixel:
    test_pixel
    lsr     r0, r6, #24
    add     r0, r8, r0, lsl #8
    ldrb    r0, [r0]
    strb    r0, [r5]
    next_pixel
    b       .Lrow_done

.Lpixel_held:
    test_bent_pixel _held
    asr     r0, r6, #24
    bic     r0, r0, r0, asr #31
    cmp     r0, r9
    it      gt
    movgt   r0, r9
    add     r0, r8, r0, lsl #8
    ldrb    r0, [r0]
    strb    r0, [r5]
    next_pixel _held
    b       .Lrow_done
#endif
