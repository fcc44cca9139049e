/* SPDX-License-Identifier: MIT */
/* fxl_paint_segments of faces with light, for Armv7-M and Armv8-M Mainline: the other kernel jumps
 * here. A texel takes 8 instructions if the texture is 32 to 256 texels wide and no higher than
 * wide; any other takes 12. A segment takes 47 more. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_TEXELS_IN_ASSEMBLY

/* The frame: weight, u and v at the end of the segment; their steps; the address of the block; the
 * block; U, V and light at the beginning of the segment; a block for one load; then: */
#define STEPS        24
#define BLOCK        52 /* 2^31 - 1, the least drop, the light's upper word, its step and its drop,
                           those of U and V, its most */
#define BLOCK_LIGHT  8
#define BLOCK_BYTES  32
#define LOADED       96 /* texels, mask, ramp, FRAME_LAST, the end, FRAME_GO */
#define FRAME_TEXELS LOADED
#define FRAME_LAST   108
#define FRAME_GO     116
#define FRAME_FULL   120
#define FRAME_BEFORE 128
#define FRAME_SKIP   132
#define FRAME_COLUMN 136
#define FIRST        144 /* what paints the first segment */
#define FRAME        148
#define WHOLE        420 /* bytes of the code of a whole segment */
#include "segments_armv7m.h"

pixels  .req r0
p       .req r1
step    .req r2
texels  .req r4
mask    .req r5
ramp    .req r6
last    .req r7     /* FRAME_LAST */
change  .req r9     /* of light, a pixel */
light   .req r10    /* 1/256 level: of an even pixel */
other   .req r11    /* of an odd one */

/* r2, r4, r7: U, V and light, of the weight in r2, r4: u / z, r6: v / z, and light's upper word in
 * r7. The block is in r3, r5 and r8 to r12. Goes away if a drop has fewer leading zeros. */
    .macro  divide_all far
    reciprocal r3, r1, r2, r3, r2, r8
    cmp     r1, r5
    bgt     \far
    sub     r9, r9, r1
    sub     r10, r10, r1
    sub     r11, r11, r1
    smull   r1, r2, r4, r3
    asr     r2, r2, r10
    smull   r1, r4, r6, r3
    asr     r4, r4, r11
    smull   r1, r7, r7, r3
    asr     r7, r7, r9
    .endm

    .section .text.fxl_paint_lit_segments, "ax", %progbits
    .global fxl_paint_lit_segments
    .type fxl_paint_lit_segments, %function
    .thumb_func

