/* SPDX-License-Identifier: MIT */
/* fxl_find_smooth_words, fxl_find_colour_planes and fxl_find_texel_planes for Armv7-M and Armv8-M Mainline.
 * lib/paint/corner_planes.h and smooth_outline.h state what they require and return; they give the
 * same bits as the texts in corner_planes.c and corner_colours.c, which derive the bounds. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_KERNELS_ARMV7M && !FXL_IS_COMPACT

    .syntax unified
    .thumb

#define X         0 /* on the stack; then y */
#define LEAST     8 /* weight; then the range of the weights */
#define EXPONENT  16
#define CROSSED   20 /* of a face that crosses the end of octave r0: r0 + 1; of others 0 */
#define OWN_SIZE  24
#define CORNERS   (OWN_SIZE + 0)
#define APART     CORNERS /* two weights less the first one: in place of corners and lens */
#define LENS      (OWN_SIZE + 4)
#define LIGHT     (OWN_SIZE + 8)
#define VALUES    LIGHT
#define BORDER    CROSSED /* of fxl_find_colour_planes */
#define WORDS     (OWN_SIZE + 12)
#define OUTLINE   WORDS           /* of fxl_find_colour_planes */
#define TEXEL_LIGHT (OWN_SIZE + 52)
#define IS_AFFINE (OWN_SIZE + 56)
#define V_DROP    (OWN_SIZE + 60)

#include "smooth_words_armv7m.h"
#include "colour_channels_armv7m.h"

