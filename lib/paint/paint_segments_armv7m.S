/* SPDX-License-Identifier: MIT */
/* fxl_paint_segments for Armv7-M and Armv8-M Mainline, and all of it for faces without light.
 * lib/paint/segments.h states what it requires and does. A texel takes 5 instructions if
 * the texture is 32 to 256 texels wide and no higher than wide; any other takes 9. A segment takes
 * 43 more, or 27 if the weight is constant. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV7M

/* The frame: a copy of the face's first ten words, then: */
#define COPIED       40
#define FRAME_TEXELS SEGMENT_FACE_TEXELS
#define FRAME_GO     40
#define FRAME_FULL   44
#define FRAME_BEFORE 52
#define FRAME_NEXT   56 /* what goes on to the next segment; then the same, where there is one */
#define FRAME_LAST   64
#define FRAME_SKIP   72
#define DROPS        76 /* where the weight is constant: those of U and V less its leading zeros */
#define FRAME_COLUMN 84
#define FRAME        92
#define WHOLE        228 /* bytes of the code of a whole segment */
#include "segments_armv7m.h"

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

/* What remains of the weight where it is constant. */
last    .req r6     /* FRAME_LAST */
inverse .req r7

    .section .text.fxl_paint_segments, "ax", %progbits
    .global fxl_paint_segments
    .type fxl_paint_segments, %function
    .thumb_func

