/* SPDX-License-Identifier: MIT */
/* fxl_texel_code_565 for Armv6-M: the pixels of 16 bits of fxl_paint_plain_rows and what is beside it. A texel takes
 * 8 instructions if the texture is 32 to 256 texels wide and no higher than wide, and 9 by a palette; any
 * other takes 17, and 20 by a palette. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV6M

#include "plain_rows_armv6m.h"

#define PIXEL         16
#define WHOLE         258
#define PIXEL_PALETTE 18
#define WHOLE_PALETTE 290

    .syntax unified
    .thumb
    .section .text.fxl_texel_code_565, "ax", %progbits
    .global fxl_texel_code_565

    .macro  store_colour i
    lsls    r3, r3, #1
    ldrh    r3, [texels, r3]
    strh    r3, [pixels, #(2 * \i)]
    .endm

    .macro  store_by_palette i
    ldrb    r3, [texels, r3]
    lsls    r3, r3, #1
    ldrh    r3, [palette, r3]
    strh    r3, [pixels, #(2 * \i)]
    .endm

    .macro  paint_texel
    cmp     palette, #0
    bne     3f
    lsls    r3, r3, #1
    ldrh    r3, [texels, r3]
    b       4f
3:  ldrb    r3, [texels, r3]
    ldr     r6, [sp, #F_IN_BEAM]
    cmp     r6, #0
    beq     3f
    ldrb    r3, [r6, r3]
3:  lsls    r3, r3, #1
    ldrh    r3, [palette, r3]
4:  strh    r3, [pixels]
    .endm

    .align  2
    .type   fxl_texel_code_565, %object
fxl_texel_code_565:
    .word   1
    .word   .Lplain_5 + 1 - WHOLE, WHOLE, PIXEL
    .word   .Lpalette_5 + 1 - WHOLE_PALETTE, WHOLE_PALETTE, PIXEL_PALETTE
    .word   .Lloop + 1
    .size   fxl_texel_code_565, . - fxl_texel_code_565

    .type   texels_565, %function
texels_565:
.Lplain_5:
    sixteen 5, store_colour
    .org    .Lplain_5 + WHOLE
    sixteen 6, store_colour
    .org    .Lplain_5 + 2 * WHOLE
    sixteen 7, store_colour
    .org    .Lplain_5 + 3 * WHOLE
    sixteen 8, store_colour
.Lpalette_5:
    sixteen 5, store_by_palette
    .org    .Lpalette_5 + WHOLE_PALETTE
    sixteen 6, store_by_palette
    .org    .Lpalette_5 + 2 * WHOLE_PALETTE
    sixteen 7, store_by_palette
    .org    .Lpalette_5 + 3 * WHOLE_PALETTE
    sixteen 8, store_by_palette
.Lloop:
    paint_loop 1
    .size texels_565, . - texels_565

#endif
