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

#if !FXL_IS_COMPACT
    .section .text.fxl_next_front_face, "ax", %progbits
    .global fxl_next_front_face
    .type fxl_next_front_face, %function
    .thumb_func

    .unreq  face
    .unreq  left
face    .req r4
step    .req r5             /* in bytes */
left    .req r6
#define AT_WALK 4

/* The vertex whose number is at \offset of the face: r12 keeps the planes that
 * all vertices so far are outside of. r1: entries, r2: mask, r3: tag. */
    .macro  vertex_planes vertex, offset
    ldrh    lr, [face, #\offset]
    and     r0, lr, r2
    add     r0, r0, r0, lsl #2              /* 40 bytes each */
    add     r0, r1, r0, lsl #3
    ldrd    r0, r11, [r0]
    add     lr, lr, r3
    cmp     r0, lr
    bne     .Lmissing\vertex
.Lcached\vertex:
    ands    r12, r12, r11
    beq     .Lreturn
    .endm

/* It is not in the cache. */
    .macro  missing_vertex vertex, offset
.Lmissing\vertex:
    ldrh    r1, [face, #\offset]
    bl      .Ltransform
    b       .Lcached\vertex
    .endm

/* r0: model_view, r1: walk. A vertex relative to the eye is below 2^30, so the sum is below 2^62
 * (fxl_dot). */
fxl_next_front_face:
    push    {r0, r1, r3-r11, lr}
    ldm     r1, {face, step, left}
    cbz     left, .Lnone
    ldr     r7, [r0, #MODEL_VIEW_VERTICES]
    add     r0, r0, #MODEL_VIEW_OFFSET
    ldm     r0, {r8-r10}
    add     step, step, step, lsl #2
    lsl     step, step, #2                  /* FACE_SIZE each */
.Lnext:
    ldrh    r12, [face, #FACE_INDICES]
    ldm     face, {r0-r2}
    add     r12, r12, r12, lsl #1
    add     r12, r7, r12, lsl #2
    ldm     r12, {r3, r11, r12}
    add     r3, r3, r8
    add     r11, r11, r9
    add     r12, r12, r10
    smull   r0, lr, r0, r3
    smlal   r0, lr, r1, r11
    smlal   r0, lr, r2, r12
    cmp     lr, #0
    blt     .Lfront
.Lpassed:
    add     face, face, step
    subs    left, left, #1
    bne     .Lnext
    ldr     r1, [sp, #AT_WALK]
    str     left, [r1, #FACE_WALK_LEFT]
.Lnone:
    movs    r0, #0
    add     sp, sp, #12
    pop     {r4-r11, pc}

.Lfront:
    ldr     r1, [sp, #AT_WALK]
    ldrb    r2, [r1, #FACE_WALK_DROPS]
    cmp     r2, #0
    beq     .Lleave
    ldrb    r11, [face, #FACE_COUNT]
    ldr     r0, [sp]
    ldrd    r1, r2, [r0, #MODEL_VIEW_ENTRIES]
    ldr     r3, [r0, #MODEL_VIEW_TAG]
    mov     r12, #PLANES_ALL
    cmp     r11, #3
    bne     .Lask
    vertex_planes 1, FACE_INDICES
    vertex_planes 2, FACE_INDICES + 2
    vertex_planes 3, FACE_INDICES + 4
.Loutside:
    ldr     r1, [sp, #AT_WALK]
    ldr     r0, [r1, #FACE_WALK_OUTSIDE]
    adds    r0, r0, #1
    str     r0, [r1, #FACE_WALK_OUTSIDE]
    b       .Lpassed

    missing_vertex 1, FACE_INDICES
    missing_vertex 2, FACE_INDICES + 2
    missing_vertex 3, FACE_INDICES + 4

    /* r1: number, r2: mask; leaves the clip flags in r11. fxl_transform_vertex leaves the model view
     * in r2, and the flags in r1. */
.Ltransform:
    push    {r12, lr}
    ldr     r0, [sp, #8]
    ldr     r3, [r0, #MODEL_VIEW_ENTRIES]
    and     r2, r2, r1
    add     r2, r2, r2, lsl #2
    add     r2, r3, r2, lsl #3
    bl      fxl_transform_vertex
    mov     r11, r1
    ldr     r3, [r2, #MODEL_VIEW_TAG]
    ldrd    r1, r2, [r2, #MODEL_VIEW_ENTRIES]
    pop     {r12, pc}

.Lask:
    ldr     r0, [sp]
    mov     r1, face
    bl      fxl_face_is_outside
    cmp     r0, #0
    bne     .Loutside
.Lreturn:
    ldr     r1, [sp, #AT_WALK]
.Lleave:
    mov     r0, face
    subs    left, left, #1
    it      ne
    addne   face, face, step
    str     face, [r1, #FACE_WALK_FACE]
    str     left, [r1, #FACE_WALK_LEFT]
    add     sp, sp, #12
    pop     {r4-r11, pc}

    .size fxl_next_front_face, . - fxl_next_front_face
#endif

#endif