/* The position and the step of a segment. r2: U, r4: V at its end. Goes on to its pixels. */
    .macro  paint_between
    ubfx    p, v_0, #4, #16
    lsr     r3, u_0, #4
    add     p, p, r3, lsl #16
    sub     r3, r2, u_0
    sub     r5, r4, v_0
    mov     u_0, r2
    mov     v_0, r4
    adds    r3, #128
    adds    r5, #128
    asrs    r3, r3, #8
    sbfx    r5, r5, #8, #16
    add     step, r5, r3, lsl #16
    ldrd    texels, mask, [sp, #FRAME_TEXELS]
    ldr     pc, [sp, #FRAME_GO]
    .endm

/* r0: face, r1: row, r2: x0, r3: x1 */
fxl_paint_segments:
    ldr     r12, [r0, #SEGMENT_FACE_RAMP]
    cmp     r12, #0
    bne     fxl_paint_lit_segments
    push    {r4-r11, lr}
    mov     r12, r2
    mov     lr, r3
    ldm     r0, {r2-r11}
    sub     sp, #FRAME - COPIED
    push    {r2-r11}

    /* The row's values at the first segment: the steps times its number. */
    lsr     r8, r12, #4
    umull   v_low, v, r6, r8
    mla     v, r7, r8, v
    umull   w_low, w, r2, r8
    mla     w, r3, r8, w
    mov     r9, r8
    umull   u_low, r2, r4, r9
    mla     u, r5, r9, r2
    ldm     r1, {r2-r5}
    adds    w_low, w_low, r2
    adcs    w, w, r3
    adds    u_low, u_low, r4
    adc     u, u, r5
    ldrd    r2, r3, [r1, #PAINT_ROW_V]
    adds    v_low, v_low, r2
    adc     v, v, r3

    choose_code 14, WHOLE
    ldrb    r4, [r0, #SEGMENT_FACE_IS_CONSTANT]
    begin_pixels r12, lr
    mvn     r3, #0x80000000
    reciprocal r3, r1, w, r3, r2, r5
    cmp     r4, #0
    bne     .Lkeep_inverse
.Lvary:
    adr     r4, .Lsegment + 1
    adr     r5, .Lresume + 1
    strd    r4, r5, [sp, #FRAME_NEXT]
    ldrd    r4, r5, [sp, #SEGMENT_FACE_U_DROP]
    subs    r4, r4, r1
    subs    r5, r5, r1
    orrs    r2, r4, r5
    bmi     .Lfar_start
    smull   r1, u_0, u, r3
    asr     u_0, u_0, r4
    smull   r1, v_0, v, r3
    asr     v_0, v_0, r5

    /* The end of the next segment. */
.Lresume:
    ldm     sp, {r1-r5}
    adds    w_low, w_low, r1
    adcs    w, w, r2
    adds    u_low, u_low, r3
    adc     u, u, r4
    adds    v_low, v_low, r5
    ldr     r5, [sp, #SEGMENT_FACE_V_STEP + 4]
    adc     v, v, r5
    mvn     r3, #0x80000000
    reciprocal r3, r1, w, r3, r2, r5
    ldrd    r4, r5, [sp, #SEGMENT_FACE_U_DROP]
    subs    r4, r4, r1
    subs    r5, r5, r1
    orrs    r2, r4, r5
    bmi     .Lfar
    smull   r1, r2, u, r3
    asrs    r2, r2, r4
    smull   r1, r4, v, r3
    asrs    r4, r4, r5
    paint_between

    .align  2
.Lsegment:
    ldr     r3, [sp, #FRAME_LAST]
    cmp     pixels, r3
    bls     .Lresume

    /* Less than a segment is left, or nothing. */
.Lrest:
    begin_rest
    ldr     pc, [sp, #FRAME_NEXT + 4]
.Lend:
    add     sp, #FRAME
    pop     {r4-r11, pc}

    /* The weight is constant. If its drops are far, it is one that varies by 0. */
.Lkeep_inverse:
    ldrd    r4, r5, [sp, #SEGMENT_FACE_U_DROP]
    subs    r4, r4, r1
    subs    r5, r5, r1
    orrs    r2, r4, r5
    bmi     .Lvary
    strd    r4, r5, [sp, #DROPS]
    mov     inverse, r3
    ldr     last, [sp, #FRAME_LAST]
    adr     r1, .Lconstant + 1
    adr     r2, .Lconstant_resume + 1
    strd    r1, r2, [sp, #FRAME_NEXT]
    smull   r1, u_0, u, inverse
    asr     u_0, u_0, r4
    smull   r1, v_0, v, inverse
    asr     v_0, v_0, r5
    b       .Lconstant_resume

    .align  2
.Lconstant:
    cmp     pixels, last
    bhi     .Lrest
    .align  2
.Lconstant_resume:
    ldrd    r1, r2, [sp, #SEGMENT_FACE_U_STEP]
    adds    u_low, u_low, r1
    adc     u, u, r2
    ldrd    r1, r2, [sp, #SEGMENT_FACE_V_STEP]
    adds    v_low, v_low, r1
    adc     v, v, r2
    ldrd    r4, r5, [sp, #DROPS]
    smull   r1, r2, u, inverse
    asr     r2, r2, r4
    smull   r1, r4, v, inverse
    asr     r4, r4, r5
    paint_between

    .align  2
.Lpartial:
    find_partial r5, r4
    mov     r5, r4
    go_partial r5

    /* Fewer leading zeros in a drop: some bits come from the lower word. */
.Lfar_start:
    smull   r1, r2, u, r3
    shift_down r2, r1, r4
    smull   r1, r4, v, r3
    shift_down r4, r1, r5
    mov     u_0, r2
    mov     v_0, r4
    b       .Lresume
.Lfar:
    smull   r1, r2, u, r3
    shift_down r2, r1, r4
    smull   r1, r4, v, r3
    shift_down r4, r1, r5
    paint_between

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
    ldr     pc, [sp, #FRAME_NEXT]

    /* 14 bytes a pixel, and less for the last one, which no pixel follows. */
    .macro  whole log
.Lpixels_\log:
    .irp    i, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16
    texel_offset r3, mask, p, \log
    ldrb    r3, [texels, r3]
    .if     \i < 16
    strb    r3, [pixels, #\i]
    add     p, step
    .else
    strb    r3, [pixels, #\i]!
    .endif
    .endr
    ldr     pc, [sp, #FRAME_NEXT]
    .endm
    whole_of_each_size

    .size fxl_paint_segments, . - fxl_paint_segments

#endif