/* The planes of a face; kind: _light, _colours or _texels; range: the longest side less the least; thin:
 * 0: it may be neither thin nor steep. r0: corners, r1: fxl_words_lens, r2: light, or corners, r3:
 * words, of colours the face; of texels on the stack: light, is_affine, v_drop. */
    .macro find_planes kind, range, thin
    push    {r0-r11, lr}
    sub     sp, sp, #OWN_SIZE
    ldrd    r4, r5, [r0, #SCREEN_CORNERS_WIDTH]
    sub     r6, r4, #1 << 14
    sub     r7, r5, #1 << 14
    cmp     r6, #\range
    it      ls
    cmpls   r7, #\range
    bhi     .Lrefused\kind

    /* The edges: r8: x1, r9: y1, r10: x2, r11: y2; the area. */
    ldm     r0, {r6-r11}
    sub     r8, r8, r6
    sub     r9, r7, r9
    sub     r10, r6, r10
    sub     r11, r11, r7
    sub     r6, r6, #32768
    sub     r7, r7, #32768
    strd    r6, r7, [sp, #X]
    smull   r12, lr, r8, r11
    smull   r1, r2, r10, r9
    subs    r12, r12, r1
    sbcs    lr, lr, r2
    bmi     .Lturned\kind
.Lclockwise\kind:
    orr     r3, r4, r5
    clz     r3, r3
    subs    r3, r3, #1              /* what scales the edges */
    umull   r1, r2, r4, r5          /* the box */
    lsl     r6, lr, #3
    orr     r6, r6, r12, lsr #29
    lsl     r7, r12, #3
    cmp     r7, r1
    sbcs    r6, r6, r2
    blo     .Lthin_area\kind
.Lfilled\kind:

    /* r1: the exponent, r6: the reciprocal of the area, r8-r11: the coefficients. */
    cmp     lr, #0
    beq     .Lsmall_area\kind
    clz     r1, lr
    rsb     r2, r1, #32
    lsl     lr, lr, r1
    lsr     r12, r12, r2
    orr     r12, r12, lr
    rsb     r1, r1, #46
.Lmantissa\kind:
    bic     r6, r12, #1
    orr     r6, r6, #2
    reciprocal r6, r2, r7
    add     r1, r1, r3
    coefficient r8                  /* down[1] */
    coefficient r9                  /* along[1] */
    coefficient r10                 /* down[0] */
    coefficient r11                 /* along[0] */
    str     r1, [sp, #EXPONENT]
    cmp     r4, r5
    it      hi
    movhi   r4, r5                  /* the shorter side, or all ones */

    /* The weights, r3, r6, r12; r0: 32 less their exponent, negated. */
    adds    r0, r0, #SCREEN_CORNERS_DEPTHS
    ldm     r0, {r2, r3, r5, r6, r7, r12}
    orr     r0, r3, r6
    orrs    r0, r0, r12
    beq     .Lrefused\kind
    clz     r0, r0
    rsb     lr, r0, #32
    lower_of_shifted r2, r3, lr, r0
    lower_of_shifted r5, r6, lr, r0
    lower_of_shifted r7, r12, lr, r0
    cmp     r2, #1 << 30
    itt     hs
    cmphs   r5, #1 << 30
    cmphs   r7, #1 << 30
    blo     .Lrefused\kind
    umull   lr, r3, r5, r7
    umull   lr, r6, r2, r7
    umull   lr, r12, r2, r5
    orr     r5, r3, r6
    orr     r5, r5, r12
    clz     r5, r5
    lsls    r3, r3, r5
    lsls    r6, r6, r5
    lsl     r12, r12, r5
    lsrs    r3, r3, #1
    lsrs    r6, r6, #1
    lsr     r12, r12, #1
    ldr     r7, [sp, #LENS]
    ldrd    r7, lr, [r7]
    sub     r0, lr, r0
    upper_product r2, r3, lr
    clz     r5, r2
    orr     r2, r2, #1
    lsls    r2, r2, r5
    subs    r0, r0, r5
    reciprocal r2, r5, lr
    upper_product r7, r2, lr        /* the factor */
    upper_product r3, r7, lr
    upper_product r6, r7, lr
    upper_product r12, r7, lr
    .ifc    \kind, _colours
    sub     lr, r6, r3
    sub     r7, r12, r3
    ends_of_differences r5, r2, lr, r7
    .else
    sub     r6, r6, r3
    sub     r12, r12, r3
    ends_of_differences r5, r2, r6, r12
    .endif
    subs    r1, r5, r2
    add     r5, r5, r3              /* the greatest weight */
    add     r2, r2, r3              /* the least one */
    strd    r2, r1, [sp, #LEAST]
    umull   lr, r7, r5, r4
    subs    lr, lr, r1, lsl #20
    sbcs    r7, r7, r1, lsr #12
    blo     .Lsteep\kind                 /* they differ much for the shorter side */
.Lmay_be_steep\kind:

    /* The octave r0 of the lens's, r1, and at most the one beyond it, where r7 is 1; r2: bits of a code,
     * less 1, lr: zeros of the weights. */
    clz     lr, r5
    clz     r7, r2
    adds    r0, r0, lr
    bmi     .Lrefused\kind
    sub     r7, r7, lr
    cmp     r7, #1
    bhi     .Lrefused\kind
    ldr     r1, [sp, #LENS]
    adds    r5, r0, r7
    ldrd    r1, r2, [r1, #WORDS_LENS_OCTAVES]
    cmp     r5, r1
    bhs     .Lrefused\kind
    .ifnc   \kind, _colours
    muls    r7, r5, r7
    str     r7, [sp, #CROSSED]
    .endif
    subs    r1, r1, r0
    subs    r1, r1, #2
    lsls    r1, r1, r2              /* the bias */
    .ifc    \kind, _colours
    cmp     r7, #0
    bne     .Lcrossed_colours
.Lhave_border:
    str     r7, [sp, #BORDER]
    .endif
    rsb     r7, lr, #31
    subs    r7, r7, r2              /* bits of a weight below a code's */
    negs    r5, r7
    lsr     r0, r3, r7
    lsl     r5, r3, r5              /* one of the two is 0, or both are equal */
    orrs    r0, r0, r5
    add     r0, r0, r1
    add     r0, r0, #65536          /* the code of corner 0 */

    /* The plane of depth: r3:r2 and r6:r5 become along and down. */
    .ifc    \kind, _colours
    shorten_weights
    sub     r6, r6, r3
    sub     r12, r12, r3
    .endif
    .ifc    \kind, _light
    strd    r6, r12, [sp, #APART]
    .endif
    smull   r2, r3, r6, r11
    smlal   r2, r3, r12, r9
    smull   r5, r6, r6, r10
    smlal   r5, r6, r12, r8
    ldr     r1, [sp, #EXPONENT]
    add     r7, r7, r1
    .if     \thin
    cmp     r4, #0
    bmi     .Lsteep_depth\kind
    .endif
.Lnot_steep\kind:
    rsbs    r12, r7, #32
    ble     .Lupper_words\kind
    lower_of_shifted r2, r3, r7, r12
    lower_of_shifted r5, r6, r7, r12
.Lsteps\kind:
    ldrd    r3, r6, [sp, #X]
    smull   r7, r12, r2, r3
    smlal   r7, r12, r5, r6
    lsrs    r7, r7, #16
    orr     r7, r7, r12, lsl #16
    subs    r0, r0, r7
    .ifc    \kind, _texels
    find_texels
    .endif
    .ifc    \kind, _colours
    ldr     r12, [sp, #OUTLINE]
    strd    r0, r5, [r12, #COLOUR_OUTLINE_CODE]
    str     r2, [r12, #COLOUR_OUTLINE_CODE_ALONG]
    ldr     r0, [sp, #BORDER]
    str     r0, [r12, #COLOUR_OUTLINE_BORDER]
    find_channels
    .endif
    .ifc    \kind, _light
    ldr     r7, [sp, #WORDS]
    strd    r2, r0, [r7]
    str     r5, [r7, #8]
    find_light
    .endif
.Lreturn\kind:
    add     sp, sp, #OWN_SIZE + 16
    pop     {r4-r11, pc}

.Lrefused\kind:
    movs    r0, #0
    b       .Lreturn\kind

    /* The triangle fills less than 1/16 of the box. It has to fill 1/2^(\thin + 1). */
.Lthin_area\kind:
    .if     \thin == 0
    b       .Lrefused\kind
    .else
    lsl     r6, lr, #\thin
    orr     r6, r6, r12, lsr #32 - \thin
    lsl     r7, r12, #\thin
    cmp     r7, r1
    sbcs    r6, r6, r2
    blo     .Lrefused\kind
    mvn     r4, #0                  /* it may be steep */
    mvn     r5, #0
    b       .Lfilled\kind
    .endif

    /* Its corners go the other way round. */
.Lturned\kind:
    rsbs    r12, r12, #0
    sbc     lr, lr, lr, lsl #1
    .irp    edge, r8, r9, r10, r11
    rsb     \edge, \edge, #0
    .endr
    b       .Lclockwise\kind

.Lsmall_area\kind:
    clz     r1, r12
    lsl     r12, r12, r1
    rsb     r1, r1, #14
    b       .Lmantissa\kind

.Lsteep\kind:
    .if     \thin == 0
    b       .Lrefused\kind
    .else
    mvn     r4, #0
    b       .Lmay_be_steep\kind
    .endif

    .ifc    \kind, _light
    find_light_mean
    .endif
    .ifc    \kind, _colours
    find_channel_mean
.Lcrossed_colours:
    lsls    r7, r7, r2
    add     r7, r7, r1
    add     r7, r7, #65536
    b       .Lhave_border
    .endif

    .if     \thin
    /* The depth may change by the largest weight a pixel. */
.Lsteep_depth\kind:
    rsb     lr, lr, #32
    add     lr, lr, r1
    sub     lr, lr, #33
    eor     r12, r3, r3, asr #31
    lsrs    r12, r12, lr
    bne     .Lrefused\kind
    eor     r12, r6, r6, asr #31
    lsrs    r12, r12, lr
    bne     .Lrefused\kind
    b       .Lnot_steep\kind
    .endif

.Lupper_words\kind:
    subs    r7, r7, #32
    asr     r2, r3, r7
    asr     r5, r6, r7
    b       .Lsteps\kind
    .endm

    .section .text.fxl_find_smooth_words, "ax", %progbits
    .global fxl_find_smooth_words
    .type fxl_find_smooth_words, %function
    .thumb_func
fxl_find_smooth_words:
    find_planes _light, 127 << 16, 9 /* FXL_WORDS_SIDE_MAX */
    .size fxl_find_smooth_words, . - fxl_find_smooth_words

    .section .text.fxl_find_colour_planes, "ax", %progbits
    .global fxl_find_colour_planes
    .type fxl_find_colour_planes, %function
    .thumb_func
fxl_find_colour_planes:
    find_planes _colours, 127 << 16, 6
    .size fxl_find_colour_planes, . - fxl_find_colour_planes

    .section .text.fxl_find_texel_planes, "ax", %progbits
    .global fxl_find_texel_planes
    .type fxl_find_texel_planes, %function
    .thumb_func
fxl_find_texel_planes:
    find_planes _texels, 256 << 14, 4 /* FXL_TEXELS_SIDE_MAX */
    .size fxl_find_texel_planes, . - fxl_find_texel_planes

#endif
