/* SPDX-License-Identifier: MIT */
/* fxl_front_faces for Armv7-M and Armv8-M Mainline. lib/view/cull.h defines the sums
 * and their bounds. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV7M


    .syntax unified
    .thumb

#define COUNT   36          /* on the stack */
#define END     40

face    .req r0
bounds  .req r1             /* of the next face */
entry   .req r3
left    .req lr             /* faces still to be tested, including the first of two */

    .section .text.fxl_front_faces, "ax", %progbits
    .global fxl_front_faces
    .type fxl_front_faces, %function
    .thumb_func

/* r0: faces, r1: bounds, r2: eye, r3: entry; on the stack: count, end */
fxl_front_faces:
    push    {r4-r11, lr}
    ldm     r2, {r4-r6}
    ldr     left, [sp, #COUNT]
    tst     left, #1
    beq     .Lface
    add     left, left, #1
    b       .Lsecond

/* Tests the next face. second: 1 of the second one of two. */
    .macro  test_face name, second
    ldm     face, {r7-r9}
    ldrd    r10, r11, [bounds], #FACE_BOUNDS_SIZE
    smull   r7, r12, r7, r4
    smlal   r7, r12, r8, r5
    smlal   r7, r12, r9, r6
    adds    face, face, #FACE_SIZE
    cmp     r10, r7
    sbcs    r11, r11, r12
    bge     .Laway\name                     /* turned away */
    ldr     r7, [bounds, #FACE_BOUNDS_BOX_X - FACE_BOUNDS_SIZE]
    ldrd    r8, r9, [bounds, #FACE_BOUNDS_BOX_Y - FACE_BOUNDS_SIZE]
    sub     r7, r7, r4, lsl #1
    sub     r8, r8, r5, lsl #1
    sub     r9, r9, r6, lsl #1
    ldr     r12, [sp, #END]
    smull   r10, r11, r7, r7
    smlal   r10, r11, r8, r8
    smlal   r10, r11, r9, r9
    sub     r12, r12, left                  /* its number, and 0 beside it */
    .if \second
    add     r12, r12, #1
    .endif
    stm     entry!, {r10-r12}
.Laway\name:
    .endm

.Lface:
    test_face _first, 0
.Lsecond:
    test_face _second, 1
    subs    left, left, #2
    bne     .Lface
    mov     r0, entry
    pop     {r4-r11, pc}

    .size fxl_front_faces, . - fxl_front_faces

#endif
