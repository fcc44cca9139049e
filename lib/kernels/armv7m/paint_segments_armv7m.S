/* SPDX-License-Identifier: MIT */
/* fxl_paint_segments for Armv7-M and Armv8-M Mainline, and all of it for faces without light.
 * lib/extra/surfaces/segments.h states what it requires and does. A texel takes 5 instructions if
 * the texture is 32 to 256 texels wide and no higher than wide; any other takes 9. A segment takes
 * 46 more, or 31 if the weight is constant. */
#include "../family.h"
#include "../offsets.h"

#if FXL_KERNELS_ARMV7M

/* The frame: a copy of the face's first ten words, then: */
#define COPIED       40
#define FRAME_TEXELS SEGMENT_FACE_TEXELS
#define FRAME_GO     40
#define FRAME_FULL   44
#define FRAME_BEFORE 52
#define FRAME_NEXT   56 /* what goes on to the next segment */
#define FRAME_LAST   60
#define FRAME_SKIP   68
#define INVERSE      72 /* where the weight is constant: its reciprocal; then the drops of U and V
                           less the leading zeros of the weight */
#define FRAME_COLUMN 84
#define FRAME        92
#include "segments.h"

pixels  .req r0
p       .req r1
step    .req r2
texels  .req r4
mask    .req r5
w_low   .req r6     /* what is linear, at the end of the segment */
w       .req r7
u_low   .req r8
u       .req r9
v_low   .req r10
v       .req r11
u_0     .req r12    /* U and V at the beginning of the segment */
v_0     .req lr

    .section .text.fxl_paint_segments, "ax", %progbits
    .global fxl_paint_segments
    .type fxl_paint_segments, %function
    .thumb_func

/* r0: face, r1: start */
fxl_paint_segments:
    ldr     r2, [r0, #SEGMENT_FACE_RAMP]
    cmp     r2, #0
    bne     fxl_paint_lit_segments
    push    {r4-r11, lr}
    ldm     r0, {r2-r11}
    sub     sp, #FRAME - COPIED
    push    {r2-r11}
    choose_code 14
    ldrb    r12, [r0, #SEGMENT_FACE_IS_CONSTANT]
    begin_pixels
    ldm     r1, {w_low, w, u_low, u, v_low, v}
    adr     r2, .Lstarted + 1
    str     r2, [sp, #FRAME_GO]
    reciprocal r3, r1, w, r2, r4, r5
    adr     r2, .Lsegment + 1
    cmp     r12, #0
    beq     .Lvarying
    ldrd    r4, r5, [sp, #SEGMENT_FACE_U_DROP]
    subs    r4, r4, r1
    subs    r5, r5, r1
    add     r12, sp, #INVERSE
    stm     r12, {r3, r4, r5}
    orrs    r4, r4, r5
    it      pl
    adrpl   r2, .Lconstant + 1
.Lvarying:
    str     r2, [sp, #FRAME_NEXT]
    b       .Lattributes

    /* The end of the next segment. */
    .align  2
.Lsegment:
    ldm     sp, {r1-r5}
    adds    w_low, w_low, r1
    adcs    w, w, r2
    adds    u_low, u_low, r3
    adc     u, u, r4
    adds    v_low, v_low, r5
    ldr     r5, [sp, #SEGMENT_FACE_V_STEP + 4]
    adc     v, v, r5
    reciprocal r3, r1, w, r2, r4, r5
.Lattributes:
    ldrd    r4, r5, [sp, #SEGMENT_FACE_U_DROP]
    subs    r4, r4, r1
    subs    r5, r5, r1
    orrs    r2, r4, r5
    bmi     .Lfar
.Lproducts:
    smull   r1, r2, u, r3
    asrs    r2, r2, r4
    smull   r1, r4, v, r3
    asrs    r4, r4, r5
.Lends:                                 /* r2: U, r4: V at the end */
    ubfx    p, v_0, #4, #16
    lsr     r3, u_0, #4
    add     p, p, r3, lsl #16
    sub     r3, r2, u_0
    sub     r5, r4, v_0
    mov     u_0, r2
    mov     v_0, r4
    adds    r3, #128                    /* bug: v7m-segment-round */
    adds    r5, #128
    asrs    r3, r3, #8
    sbfx    r5, r5, #8, #16
    add     step, r5, r3, lsl #16
    ldrd    texels, mask, [sp, #FRAME_TEXELS]
    ldr     pc, [sp, #FRAME_GO]

    /* The same where the weight is constant. */
    .align  2
.Lconstant:
    ldrd    r1, r2, [sp, #SEGMENT_FACE_U_STEP]
    adds    u_low, u_low, r1
    adc     u, u, r2
    ldrd    r1, r2, [sp, #SEGMENT_FACE_V_STEP]
    adds    v_low, v_low, r1
    adc     v, v, r2
    add     r3, sp, #INVERSE
    ldm     r3, {r3-r5}
    b       .Lproducts

    /* Fewer leading zeros in a drop: some bits come from the lower word. */
.Lfar:
    smull   r1, r2, u, r3
    shift_down r2, r1, r4
    smull   r1, r4, v, r3
    shift_down r4, r1, r5
    b       .Lends

    .align  2
.Lstarted:
    start_pixels
    ldr     pc, [sp, #FRAME_NEXT]

    .align  2
.Lpartial:
    find_partial r5, r4
    mov     r5, r4
    go_partial r5

    .align  2
.Lrest:
    begin_rest
    ldr     pc, [sp, #FRAME_NEXT]
.Lend:
    add     sp, #FRAME
    pop     {r4-r11, pc}

    width_table

    .macro  go_on
    ldr     r3, [sp, #FRAME_LAST]
    cmp     pixels, r3
    bhi     .Lrest
    ldr     pc, [sp, #FRAME_NEXT]
    .endm

    /* Any size. */
    .align  2
.Lloop:
    add     r3, sp, #FRAME_COLUMN
    push    {r6-r9}
    ldm     r3, {r6, r7}
    add     r8, pixels, #16
    ldr     r3, [sp, #FRAME_BEFORE + 16]
    add     pixels, r3
    movs    r3, #0
    str     r3, [sp, #FRAME_BEFORE + 16]
.Lpixel:
    lsr     r3, p, r7
    ands    r3, mask
    lsr     r9, p, r6
    add     r3, texels
    ldrb    r3, [r3, r9]
    strb    r3, [pixels, #1]!
    add     p, step
    cmp     pixels, r8
    bne     .Lpixel
    pop     {r6-r9}
    go_on

    /* 14 bytes a pixel. */
    .macro  whole log
    .align  2
.Lpixels_\log:
    .irp    i, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16
    texel_offset r3, mask, p, \log
    ldrb    r3, [texels, r3]
    .if     \i < 16
    strb    r3, [pixels, #\i]
    .else
    strb    r3, [pixels, #\i]!
    .endif
    add     p, step
    .endr
    go_on
    .endm
    whole   5
    whole   6
    whole   7
    whole   8

    .size fxl_paint_segments, . - fxl_paint_segments

#endif
