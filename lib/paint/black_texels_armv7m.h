/* SPDX-License-Identifier: MIT */
/* How the kernels of lit texels of RGB565 mix a colour with black. Assembly. */
#ifndef FXL_BLACK_TEXELS_ARMV7M_H
#define FXL_BLACK_TEXELS_ARMV7M_H

/* clang-format off */

/* The colour in r0 becomes that of which black leaves a part of 256, r1: fxl_mixed_565 of the dark colour 0. A
 * part is at most 256, so red is from bit 16 on, and what is added is half a step of each channel. Overwrites
 * r1 and r2. */
    .macro  mix_black
    and     r2, r0, #0x7E0
    orr     r0, r0, r0, lsl #5
    bfc     r0, #5, #11
    mul     r2, r2, r1
    mul     r0, r0, r1
    add     r2, r2, #1 << 12
    add     r0, r0, #0x00800080
    lsr     r2, r2, #13
    lsr     r1, r0, #24
    orr     r2, r2, r1, lsl #6
    lsr     r0, r0, #8
    bfi     r0, r2, #5, #11
    .endm

/* clang-format on */

#endif