/* r0: face, r1: row, r2: x0, r3: x1 */
fxl_paint_lit_segments:
    push    {r4-r11, lr}
    sub     sp, #FRAME
    mov     r12, r2
    mov     r11, r3
    ldm     r0, {r2-r7}
    add     r8, sp, #STEPS
    stm     r8, {r2-r7}
    add     lr, sp, #BLOCK
    str     lr, [sp, #BLOCK - 4]
    mvn     r2, #0x80000000
    ldr     r3, [r0, #SEGMENT_FACE_DROP_MIN]
    ldr     r4, [r1, #PAINT_ROW_LIGHT]
    ldrd    r5, r6, [r0, #SEGMENT_FACE_LIGHT_STEP]
    ldrd    r7, r8, [r0, #SEGMENT_FACE_U_DROP]
    ldr     r9, [r0, #SEGMENT_FACE_LIGHT_MAX]
    lsr     r10, r12, #4
    mla     r4, r5, r10, r4
    stm     lr, {r2-r9}
    ldrd    r2, r3, [r0, #SEGMENT_FACE_TEXELS]
    ldr     r4, [r0, #SEGMENT_FACE_RAMP]
    add     r6, sp, #LOADED
    stm     r6, {r2-r4}
    choose_code 26, WHOLE
    begin_pixels r12, r11

    /* The row's values at the first segment: the steps times its number. */
    lsr     r12, r12, #4
    ldm     r1, {r1-r6}
    ldrd    r7, r8, [sp, #STEPS]
    umull   r9, r10, r7, r12
    mla     r10, r8, r12, r10
    adds    r1, r1, r9
    adcs    r2, r2, r10
    ldrd    r7, r8, [sp, #STEPS + 8]
    umull   r9, r10, r7, r12
    mla     r10, r8, r12, r10
    adds    r3, r3, r9
    adcs    r4, r4, r10
    ldrd    r7, r8, [sp, #STEPS + 16]
    umull   r9, r10, r7, r12
    mla     r10, r8, r12, r10
    adds    r5, r5, r9
    adc     r6, r6, r10
    stm     sp, {r1-r6}
    ldm     lr!, {r3, r5, r7-r12}
    divide_all .Lbegin_slowly
    cmp     r7, r12
    bhi     .Lbegin_slowly
    stm     lr, {r2, r4, r7}

    /* The end of the next segment. */
    .align  2
.Lsegment:
    ldm     sp, {r1-r12, lr}
    adds    r1, r1, r7
    adcs    r2, r2, r8
    adds    r3, r3, r9
    adcs    r4, r4, r10
    adds    r5, r5, r11
    adc     r6, r6, r12
.Lattributes:                           /* r2: weight, r4: u / z, r6: v / z */
    stm     sp, {r1-r6}
    ldm     lr!, {r3, r5, r7-r12}
    add     r7, r7, r8
    str     r7, [lr, #BLOCK_LIGHT - BLOCK_BYTES]
    divide_all .Lfar
.Lends:                                 /* r2: U, r4: V, r7: light at the end */
    cmp     r7, r12
    bhi     .Lbeyond
.Lwithin:
    ldm     lr, {r8-r10}
    stm     lr!, {r2, r4, r7}
    ubfx    p, r9, #4, #16
    lsr     r3, r8, #4
    add     p, p, r3, lsl #16
    sub     r2, r2, r8
    sub     r4, r4, r9
    asr     r7, r7, #4
    sub     change, r7, light, asr #4
    adds    r2, #128
    adds    r4, #128
    asrs    r2, r2, #8
    sbfx    r4, r4, #8, #16
    add     step, r4, r2, lsl #16
    ldm     lr, {texels, mask, ramp, last, r8, pc}

    /* Light that is not a level. */
.Lbeyond:
    cmp     r7, #0
    ite     lt
    movlt   r7, #0
    movge   r7, r12
    b       .Lwithin

    /* Fewer leading zeros in a drop: some bits come from the lower word. */
.Lfar:
    sub     r9, r9, r1
    sub     r10, r10, r1
    sub     r11, r11, r1
    smull   r1, r2, r4, r3
    shift_down r2, r1, r10
    smull   r1, r4, r6, r3
    shift_down r4, r1, r11
    smull   r1, r7, r7, r3
    shift_down r7, r1, r9
    b       .Lends

    /* The beginning of the first segment is found as an end is: the step back and forth. */
.Lbegin_slowly:
    ldr     r3, [sp, #FRAME_GO]
    str     r3, [sp, #FIRST]
    adr     r3, .Lstarted + 1
    str     r3, [sp, #FRAME_GO]
    ldr     lr, [sp, #BLOCK - 4]
    ldrd    r7, r8, [lr, #BLOCK_LIGHT]
    sub     r7, r7, r8
    str     r7, [lr, #BLOCK_LIGHT]
    ldm     sp, {r1-r6}
    b       .Lattributes
    .align  2
.Lstarted:
    ldr     r3, [sp, #FIRST]
    str     r3, [sp, #FRAME_GO]
    b       .Lsegment

    .align  2
.Lpartial:
    find_partial r12, r8
    mla     light, change, r12, light
    mov     other, light                /* the code may begin at an odd pixel */
    go_partial r8

    .align  2
.Lrest:
    begin_rest
    b       .Lsegment
.Lend:
    add     sp, #FRAME
    pop     {r4-r11, pc}


    .macro  go_on
    cmp     pixels, last
    bls     .Lsegment
    b       .Lrest
    .endm

    /* Any size. */
    .align  2
.Lloop:
    ldrd    r7, r8, [sp, #FRAME_COLUMN]
    add     r12, pixels, #16
    ldr     r3, [sp, #FRAME_BEFORE]
    add     pixels, r3
    movs    r3, #0
    str     r3, [sp, #FRAME_BEFORE]
.Lpixel:
    lsr     r3, p, r8
    ands    r3, mask
    lsr     r11, p, r7
    add     r3, texels
    ldrb    r3, [r3, r11]
    add     other, light, change
    bfi     light, r3, #0, #8
    ldrb    r3, [ramp, light]
    mov     light, other
    strb    r3, [pixels, #1]!
    add     p, step
    cmp     pixels, r12
    bne     .Lpixel
    ldr     last, [sp, #FRAME_LAST]
    go_on

    /* 26 bytes a pixel, and less for the last one, which no pixel follows. The texel takes the place
     * of the light's fraction: level and colour. */
    .macro  lit_texel log, at, light, next
    texel_offset r3, mask, p, \log
    ldrb    r3, [texels, r3]
    .if     \at < 16
    add.w   \next, \light, change
    .endif
    bfi     \light, r3, #0, #8
    ldrb    r3, [ramp, \light]
    .if     \at < 16
    strb    r3, [pixels, #\at]
    add     p, step
    .else
    strb    r3, [pixels, #\at]!
    .endif
    .endm
    .macro  whole log
.Lpixels_\log:
    .irp    at, 1, 3, 5, 7, 9, 11, 13, 15
    lit_texel \log, \at, light, other
    lit_texel \log, (\at + 1), other, light
    .endr
    go_on
    .endm
    whole_of_each_size

    .size fxl_paint_lit_segments, . - fxl_paint_lit_segments

#endif
