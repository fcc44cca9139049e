/* SPDX-License-Identifier: MIT */
/* Part of paint_lit_segments_armv7m.S: the pixels of a segment. Assembly. */
#ifndef FXL_LIT_TEXELS_ARMV7M_H
#define FXL_LIT_TEXELS_ARMV7M_H

/* clang-format off */

/* Pixels from FRAME_SKIP on, up to the end of the run or of the segment: the last ones of the code of
 * 16 pixels, whose first pixel is before them by as many as are left out, r3. Overwrites r8, r12. */
    .macro  find_part
    ldr     r8, [sp, #.LFRAME_SKIP]
    ldr     r12, [sp, #.LFRAME_SHORT]
    mla     p, step, r8, p
    mla     light, change, r8, light
    add     r12, r12, r8
    add     pixels, pixels, r12
    ldr     r3, [sp, #.LFRAME_LAST + 4]
    sub     r3, r3, pixels
    rsb     r3, r3, #16
    cmp     r3, r12
    it      lt
    movlt   r3, r12
    sub     pixels, pixels, r3
    str     r3, [sp, #.LFRAME_BEFORE]
    movs    r8, #0
    str     r8, [sp, #.LFRAME_SKIP]
    .endm

    .align  2
.Lpartial:
    ldr     r3, [sp, #.LBLOCK + BLOCK_MOST]
    cmp     light, r3
    bhi     .Llimited
    find_part
    ldr     r8, [sp, #.LFRAME_FULL]
    str     r8, [sp, #.LFRAME_GO]
    ldrd    r8, r12, [sp, #.LFRAME_CODE]
    mla     r3, r3, r12, r8
    mov     other, light                /* the code may begin at an odd pixel */
    bx      r3

/* Less than 16 columns are left; or segments are shorter. */
    .align  2
.Lrest:
    ldr     r3, [sp, #.LFRAME_LAST + 4]
    cmp     pixels, r3
    it      hs
    ldrhs   pc, [sp, #.LFRAME_DONE]
    ldr     r4, [sp, #.LFRAME_SHORT]
    cbnz    r4, 1f
    adr     r3, .Lpartial + 1
    str     r3, [sp, #.LFRAME_GO]
    b       .Lsegment
1:  rsb     r4, r4, #16
    subs    r3, r3, r4
    cmp     pixels, r3
    bls     .Lshort
    adr     r3, .Lpartial + 1
    str     r3, [sp, #.LFRAME_GO]
    b       .Lshort

    .macro  go_on
    cmp     pixels, last
    bls     .Lsegment
    b       .Lrest
    .endm

/* Light at an end is not a level: it is limited at each pixel. */
    .align  2
.Llimited:
    find_part
    ldrd    r7, r8, [sp, #.LFRAME_COLUMN]
    add     r12, pixels, #16
    add     pixels, r3
    ldr     r3, [sp, #.LFRAME_SHORT]
    str     r3, [sp, #.LFRAME_BEFORE]
    ldr     lr, [sp, #.LBLOCK + BLOCK_MOST]
1:  lsr     r3, p, r8
    ands    r3, mask
    lsr     r11, p, r7
    add     r3, texels
    ldrb    r3, [r3, r11]
    bic     r11, light, light, asr #31
    cmp     r11, lr
    it      gt
    movgt   r11, lr
    bfi     r11, r3, #0, #8
    ldrb    r3, [ramp, r11]
    strb    r3, [pixels, #1]!
    add     p, step
    add     light, change
    cmp     pixels, r12
    bne     1b
    ldr     r3, [sp, #.LENDS_LIGHT]
    cmp     r3, lr
    ite     hi
    adrhi   r3, .Llimited + 1
    ldrls   r3, [sp, #.LFRAME_FULL]
    str     r3, [sp, #.LFRAME_GO]
    ldr     last, [sp, #.LFRAME_LAST]
    go_on

    /* Any size. */
    .align  2
.Lloop:
    ldrd    r7, r8, [sp, #.LFRAME_COLUMN]
    add     r12, pixels, #16
    ldr     r3, [sp, #.LFRAME_BEFORE]
    add     pixels, r3
    ldr     r3, [sp, #.LFRAME_SHORT]
    str     r3, [sp, #.LFRAME_BEFORE]
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
    ldr     last, [sp, #.LFRAME_LAST]
    go_on

/* place sampling: the kernels of Armv7-M; texel_offset has the shift and mask of both */
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

/* clang-format on */

#endif
