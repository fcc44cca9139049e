/* SPDX-License-Identifier: MIT */
/* fxl_transform_vertex for Armv6-M. lib/math/arith.h (fxl_dot) and
 * lib/view/outcode.h define the sums and derive their bounds. A product of 32 by 32 bits
 * is made of four products of 16 by 16. One factor is at most 2^30 and the other is below
 * 2^30, so the sum of the two middle products fits 32 bits (core.h). */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV6M


    .syntax unified
    .thumb

/* Offsets in fxl_cached_vertex. */
#define POSITION_X (CACHED_VERTEX_POSITION + VIEW_POINT_X)
#define POSITION_Y (CACHED_VERTEX_POSITION + VIEW_POINT_Y)
#define POSITION_Z (CACHED_VERTEX_POSITION + VIEW_POINT_Z)
/* Offsets on the stack. VERTEX is its x, y, z; later the inset takes the place of x. */
#define VERTEX      0
#define INSET       0
#define MODEL_VIEW      12
#define ENTRY       16

/* Multiplies the halves of r2 and r3: r0 is the lowest product, r4 the sum of the two middle
 * products, r3 the highest. Overwrites r2 and r5. */
    .macro  products
    uxth    r4, r2
    asrs    r2, r2, #16
    uxth    r5, r3
    asrs    r3, r3, #16
    movs    r0, r4
    muls    r0, r5
    muls    r5, r2
    muls    r4, r3
    muls    r3, r2
    adds    r4, r4, r5
    .endm

