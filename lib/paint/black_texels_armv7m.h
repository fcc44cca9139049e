/* SPDX-License-Identifier: MIT */
/* How the kernels of lit texels of RGB565 mix a colour with black. Assembly. */
#ifndef FXL_BLACK_TEXELS_ARMV7M_H
#define FXL_BLACK_TEXELS_ARMV7M_H

/* clang-format off */

/* Half a step of a channel at bit 0, and of one at bit 16. */
#define HALF_STEPS 0x00800080

/* The colour in r0 becomes that of which black leaves a part of 256, r1: fxl_mixed_565 of the dark colour 0. A
 * part is at most 256, so red is from bit 16 on. half: a register that has HALF_STEPS. Overwrites r1 and r2. */
    .macro  mix_black half
    ubfx    r2, r0, #5, #6          /* green, where the upper half step is above what is kept */
    orr     r0, r0, r0, lsl #5
    bfc     r0, #5, #11
    mla     r2, r2, r1, \half
    mla     r0, r0, r1, \half
    lsr     r1, r0, #24
    lsr     r2, r2, #8
    bfi     r2, r1, #6, #5
    lsr     r0, r0, #8
    bfi     r0, r2, #5, #11
    .endm

/* clang-format on */

#endif
