/* SPDX-License-Identifier: MIT */
/* place light: the levels of corners, in assembly */
/* fxl_light_corners_of for Armv7-M and Armv8-M Mainline. lib/paint/light_level.h states what it does; it gives the
 * same bits as the text in light_level.c. Three corners take 73 instructions, of which compilers take 94. */
#include "../math/family.h"
#include "../math/offsets.h"
#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT

    .syntax unified
    .thumb
    .section .text.fxl_light_corners_of, "ax", %progbits
    .global fxl_light_corners_of
    .type fxl_light_corners_of, %function
    .thumb_func

/* r0: settings, r1: normals, r2: corners, r3: values. r4: ambient, r5: twice the strength, which is at most
 * 2^31, r6-r8: the direction, negated, r9: what makes levels of a brightness. */
fxl_light_corners_of:
    push    {r4-r11, lr}
    ldr     r9, [r0, #LIGHT_SETTINGS_LEVELS]
    ldm     r0, {r4-r8}
    subs    r9, r9, #1
    lsl     r9, r9, #18
    lsls    r5, r5, #1
    rsbs    r6, r6, #0
    rsbs    r7, r7, #0
    rsb     r8, r8, #0
    .rept   3
    ldr     r12, [r2], #4
    ldrh    r12, [r12, #CORNER_NORMAL]
    add     r12, r12, r12, lsl #1
    add     r12, r1, r12, lsl #2
    ldm     r12, {r10, r11, r12}
    smull   r0, lr, r10, r6         /* how far the normal faces the light: below 2^61 */
    smlal   r0, lr, r11, r7
    smlal   r0, lr, r12, r8
    lsr     r0, r0, #29             /* twice that in 2^-30, whose lowest bit is 0 */
    orr     r0, r0, lr, lsl #3
    bic     r0, r0, #1
    umull   r10, r0, r0, r5
    bic     r0, r0, lr, asr #31     /* none if it faces away */
    add     r0, r0, r4
    cmp     r0, #1 << 30
    it      hs
    movhs   r0, #1 << 30
    mov     r10, #1 << 31           /* half a level, and half a unit */
    mov     r11, #32768
    umlal   r10, r11, r0, r9
    str     r11, [r3], #4
    .endr
    pop     {r4-r11, pc}
    .size fxl_light_corners_of, . - fxl_light_corners_of
#endif
