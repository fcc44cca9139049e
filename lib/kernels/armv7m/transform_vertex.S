/* SPDX-License-Identifier: MIT */
/* fxl_transform_vertex for Armv7-M and Armv8-M Mainline. lib/src/math/arith.h (fxl_dot) and
 * lib/src/view/outside.h define the sums and derive their bounds.
 *
 * If the upper words of a distance do not decide a sign, fxl_outcode computes the outcode. */
#include "../family.h"

#if FXL_KERNELS_ARMV7M


    .syntax unified
    .thumb

/* Offsets in fxl_view, fxl_view_frustum and fxl_cached_vertex. fxl_model_view is view,
 * entries, mask, tag, vertices, indices, offset, planes. model_view.c asserts them. */
#define ROTATION    12      /* three rows of three */
#define FRUSTUM     96      /* side and depth of x, of y; near_z, far_z, inset */
#define INSET_UPPER 36
#define CLIP_FLAGS  4
#define POSITION    16
#define UNPROJECTED 0x80

entry       .req r2
view        .req r3         /* then the address after the part of the view read so far */
planes      .req lr         /* in the lowest byte */

    .section .text.fxl_transform_vertex, "ax", %progbits
    .global fxl_transform_vertex
    .type fxl_transform_vertex, %function
    .thumb_func

/* r0: model_view, r1: number, r2: entry */
fxl_transform_vertex:
    push    {r3-r11, lr}
    ldm     r0!, {r3-r7}                    /* view, -, -, tag, vertices */
    add     r6, r6, r1
    str     r6, [entry]
    add     r1, r1, r1, lsl #1
    add     r7, r7, r1, lsl #2
    ldm     r7, {r7-r9}
    ldm     r0, {r1, r4-r6, lr}             /* -, offset, planes */
    add     r7, r7, r4
    add     r8, r8, r5
    add     r9, r9, r6

    adds    view, view, #ROTATION
    ldm     view!, {r4-r6}
    smull   r10, r11, r4, r7
    smlal   r10, r11, r5, r8
    smlal   r10, r11, r6, r9
    strd    r10, r11, [entry, #POSITION]
    ldm     view!, {r4-r6}
    smull   r10, r12, r4, r7
    smlal   r10, r12, r5, r8
    smlal   r10, r12, r6, r9
    strd    r10, r12, [entry, #POSITION + 8]
    ldm     view!, {r4-r6}
    smull   r10, r0, r4, r7
    smlal   r10, r0, r5, r8
    smlal   r10, r0, r6, r9
    strd    r10, r0, [entry, #POSITION + 16]

    lsls    r1, planes, #24
    beq     decided                         /* inside all planes */
    adds    view, view, #FRUSTUM - ROTATION - 36
    ldm     view, {r4-r7}
    ldr     r9, [view, #INSET_UPPER]
    asr     r9, r9, #2
    subs    r9, r9, #4                      /* distances become 4 larger: 0..7 is undecided */
    smull   r1, r4, r4, r11
    smull   r1, r5, r5, r0
    subs    r5, r5, r9
    add     r8, r5, r4                      /* left */
    sub     r11, r5, r4                     /* right */
    smull   r1, r6, r6, r12
    smull   r1, r7, r7, r0
    subs    r7, r7, r9
    add     r12, r7, r6                     /* bottom */
    sub     r9, r7, r6                      /* top */

    cmp     r8, #8
    ittt    hs
    cmphs   r11, #8
    cmphs   r12, #8 /* bug: v7m-outcode */
    cmphs   r9, #8
    blo     undecided

    ldrd    r4, r5, [view, #16]             /* near_z, far_z */
    ldrd    r6, r7, [view, #24]
    subs    r4, r10, r4
    sbc     r5, r0, r5
    subs    r6, r6, r10
    sbc     r7, r7, r0
    lsrs    r1, r5, #31                     /* signs, from the lowest bit upward; adding 4
                                               changes no sign that is decided */
    lsrs    r7, r7, #31
    orr     r1, r1, r7, lsl #1
    lsr     r8, r8, #31
    orr     r1, r1, r8, lsl #2
    lsr     r11, r11, #31
    orr     r1, r1, r11, lsl #3
    lsr     r12, r12, #31
    orr     r1, r1, r12, lsl #4
    lsr     r9, r9, #31
    orr     r1, r1, r9, lsl #5
    and     r1, r1, planes

decided:
    orr     r1, r1, #UNPROJECTED
    str     r1, [entry, #CLIP_FLAGS]
    pop     {r3-r11, pc}

undecided:
    mov     r4, entry
    mov     r0, view
    uxtb    r1, planes
    add     r2, entry, #POSITION
    bl      fxl_outcode
    orr     r0, r0, #UNPROJECTED
    str     r0, [r4, #CLIP_FLAGS]
    pop     {r3-r11, pc}

    .size fxl_transform_vertex, . - fxl_transform_vertex

#endif
