/* SPDX-License-Identifier: MIT */
/* fxl_paint_texels and fxl_texel_code_8 for Armv6-M. lib/paint/segments.h and plain_run.h state what they require
 * and do. A texel takes 7 instructions if the texture is 32 to 256 texels wide and no higher than wide; any other
 * takes 12 in fxl_paint_texels, 14 else. Light takes 7 more, in a second pass. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV6M

#include "plain_rows_armv6m.h"

    .syntax unified
    .thumb

#define PIXEL_BYTES 14  /* of code */
#define WHOLE       226 /* of code, for 16 pixels */

    .section .text.fxl_paint_texels, "ax", %progbits
    .global fxl_paint_texels
    .type fxl_paint_texels, %function
    .thumb_func

/* r0: face, r1: run, r2: pixels, r3: count */
fxl_paint_texels:
    push    {r0-r7, lr}
    movs    r7, #16
    subs    r7, r7, r3                  /* pixels of 16 that are left out */
    subs    pixels, pixels, r7
    ldr     step, [r1, #TEXEL_RUN_STEP]
    ldr     p, [r1, #TEXEL_RUN_POSITION]
    ldr     mask, [r0, #SEGMENT_FACE_ROWS_MASK]
    movs    r6, #SEGMENT_FACE_FORM
    ldrb    r6, [r0, r6]
    cmp     r6, #0
    beq     .Lany
    movs    r3, #PIXEL_BYTES
    muls    r7, r3
    movs    r3, #WHOLE
    muls    r6, r3
    adds    r6, r6, r7
    adr     r3, .Lpixels_5
    adds    r3, r3, r6
    subs    r3, #WHOLE - 1              /* Thumb code */
    ldr     texels, [r0, #SEGMENT_FACE_TEXELS]
    ldr     r6, =.Llight + 1
    mov     lr, r6
    bx      r3

    /* A texture of any size. */
.Lany:
    adds    pixels, pixels, r7
    adds    r3, r3, pixels
    mov     lr, r3
    mov     r12, step
    movs    r3, #SEGMENT_FACE_LOG_WIDTH
    ldrb    r6, [r0, r3]
    movs    r7, #32
    subs    r7, r7, r6
    movs    r3, #SEGMENT_FACE_ROW_DROP
    ldrb    r3, [r0, r3]
    ldr     texels, [r0, #SEGMENT_FACE_TEXELS]
.Lpixel:
    mov     r6, p
    lsrs    r6, r3
    ands    r6, mask
    adds    r6, r6, texels
    mov     r4, p
    lsrs    r4, r7
    ldrb    r6, [r6, r4]
    strb    r6, [pixels]
    adds    pixels, #1
    add     p, r12
    cmp     pixels, lr
    bne     .Lpixel
    subs    pixels, #16

    /* The pixels are texels. */
.Llight:
    ldr     r0, [sp]
    ldr     r7, [r0, #SEGMENT_FACE_RAMP]
    cmp     r7, #0
    bne     1f
    ldr     r7, [r0, #SEGMENT_FACE_TABLE] /* one level: the run has no light */
    cmp     r7, #0
    beq     .Lend
1:  ldr     r1, [sp, #4]
    ldr     r4, [r1, #TEXEL_RUN_LIGHT]
    ldr     r5, [r1, #TEXEL_RUN_LIGHT_STEP]
    ldr     r3, [sp, #12]
    movs    r6, #16
    subs    r6, r6, r3
    movs    r3, #PIXEL_BYTES
    muls    r6, r3
    adr     r3, .Llevels
    adds    r3, r3, r6
    adds    r3, #1
    bx      r3
    .align  2
.Llevels:
    .irp    i, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
    ldrb    r3, [pixels, #\i]
    lsrs    r6, r4, #8
    lsls    r6, r6, #8
    adds    r3, r3, r6
    ldrb    r3, [r7, r3]
    strb    r3, [pixels, #\i]
    adds    r4, r4, r5
    .endr
.Lend:
    add     sp, #16
    pop     {r4-r7, pc}

    .ltorg
    .size fxl_paint_texels, . - fxl_paint_texels

    .macro  paint_texel
    ldrb    r3, [texels, r3]
    strb    r3, [pixels]
    .endm

    .macro  store_texel i
    ldrb    r3, [texels, r3]
    strb    r3, [pixels, #\i]
    .endm

    .align  2
    .global fxl_texel_code_8
    .type   fxl_texel_code_8, %object
fxl_texel_code_8:
    .word   0
    .word   .Lpixels_5 + 1 - WHOLE, WHOLE, PIXEL_BYTES
    .word   0, 0, 0                     /* a palette: none */
    .word   .Lloop + 1
    .size   fxl_texel_code_8, . - fxl_texel_code_8

    .type   texels_8, %function
texels_8:
.Lpixels_5:
    sixteen 5, store_texel
    .org    .Lpixels_5 + WHOLE
    sixteen 6, store_texel
    .org    .Lpixels_5 + 2 * WHOLE
    sixteen 7, store_texel
    .org    .Lpixels_5 + 3 * WHOLE
    sixteen 8, store_texel
.Lloop:
    paint_loop 0
    .size texels_8, . - texels_8

#endif
