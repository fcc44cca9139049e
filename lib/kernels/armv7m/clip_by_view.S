/* SPDX-License-Identifier: MIT */
/* fxl_clip_by_view for Armv7-M and Armv8-M Mainline. lib/include/fixel/stage/clipper.h states
 * what it requires and returns; it gives the same bits as
 * lib/kernels/portable/clip_by_view.c. */
#include "../family.h"

#if FXL_KERNELS_ARMV7M


    .syntax unified
    .thumb

/* Offsets in fxl_face, fxl_cached_vertex, fxl_screen_polygon and fxl_view, and results:
 * clipper_view.c asserts them. fxl_model_view begins with view, entries, mask, tag, vertices,
 * indices. */
#define FIRST_INDEX  12
#define COUNT        16      /* and the colour beside it */
#define CLIP_FLAGS   4
#define SCREEN       8
#define POSITION     16
#define POINTS       4
#define PROJECTION   68
#define UNPROJECTED  0x80
#define RANGE        5
#define BETWEEN      6

/* On the stack: model_view, face, work, screen, r4-r11, the vertex, lr. */
#define AT_FACE     4
#define AT_SCREEN   12
#define AT_VERTEX   48

vertex  .req r2
of_all  .req r4
entries .req r5
mask    .req r6
tag     .req r7
point   .req r8
index   .req r9     /* address of the next index */
count   .req r10
of_any  .req r11
flags   .req r12

    .section .text.fxl_clip_by_view, "ax", %progbits
    .global fxl_clip_by_view
    .type fxl_clip_by_view, %function
    .thumb_func

/* r0: model_view, r1: face, r2: work, r3: screen */
fxl_clip_by_view:
    push    {r0-r12, lr}
    ldm     r0, {r4-r9}                     /* -, entries, mask, tag, -, indices */
    ldr     r2, [r1, #FIRST_INDEX]
    ldrb    count, [r1, #COUNT]
    add     index, index, r2, lsl #1
    add     point, r3, #POINTS
    mov     of_any, #0
    mvn     of_all, #0
.Lvertex:
    ldrh    r1, [index], #2
    and     r2, r1, mask
    add     r2, r2, r2, lsl #2              /* 40 bytes each */
    add     vertex, entries, r2, lsl #3
    ldrd    r0, flags, [vertex]
    add     r3, r1, tag
    cmp     r0, r3
    bne     .Lmiss
.Lcached:
    lsls    r0, flags, #24
    bne     .Lunprojected
.Lready:
    ldrd    r0, r1, [vertex, #SCREEN]
    orr     of_any, of_any, flags
    and     of_all, of_all, flags
    stm     point!, {r0, r1}
    subs    count, count, #1
    bne     .Lvertex

    ldr     r1, [sp, #AT_FACE]
    ldr     r2, [sp, #AT_SCREEN]
    ldrh    r3, [r1, #COUNT]
    rev16   r3, r3                          /* colour, count */
    strh    r3, [r2]
    eor     r1, of_any, of_all
    movs    r0, #0
    lsls    r2, r1, #12                     /* columns */ /* bug: v7m-columns */
    it      ne
    lsrsne  r2, r1, #20                     /* rows */
    it      eq
    moveq   r0, #BETWEEN
.Ldone:
    add     sp, sp, #16
    pop     {r4-r12, pc}

.Lmiss:
    ldr     r0, [sp]
    str     vertex, [sp, #AT_VERTEX]
    bl      fxl_transform_vertex
    ldr     vertex, [sp, #AT_VERTEX]
    ldr     flags, [vertex, #CLIP_FLAGS]
    b       .Lcached

.Lunprojected:
    cmp     flags, #UNPROJECTED
    bne     .Loutside
    str     vertex, [sp, #AT_VERTEX]
    ldr     r0, [sp]
    ldr     r0, [r0]
    add     r1, vertex, #POSITION
    adds    r2, vertex, #SCREEN
    adds    r0, r0, #PROJECTION
    bl      fxl_project_inside
    cbnz    r0, .Lrange
    ldr     vertex, [sp, #AT_VERTEX]
    ldrd    r0, r1, [vertex, #SCREEN]
    movw    r3, #0x7FFF
    add     r0, r0, r3
    add     r1, r1, r3
    asrs    r0, r0, #16
    asrs    r1, r1, #16
    lsls    r1, r1, #20
    orr     flags, r1, r0, lsl #8
    str     flags, [vertex, #CLIP_FLAGS]
    b       .Lready

.Loutside:
    pop     {r0-r12, lr}
    b.w     fxl_clip_assembled

.Lrange:
    movs    r0, #RANGE
    b       .Ldone

    .size fxl_clip_by_view, . - fxl_clip_by_view

#endif
