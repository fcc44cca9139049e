/* SPDX-License-Identifier: MIT */
/* fxl_clip_by_view for Armv7-M and Armv8-M Mainline. lib/clip/clip_by_view.h states
 * what it requires and returns; it gives the same bits as
 * lib/clip/clip_by_view.c. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV7M


    .syntax unified
    .thumb

/* On the stack: model_view, face, work, screen, r4-r11, the projection, lr. */
#define AT_FACE     4
#define AT_SCREEN   12
#define AT_PROJECTION 48

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
    ldm     r0, {r4-r9}                     /* view, entries, mask, tag, -, indices */
    ldrb    count, [r1, #FACE_COUNT]
    adds    r4, r4, #VIEW_PROJECTION
    str     r4, [sp, #AT_PROJECTION]
    cmp     count, #3
    itte    ne
    ldrne   r2, [r1, #FACE_INDICES + 2]     /* the number of the first one */
    addne   index, index, r2, lsl #1
    addeq   index, r1, #FACE_INDICES
    add     point, r3, #SCREEN_POLYGON_POINTS
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
    lsls    r0, flags, #24
    bne     .Lunprojected
.Lready:
    ldrd    r0, r1, [vertex, #CACHED_VERTEX_SCREEN]
    stm     point!, {r0, r1}
.Lstored:
    orr     of_any, of_any, flags
    and     of_all, of_all, flags
    subs    count, count, #1
    bne     .Lvertex

.Lprojected:
    ldr     r1, [sp, #AT_FACE]
    ldr     r2, [sp, #AT_SCREEN]
    ldrh    r3, [r1, #FACE_COUNT]            /* and the colour beside it */
    rev16   r3, r3                          /* colour, count */
    strh    r3, [r2]
    eor     r1, of_any, of_all
    movs    r0, #0
    lsls    r2, r1, #12                     /* columns */
    it      ne
    lsrsne  r2, r1, #20                     /* rows */
    it      eq
    moveq   r0, #CLIP_BETWEEN
.Ldone:
    add     sp, sp, #16
    pop     {r4-r12, pc}

/* place fill-rule: the first centres of a vertex for Armv7-M, which adds 0x7FFF itself */
    /* r0-r3 after both calls: as transform_vertex_armv7m.S and project_inside_armv7m.S say. */
.Lmiss:
    ldr     r0, [sp]
#if FXL_IS_COMPACT
    bl      fxl_transform_vertex
    sub     vertex, r3, #CACHED_VERTEX_POSITION
    mov     flags, r1
#else
    bl      fxl_transform_and_project
    cbz     r0, .Lproject
    adds    r0, r0, #1
    bne     .Lrange_of_new
    mov     flags, r1
#endif
.Lunprojected:
    cmp     flags, #VERTEX_UNPROJECTED
    bne     .Loutside
    ldr     r0, [sp, #AT_PROJECTION]
    add     r1, vertex, #CACHED_VERTEX_POSITION
    adds    r2, r2, #CACHED_VERTEX_SCREEN
    bl      fxl_project_inside
    cbnz    r0, .Lrange
.Lproject:
    strd    r1, r3, [point], #8
    movw    r0, #0x7FFF
    add     r1, r1, r0
    add     r3, r3, r0
    lsrs    r1, r1, #16
    lsrs    r3, r3, #16
    lsls    r3, r3, #20
    orr     flags, r3, r1, lsl #8
    str     flags, [r2, #CACHED_VERTEX_CLIP_FLAGS - CACHED_VERTEX_SCREEN]
#if FXL_IS_COMPACT
    b       .Lstored
#else
    orr     of_any, of_any, flags
    and     of_all, of_all, flags
    subs    count, count, #1
    bne     .Lvertex
    b       .Lprojected
#endif

    /* A face is outside if its first vertex is outside of a plane, and with it all others. */
.Loutside:
    adds    r0, of_all, #1
    bne     .Lassembled
    mov     of_all, flags
.Lcommon:
    subs    count, count, #1
    beq     .Lall_outside
    ldrh    r1, [index], #2
    and     r2, r1, mask
    add     r2, r2, r2, lsl #2
    add     vertex, entries, r2, lsl #3
    ldrd    r0, flags, [vertex]
    add     r3, r1, tag
    cmp     r0, r3
    bne     .Lcommon_miss
.Lcommon_flags:
    and     of_all, of_all, flags
    tst     of_all, #PLANES_ALL
    bne     .Lcommon
.Lassembled:
    pop     {r0-r12, lr}
    b.w     fxl_clip_assembled

.Lcommon_miss:
    ldr     r0, [sp]
    bl      fxl_transform_vertex
    mov     flags, r1
    b       .Lcommon_flags

.Lall_outside:
    movs    r0, #CLIP_OUTSIDE
    b       .Ldone

#if !FXL_IS_COMPACT
    /* The vertex has no flags yet. */
.Lrange_of_new:
    movs    r1, #VERTEX_UNPROJECTED
    str     r1, [r2, #CACHED_VERTEX_CLIP_FLAGS - CACHED_VERTEX_SCREEN]
#endif
.Lrange:
    movs    r0, #CLIP_RANGE
    b       .Ldone

    .size fxl_clip_by_view, . - fxl_clip_by_view

#if !FXL_IS_COMPACT
corners     .req r8
face        .req r9

    .section .text.fxl_find_inside_corners, "ax", %progbits
    .global fxl_find_inside_corners
    .type fxl_find_inside_corners, %function
    .thumb_func

    .macro  inside_vertex number
    ldrh    r1, [face, #FACE_INDICES + 2 * \number]
    and     r2, r1, mask
    add     r2, r2, r2, lsl #2
    add     vertex, entries, r2, lsl #3
    ldrd    r0, flags, [vertex]
    add     r3, r1, tag
    cmp     r0, r3
    bne     .Lnew\number
    lsls    r0, flags, #24
    bne     .Lunready\number
.Lready\number:
    ldrd    r0, r1, [vertex, #CACHED_VERTEX_SCREEN]
    strd    r0, r1, [corners, #8 * \number]
    ldrd    r0, r1, [vertex, #CACHED_VERTEX_POSITION + 16]
    strd    r0, r1, [corners, #SCREEN_CORNERS_DEPTHS + 8 * \number]
    .if     \number == 0
    mov     of_any, flags
    mov     of_all, flags
    .else
    orr     of_any, of_any, flags
    and     of_all, of_all, flags
    .endif
    .endm

    .macro  other_vertex number
.Lunready\number:
    bl      .Lflags
    b       .Lready\number
.Lnew\number:
    bl      .Lfetch
    b       .Lready\number
    .endm

    /* \spare: from the least, which \x0 becomes, to the largest. On the screen nothing wraps. */
    .macro  side x0, x1, x2, spare
    sub     \x1, \x1, \x0
    sub     \x2, \x2, \x0
    sub     \spare, \x1, \x2
    and     \spare, \spare, \spare, asr #31
    sub     \x1, \x1, \spare       /* the larger one */
    add     \x2, \x2, \spare
    bic     \x1, \x1, \x1, asr #31
    and     \x2, \x2, \x2, asr #31
    add     \x0, \x0, \x2
    sub     \spare, \x1, \x2
    .endm

/* lib/draw/surface_polygon.h states what it requires and returns. r0: model_view, r1: face, r2: corners */
fxl_find_inside_corners:
    push    {r0, r4-r11, lr}
    ldm     r0, {r4-r7}                     /* view, entries, mask, tag */
    mov     corners, r2
    mov     face, r1
    push    {r3, r4}
    inside_vertex 0
    inside_vertex 1
    inside_vertex 2
    eor     r1, of_any, of_all
    lsls    r3, r1, #12
    it      ne
    lsrsne  r3, r1, #20
    beq     .Lis_between
    ldm     corners, {r2-r7}
    side    r2, r4, r6, r0
    side    r3, r5, r7, r1
    strd    r0, r1, [corners, #SCREEN_CORNERS_WIDTH]
    strd    r2, r3, [corners, #INSIDE_CORNERS_LEAST]
    movs    r0, #CLIP_INSIDE
.Lreturned:
    add     sp, sp, #12
    pop     {r4-r11, pc}
.Lis_between:
    movs    r0, #CLIP_BETWEEN
    b       .Lreturned
.Lis_other:
    movs    r0, #CLIP_CUT
    b       .Lreturned

    other_vertex 0
    other_vertex 1
    other_vertex 2

    /* A vertex that is not in the cache, or is not projected, in the place of one that is: flags, and
     * vertex. */
.Lfetch:
    push    {r2, lr}
    ldr     r0, [sp, #16]
    bl      fxl_transform_and_project
    pop     {r2, lr}
    cbz     r0, .Lhas_place
    adds    r0, r0, #1
    bne     .Lrange_of_inside
    mov     flags, r1
.Lflags:
    cmp     flags, #VERTEX_UNPROJECTED
    bne     .Lis_other
    ldr     r0, [sp, #4]
    adds    r0, r0, #VIEW_PROJECTION
    add     r1, vertex, #CACHED_VERTEX_POSITION
    push    {r2, lr}
    adds    r2, r2, #CACHED_VERTEX_SCREEN
    bl      fxl_project_inside
    pop     {r2, lr}
    cmp     r0, #0
    bne     .Lis_other
.Lhas_place:
    movw    r0, #0x7FFF
    add     r1, r1, r0
    add     r3, r3, r0
    lsrs    r1, r1, #16
    lsrs    r3, r3, #16
    lsls    r3, r3, #20
    orr     flags, r3, r1, lsl #8
    str     flags, [vertex, #CACHED_VERTEX_CLIP_FLAGS]
    bx      lr

.Lrange_of_inside:
    movs    r1, #VERTEX_UNPROJECTED
    str     r1, [vertex, #CACHED_VERTEX_CLIP_FLAGS]
    b       .Lis_other

    .size fxl_find_inside_corners, . - fxl_find_inside_corners
#endif

#endif
