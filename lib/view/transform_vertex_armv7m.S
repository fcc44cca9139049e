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

entry       .req r2
view        .req r3
planes      .req lr         /* in the lowest byte */

/* upper:r10 is the vertex along an axis plus its part of the translation; it goes into the entry.
 * r0 is the model view, r1 the address of the axis, then of the next. */
    .macro  along number upper
    ldm     r1!, {r4-r6}
    ldrd    r10, \upper, [r0, #MODEL_VIEW_TRANSLATION + 8 * \number]
    smlal   r10, \upper, r4, r7
    smlal   r10, \upper, r5, r8
    smlal   r10, \upper, r6, r9
    strd    r10, \upper, [entry, #CACHED_VERTEX_POSITION + 8 * \number]
    .endm

/* Transforms a vertex. r0: model_view, r1: number, r2: entry. \quick: 12 instructions less for a vertex
 * inside, and 7 more for another. \at is the end of these names. Continues
 *
 *   at .Linside     if it is inside all planes; view is the frustum in the view
 *   at .Lwithin     if no vertex is outside a plane; view is the view
 *   at .Ldecided    with its clip flags in r1, if they may be 0
 *   at .Lundecided  if fxl_outcode must find its clip flags
 *   at .Lscaled     if the instance is scaled */
    .macro  transform at, quick=1
    push    {r0, r4-r11, lr}
    ldm     r0, {r3-r7}                     /* view, -, -, tag, vertices */
    add     r6, r6, r1
    str     r6, [entry]
    add     r1, r1, r1, lsl #1
    add     r7, r7, r1, lsl #2
    ldm     r7, {r7-r9}
    ldrd    r1, planes, [r0, #MODEL_VIEW_AXES]
    along   0, r11
    along   1, r12
    along   2, r0                           /* the last use of the model view */

    lsls    r1, planes, #24
    beq     .Lwithin\at
    bmi     .Lscaled\at
    adds    view, view, #VIEW_FRUSTUM
    ldm     view, {r4-r7}
    ldr     r9, [view, #FRUSTUM_INSET_UPPER]
    smull   r1, r4, r4, r11
    smull   r1, r5, r5, r0
    smull   r1, r6, r6, r12
    smull   r1, r7, r7, r0
    .if     \quick
    adds    r9, r9, #20
    .else
    subs    r9, r9, #16
    .endif
    sub     r5, r5, r9, asr #2
    sub     r7, r7, r9, asr #2
    .if     \quick

    /* Most are inside: both distances of a pair are at least the depth's term less the magnitude of the
     * side's. They are 5 smaller here, not 4 larger. Upper words of z that differ decide. All of these are
     * negative then. */
    eor     r8, r4, r4, asr #31
    eor     r9, r6, r6, asr #31
    sub     r8, r8, r5
    sub     r9, r9, r7
    ldr     r1, [view, #FRUSTUM_NEAR_Z + 4]
    ldr     r11, [view, #FRUSTUM_FAR_Z + 4]
    and     r8, r8, r9
    sub     r1, r1, r0
    sub     r11, r0, r11
    and     r8, r8, r1
    ands    r8, r8, r11
    bmi     .Linside\at

    adds    r5, r5, #9
    adds    r7, r7, #9
    .endif
    add     r8, r5, r4                      /* left; 4 larger: 0..7 is undecided */
    sub     r11, r5, r4                     /* right */
    add     r12, r7, r6                     /* bottom */
    sub     r9, r7, r6                      /* top */
    cmp     r8, #8
    ittt    hs
    cmphs   r11, #8
    cmphs   r12, #8
    cmphs   r9, #8
    blo     .Lundecided\at

    ldrd    r4, r5, [view, #FRUSTUM_NEAR_Z] /* near_z, far_z */
    ldrd    r6, r7, [view, #FRUSTUM_FAR_Z]
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

    .endm

/* Both leave the clip flags in r1, and keep r2. */
    .macro  find_clip_flags
    mov     r4, entry
    mov     r0, view
    uxtb    r1, planes
    add     r2, entry, #CACHED_VERTEX_POSITION
    bl      fxl_outcode
    mov     entry, r4
    orr     r1, r0, #VERTEX_UNPROJECTED
    str     r1, [entry, #CACHED_VERTEX_CLIP_FLAGS]
    .endm

    .macro  scale_vertex
    mov     r4, entry
    ldr     r0, [sp]                        /* the model view */
    mov     r1, entry
    ldr     r3, [r0, #MODEL_VIEW_SCALE_VERTEX]
    blx     r3
    mov     r1, r0
    mov     entry, r4
    .endm

    .section .text.fxl_transform_vertex, "ax", %progbits
    .global fxl_transform_vertex
    .type fxl_transform_vertex, %function
    .thumb_func

/* r0: model_view, r1: number, r2: entry. For fxl_clip_by_view and fxl_next_front_face r1 returns the clip
 * flags, r2 is kept, and r3 returns the model view. */
fxl_transform_vertex:
    transform , 0
    b       .Ldecided
.Lwithin:
.Linside:
    movs    r1, #0
.Ldecided:
    orr     r1, r1, #VERTEX_UNPROJECTED
    str     r1, [entry, #CACHED_VERTEX_CLIP_FLAGS]
    pop     {r3-r11, pc}
.Lundecided:
    find_clip_flags
    pop     {r3-r11, pc}
.Lscaled:
    scale_vertex
    pop     {r3-r11, pc}

    .size fxl_transform_vertex, . - fxl_transform_vertex

#if !FXL_IS_COMPACT
    .section .text.fxl_transform_and_project, "ax", %progbits
    .global fxl_transform_and_project
    .hidden fxl_transform_and_project
    .type fxl_transform_and_project, %function
    .thumb_func

/* The same for fxl_clip_by_view, and a vertex that is inside all planes is projected in the same
 * frame on the stack: 30 cycles less on a Cortex-M3. r0 returns what fxl_project_inside returns,
 * with r1, r2 and r3: then the clip flags are not stored. Or r0 returns -1: they are in r1 and in
 * the entry, as the vertex is outside a plane. */
fxl_transform_and_project:
    transform _and
.Ldecided_and:
    cmp     r1, #0
    beq     .Linside_and
    orr     r1, r1, #VERTEX_UNPROJECTED
    str     r1, [entry, #CACHED_VERTEX_CLIP_FLAGS]
.Loutside_and:
    mov     r0, #-1
    pop     {r3-r11, pc}
.Linside_and:
    subs    r0, view, #VIEW_FRUSTUM - VIEW_PROJECTION
.Lproject_and:
    add     r1, entry, #CACHED_VERTEX_POSITION
    adds    r2, r2, #CACHED_VERTEX_SCREEN
    add     sp, sp, #4                      /* below are r4-r11 and lr */
    b.w     fxl_project_inside_saved
.Lwithin_and:
    add     r0, view, #VIEW_PROJECTION
    b       .Lproject_and
.Lundecided_and:
    find_clip_flags
.Lflags_and:
    cmp     r1, #VERTEX_UNPROJECTED
    bne     .Loutside_and
    ldr     r0, [sp]                        /* the model view */
    ldr     r0, [r0, #MODEL_VIEW_VIEW]
    adds    r0, r0, #VIEW_PROJECTION
    b       .Lproject_and
.Lscaled_and:
    scale_vertex
    b       .Lflags_and

    .size fxl_transform_and_project, . - fxl_transform_and_project
#endif

#endif