/* Adds the next component of an axis times a coordinate to r7:r6. */
    .macro  add_product coordinate
    ldm     r1!, {r2}
    ldr     r3, [sp, #VERTEX + 4 * \coordinate]
    products
    lsls    r5, r4, #16
    asrs    r4, r4, #16
    adds    r0, r0, r5
    adcs    r3, r3, r4
    adds    r6, r6, r0
    adcs    r7, r7, r3
    .endm

/* The vertex along an axis plus its part of the translation goes into the entry. r1 is the address
 * of the axis, then of the next. */
    .macro  along number position
    ldr     r5, [sp, #MODEL_VIEW]
    ldr     r6, [r5, #MODEL_VIEW_TRANSLATION + 8 * \number]
    ldr     r7, [r5, #MODEL_VIEW_TRANSLATION + 8 * \number + 4]
    add_product 0
    add_product 1
    add_product 2
    ldr     r2, [sp, #ENTRY]
    str     r6, [r2, #\position]
    str     r7, [r2, #\position + 4]
    .endm

/* r0 = fxl_upper_term of a component of a normal and a coordinate of the position, less 0 or 1: it
 * leaves out the lowest product. Overwrites r2 to r5. */
    .macro  upper_term part position
    ldr     r3, [sp, #ENTRY]
    ldr     r3, [r3, #\position + 4]
    ldr     r2, [r1, #\part]
    uxth    r4, r2
    asrs    r2, r2, #16
    uxth    r5, r3
    asrs    r3, r3, #16
    muls    r5, r2
    muls    r4, r3
    muls    r3, r2
    adds    r4, r4, r5
    asrs    r0, r4, #16
    adds    r0, r0, r3
    .endm

/* r6 = the signs of the distances from a pair of side planes, the first plane in the lowest
 * bit. It branches to `undecided` if a distance from the upper words does not decide. Each true
 * term exceeds the computed one by 0 to 2.25 and the true inset exceeds the rounded one by 0 to 1,
 * so the true distance lies within -3.25..4.5 of the computed one, and -5..3 do not decide. The
 * inset is smaller by 5, so they are 0..8 here. */
    .macro  pair side depth position
    upper_term \side, \position
    movs    r6, r0
    upper_term \depth, POSITION_Z
    ldr     r2, [sp, #INSET]
    subs    r0, r0, r2
    subs    r7, r0, r6
    adds    r6, r6, r0
    cmp     r6, #9
    blo     undecided
    cmp     r7, #9
    blo     undecided
    lsrs    r6, r6, #31
    lsrs    r7, r7, #31
    lsls    r7, r7, #1
    orrs    r6, r6, r7
    .endm

/* Goes on if the position is inside a pair of side planes for sure, else it branches to sides:
 * fxl_is_within_slopes, with the upper 11 bits of a slope, and upper words without their 9 lowest bits,
 * which are below 2^20. r5: z; r2: the entry. Overwrites r3 and r4. */
    .macro  inside slope position
    ldr     r3, [r2, #\position + 4]
    asrs    r3, r3, #9
    asrs    r4, r3, #31
    eors    r3, r3, r4
    adds    r3, r3, #1
    lsls    r3, r3, #10
    ldr     r4, [r1, #\slope]
    asrs    r4, r4, #20
    muls    r4, r5
    cmp     r4, r3
    ble     sides
    .endm

    .section .text.fxl_transform_vertex, "ax", %progbits
    .global fxl_transform_vertex
    .type fxl_transform_vertex, %function
    .thumb_func

/* r0: model_view, r1: number, r2: entry */
fxl_transform_vertex:
    push    {r2, r4-r7, lr}
    sub     sp, sp, #16
    str     r0, [sp, #MODEL_VIEW]
    ldr     r3, [r0, #MODEL_VIEW_TAG]
    adds    r3, r3, r1
    str     r3, [r2]
    lsls    r3, r1, #1
    adds    r1, r1, r3
    lsls    r1, r1, #2
    ldr     r3, [r0, #MODEL_VIEW_VERTICES]
    adds    r1, r1, r3
    ldm     r1!, {r3-r5}
    ldr     r1, [r0, #MODEL_VIEW_AXES]
    mov     r6, sp
    stm     r6!, {r3-r5}
    along   0, POSITION_X
    along   1, POSITION_Y
    along   2, POSITION_Z

    movs    r6, #0
    ldr     r1, [sp, #MODEL_VIEW]
    ldrb    r0, [r1, #MODEL_VIEW_PLANES]
    lsls    r0, r0, #24
    bne     some_planes
decided:
    movs    r0, #VERTEX_UNPROJECTED
    orrs    r6, r6, r0
    str     r6, [r2, #CACHED_VERTEX_CLIP_FLAGS]
    add     sp, sp, #20
    pop     {r4-r7, pc}

scaled:
    movs    r0, r1
    movs    r1, r2
    ldr     r3, [r0, #MODEL_VIEW_SCALE_VERTEX]
    blx     r3
    add     sp, sp, #20
    pop     {r4-r7, pc}

some_planes:
    bmi     scaled
    ldr     r1, [r1]                        /* view */
    adds    r1, r1, #VIEW_FRUSTUM
    ldr     r2, [sp, #ENTRY]
    ldr     r5, [r2, #POSITION_Z + 4]
    asrs    r5, r5, #9
    inside  FRUSTUM_X_SLOPE, POSITION_X
    inside  FRUSTUM_Y_SLOPE, POSITION_Y
    ldr     r3, [r2, #POSITION_Z + 4]       /* upper words that differ decide */
    ldr     r4, [r1, #FRUSTUM_NEAR_Z + 4]
    ldr     r5, [r1, #FRUSTUM_FAR_Z + 4]
    cmp     r3, r4
    ble     sides                           /* slopes are for points beyond near_z */
    cmp     r3, r5
    bge     depths
    b       decided

undecided:
    movs    r0, r1
    ldr     r1, [sp, #MODEL_VIEW]
    ldrb    r1, [r1, #MODEL_VIEW_PLANES]
    ldr     r2, [sp, #ENTRY]
    adds    r2, r2, #POSITION_X
    bl      fxl_outcode
    movs    r6, r0
    ldr     r2, [sp, #ENTRY]
    b       decided

sides:
    ldr     r0, [r1, #FRUSTUM_INSET_UPPER]
    asrs    r0, r0, #2
    subs    r0, r0, #5
    str     r0, [sp, #INSET]
    pair    FRUSTUM_X_SIDE, FRUSTUM_X_DEPTH, POSITION_X
    mov     r12, r6
    pair    FRUSTUM_Y_SIDE, FRUSTUM_Y_DEPTH, POSITION_Y
    lsls    r6, r6, #2
    mov     r7, r12
    orrs    r6, r6, r7
    ldr     r2, [sp, #ENTRY]
depths:
    ldr     r3, [r2, #POSITION_Z]
    ldr     r4, [r2, #POSITION_Z + 4]
    ldr     r0, [r1, #FRUSTUM_FAR_Z]
    ldr     r5, [r1, #FRUSTUM_FAR_Z + 4]
    subs    r0, r0, r3
    sbcs    r5, r5, r4
    lsls    r5, r5, #1
    adcs    r6, r6
    ldr     r0, [r1, #FRUSTUM_NEAR_Z]
    ldr     r5, [r1, #FRUSTUM_NEAR_Z + 4]
    subs    r3, r3, r0
    sbcs    r4, r4, r5
    lsls    r4, r4, #1
    adcs    r6, r6
    ldr     r0, [sp, #MODEL_VIEW]
    ldrb    r0, [r0, #MODEL_VIEW_PLANES]
    ands    r6, r6, r0
    b       decided

    .size fxl_transform_vertex, . - fxl_transform_vertex

#endif
