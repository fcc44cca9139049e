/* SPDX-License-Identifier: MIT */
/* fxl_transform_vertex for Armv7-M and Armv8-M Mainline. lib/math/arith.h (fxl_dot) and
 * lib/view/outcode.h define the sums and derive their bounds.
 *
 * If the upper words of a distance do not decide a sign, fxl_outcode computes the outcode. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV7M


    .syntax unified
    .thumb

view        .req r2
entry       .req r1         /* its position */

#define AT_ENTRY 4          /* on the stack: r0, entry, r4-r11, lr */

/* \low and \high, a part of the translation, become the vertex along an axis plus it. r0 is the address of the
 * axis, then of the next. */
    .macro  along low high
    ldm     r0!, {r1, r3, lr}
    smlal   \low, \high, r1, r10
    smlal   \low, \high, r3, r11
    smlal   \low, \high, lr, r12
    .endm

/* Transforms a vertex. r0: model_view, r1: number, r2: entry, r3: tag. The position is in r4-r9: x, y, z.
 * \at is the end of these names. Continues
 *
 *   at .Linside   if it is inside all planes, or no vertex is outside one; view is the view
 *   at .Lscaled   if the instance is scaled
 *   below         with its clip flags, which may be none, in r1, their place in r2, and the position in r4 */
    .macro  transform at
    str     r3, [r2], #CACHED_VERTEX_POSITION
    push    {r0, r2, r4-r11, lr}
    ldm     r0!, {r2-r7}                    /* view, -, -, -, vertices, - */
    add     r1, r1, r1, lsl #1
    add     r6, r6, r1, lsl #2
    ldm     r6, {r10-r12}
    ldm     r0, {r0, r1, r4-r9}             /* axes, planes, translation */
    lsls    r1, r1, #24                     /* the sums keep the flags */
    along   r4, r5
    along   r6, r7
    along   r8, r9
    ldr     entry, [sp, #AT_ENTRY]
    stm     entry, {r4-r9}
    beq     .Linside\at
    bmi     .Lscaled\at

    /* fxl_is_within_slopes: all of these are negative if it is. */
    add     r0, view, #VIEW_FRUSTUM + FRUSTUM_X_SLOPE
    ldm     r0, {r0, r3, r10-r12, lr}       /* slopes, near_z, far_z */
    smull   r10, r0, r0, r9
    smull   r10, r3, r3, r9
    eor     r10, r5, r5, asr #31
    sub     r0, r10, r0, lsl #2
    eor     r10, r7, r7, asr #31
    sub     r3, r10, r3, lsl #2
    sub     r11, r11, r9
    sub     lr, r9, lr
    ands    r0, r0, r3
    and     r11, r11, lr
    ands    r0, r0, r11
    bmi     .Linside\at
    bl      fxl_find_clip_flags
    .endm

    .macro  scale_vertex
    ldr     r0, [sp]                        /* the model view */
    mov     r4, entry
    sub     r1, entry, #CACHED_VERTEX_POSITION
    sub     sp, sp, #4                      /* a call wants a multiple of 8 */
    ldr     r3, [r0, #MODEL_VIEW_SCALE_VERTEX]
    blx     r3
    add     sp, sp, #4
    mov     r1, r0
    .endm

    .section .text.fxl_transform_vertex, "ax", %progbits
    .global fxl_transform_vertex
    .type fxl_transform_vertex, %function
    .thumb_func

/* r0: model_view, r1: number, r2: entry. For fxl_clip_by_view and fxl_next_front_face r1 returns the clip
 * flags, r2 the model view, and r3 the position of the entry. */
fxl_transform_vertex:
    ldr     r3, [r0, #MODEL_VIEW_TAG]
    add     r3, r3, r1
    transform
    pop     {r2-r11, pc}
.Linside:
    mov     r3, entry
    movs    r1, #VERTEX_UNPROJECTED
    str     r1, [r3, #CACHED_VERTEX_CLIP_FLAGS - CACHED_VERTEX_POSITION]
    pop     {r2-r11, pc}
.Lscaled:
    scale_vertex
    pop     {r2-r11, pc}

    .size fxl_transform_vertex, . - fxl_transform_vertex

    .section .text.fxl_find_clip_flags, "ax", %progbits
    .global fxl_find_clip_flags
    .hidden fxl_find_clip_flags
    .type fxl_find_clip_flags, %function
    .thumb_func

/* The clip flags in r1 and in the entry, and its position in r4. r2: view, r5, r7, r8, r9: x, y and z;
 * r0, entry: on the stack. */
fxl_find_clip_flags:
    adds    view, view, #VIEW_FRUSTUM
    ldm     view, {r0, r1, r10, r11}
    ldr     r12, [view, #FRUSTUM_INSET_UPPER]
    smull   r3, r0, r0, r5
    smull   r3, r1, r1, r9
    smull   r3, r10, r10, r7
    smull   r3, r11, r11, r9
    subs    r12, r12, #16
    sub     r1, r1, r12, asr #2
    sub     r11, r11, r12, asr #2
    adds    r5, r1, r0                      /* left; 4 larger: 0..7 is undecided */
    subs    r6, r1, r0                      /* right */
    add     r7, r11, r10                    /* bottom */
    sub     r12, r11, r10                   /* top */
    ldrd    r3, r4, [sp]                    /* the model view, the position */
    ldrb    r3, [r3, #MODEL_VIEW_PLANES]
    cmp     r5, #8
    ittt    hs
    cmphs   r6, #8
    cmphs   r7, #8
    cmphs   r12, #8
    blo     .Lundecided

    ldrd    r0, r1, [view, #FRUSTUM_NEAR_Z]
    ldrd    r10, r11, [view, #FRUSTUM_FAR_Z]
    subs    r0, r8, r0
    sbc     r1, r9, r1
    subs    r10, r10, r8
    sbc     r11, r11, r9
    lsrs    r1, r1, #31                     /* signs, from the lowest bit upward; adding 4
                                               changes no sign that is decided */
    lsr     r11, r11, #31
    orr     r1, r1, r11, lsl #1
    lsrs    r5, r5, #31
    orr     r1, r1, r5, lsl #2
    lsrs    r6, r6, #31
    orr     r1, r1, r6, lsl #3
    lsrs    r7, r7, #31
    orr     r1, r1, r7, lsl #4
    lsr     r12, r12, #31
    orr     r1, r1, r12, lsl #5
    ands    r1, r1, r3
.Lflags:
    orr     r1, r1, #VERTEX_UNPROJECTED
    str     r1, [r4, #CACHED_VERTEX_CLIP_FLAGS - CACHED_VERTEX_POSITION]
    bx      lr

.Lundecided:
    mov     r0, view
    mov     r1, r3
    mov     r2, r4
    push    {lr}                            /* a call wants a multiple of 8 */
    bl      fxl_outcode
    pop     {lr}
    mov     r1, r0
    b       .Lflags

    .size fxl_find_clip_flags, . - fxl_find_clip_flags

#if !FXL_IS_COMPACT
    .section .text.fxl_transform_and_project, "ax", %progbits
    .global fxl_transform_and_project
    .hidden fxl_transform_and_project
    .type fxl_transform_and_project, %function
    .thumb_func

/* The same for fxl_clip_by_view, with its tag in r3, and a vertex that is inside all planes is projected
 * in the same frame on the stack. r0 returns what fxl_project_inside returns, with r1, r2 and r3: then the
 * clip flags are not needed. The flags are those of r0. Or r0 returns -1: they are in r1 and in the entry, as the vertex is outside a plane. */
fxl_transform_and_project:
    transform _and
.Lflags_and:
    cmp     r1, #VERTEX_UNPROJECTED
    bne     .Loutside_and
    mov     entry, r4
    ldm     entry, {r4-r9}
    ldr     view, [sp]                      /* the model view */
    ldr     view, [view, #MODEL_VIEW_VIEW]
.Linside_and:
    add     r0, view, #VIEW_PROJECTION
    sub     r2, entry, #CACHED_VERTEX_POSITION - CACHED_VERTEX_SCREEN
    add     sp, sp, #8                      /* below are r4-r11 and lr */
    b.w     fxl_project_inside_loaded
.Loutside_and:
    movs    r0, #-1
    pop     {r2-r11, pc}
.Lscaled_and:
    scale_vertex
    b       .Lflags_and

    .size fxl_transform_and_project, . - fxl_transform_and_project
#endif

#endif
