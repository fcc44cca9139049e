/* SPDX-License-Identifier: MIT */
/* fxl_front_faces for Armv6-M. lib/view/cull.h defines the sums and their bounds.
 *
 * Products of 16 by 16 bits decide most faces. Let s be the least number for which each
 * coordinate of eye / 2^s fits 16 bits with its sign, and
 *   n = 2^15 n' + f, 0 <= f < 2^15, a component of the normal,
 *   e = 2^s e' + g, 0 <= g < 2^s, a coordinate of the eye. Then
 *   n e = 2^(15 + s) n' e' + 2^15 n' g + f e.
 * |n'| sums up to less than 1.74 2^15 over the components and |e| is at most 2^(15 + s), so the
 * sum of the products n' e' is below 2^31, and what it lacks is below (1.74 + 3) 2^(30 + s).
 * In units of 2^32 that is below 1.25 2^s. The floors of the sum and of the height add less
 * than 1. So a difference of 2^(s + 1) + 1 or more has the right sign. */
#include "../math/family.h"
#include "../math/offsets.h"
#include "../math/registers_armv6m.h"

#if FXL_KERNELS_ARMV6M


    .syntax unified
    .thumb

/* Offsets on the stack; above these are r8 to r11, r4 to r7 and lr. */
#define EYE         0
#define FIRST       4       /* where the normal of face 0 would end */
#define TWICE       8       /* 2 eye */
#define SMALL       20      /* e' */
#define COUNT       68
#define END_NUMBER  72

shift   .req r8             /* 17 - s */
margin  .req r9             /* 2^(s + 1) + 1 */
end     .req r10            /* of the faces */
entry   .req r11

/* Adds to r5:r4 the square of the bounding box's coordinate less twice the eye's. Input: r1:
 * bounds. With v = 2^16 a + b, 0 <= b < 2^16, it is 2^32 a^2 + 2^17 a b + b^2; |a b| < 2^31. */
    .macro  add_square number
    ldr     r2, [r1, #FACE_BOUNDS_BOX_X + 4 * \number]
    ldr     r3, [sp, #TWICE + 4 * \number]
    subs    r2, r2, r3
    uxth    r3, r2
    asrs    r2, r2, #16
    movs    r6, r2
    muls    r6, r3
    muls    r3, r3
    muls    r2, r2
    lsls    r7, r6, #17
    asrs    r6, r6, #15
    adds    r3, r3, r7
    adcs    r2, r2, r6
    adds    r4, r4, r3
    adcs    r5, r5, r2
    .endm

    .section .text.fxl_front_faces, "ax", %progbits
    .global fxl_front_faces
    .type fxl_front_faces, %function
    .thumb_func

/* r0: faces, r1: bounds, r2: eye, r3: entry; on the stack: count, end */
fxl_front_faces:
    save_registers
    sub     sp, sp, #32
    mov     entry, r3
    str     r2, [sp, #EYE]
    ldr     r4, [sp, #COUNT]
    ldr     r6, [sp, #END_NUMBER]
    subs    r6, r6, r4              /* the first face's number */
    movs    r5, #FACE_SIZE
    muls    r4, r5
    adds    r4, r4, r0
    mov     end, r4
    muls    r6, r5
    movs    r3, r0
    adds    r3, r3, #FACE_COUNT
    subs    r3, r3, r6
    str     r3, [sp, #FIRST]
    ldm     r2!, {r5-r7}
    add     r4, sp, #TWICE
    lsls    r2, r5, #1
    lsls    r3, r6, #1
    stm     r4!, {r2, r3}
    lsls    r2, r7, #1
    str     r2, [r4]
    asrs    r2, r5, #31             /* the bits of all magnitudes */
    eors    r2, r2, r5
    asrs    r3, r6, #31
    eors    r3, r3, r6
    orrs    r2, r2, r3
    asrs    r3, r7, #31
    eors    r3, r3, r7
    orrs    r2, r2, r3
    lsrs    r2, r2, #15
    movs    r3, #17
    movs    r4, #2
    b       2f
1:  lsls    r4, r4, #1
    subs    r3, r3, #1
    lsrs    r2, r2, #1
2:  bne     1b
    mov     shift, r3
    adds    r4, r4, #1
    mov     margin, r4
    movs    r2, #17
    subs    r2, r2, r3
    asrs    r5, r5, r2
    asrs    r6, r6, r2
    asrs    r7, r7, r2
    add     r4, sp, #SMALL
    stm     r4!, {r5-r7}

.Lface:
    ldm     r0!, {r2-r4}
    asrs    r2, r2, #15
    muls    r2, r5
    asrs    r3, r3, #15
    muls    r3, r6
    asrs    r4, r4, #15
    muls    r4, r7
    adds    r2, r2, r3
    adds    r2, r2, r4
    mov     r3, shift
    asrs    r2, r2, r3
    ldr     r3, [r1, #FACE_BOUNDS_HEIGHT_HIGH]
    subs    r2, r2, r3
    mov     r3, margin
    cmn     r2, r3
    ble     .Lnext                  /* turned away */
    cmp     r2, r3
    blt     .Lexact

.Lfront:
    movs    r4, #0
    movs    r5, #0
    add_square 0
    add_square 1
    add_square 2
    ldr     r3, [sp, #FIRST]
    subs    r6, r0, r3              /* 20 times its number */
    ldr     r3, =0xCCCCCCCD         /* 1/5 modulo 2^32 */
    muls    r6, r3
    lsrs    r6, r6, #2              /* its number, and 0 beside it */
    mov     r3, entry
    stm     r3!, {r4-r6}
    mov     entry, r3
.Lload:
    add     r4, sp, #SMALL
    ldm     r4!, {r5-r7}
.Lnext:
    adds    r0, r0, #FACE_SIZE - FACE_COUNT
    adds    r1, r1, #FACE_BOUNDS_SIZE
    cmp     r0, end
    bne     .Lface
    mov     r0, entry
    add     sp, sp, #32
    restore_and_return

.Lexact:
    movs    r6, r0
    movs    r7, r1
    subs    r0, r0, #FACE_COUNT
    ldr     r2, [sp, #EYE]
    bl      fxl_bounded_face_is_front
    movs    r2, r0
    movs    r0, r6
    movs    r1, r7
    cmp     r2, #0
    bne     .Lfront
    b       .Lload

    .pool
    .size fxl_front_faces, . - fxl_front_faces

#endif
