/* SPDX-License-Identifier: MIT */
/* fxl_find_smooth_planes, fxl_find_colour_planes and fxl_find_texel_planes for Armv7-M and Armv8-M Mainline.
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
#define ROW       CROSSED /* when that is stored */
#define GRADIENTS (OWN_SIZE + 12)
#define DEPTH     (OWN_SIZE + 52)
#define WORDS     GRADIENTS       /* of fxl_find_texel_planes */
#define COUNT     (OWN_SIZE + 52)
#define IS_AFFINE (OWN_SIZE + 56)

/* \value, whose highest bit is set, becomes the value of its reciprocal as of fxl_reciprocal_of.
 * Overwrites \spare and \other. */
    .macro reciprocal value, spare, other
    mvn     \spare, #0x80000000
    lsr     \other, \value, #16
    udiv    \spare, \spare, \other
    mul     \other, \spare, \spare
    umull   \other, \value, \other, \value
    rsb     \value, \value, \spare, lsl #16
    sub     \value, \value, \value, lsr #31
    .endm

/* The upper word of \value * \factor, in \value. */
    .macro upper_product value, factor, spare
    umull   \spare, \value, \value, \factor
    .endm

/* \edge becomes a coefficient; r2: the shift, r6: the reciprocal of the area. */
    .macro coefficient edge
    lsl     \edge, \edge, r2
    smull   r7, \edge, \edge, r6
    .endm

/* \most and \least become those of three words. */
    .macro extremes most, least, a, b, c
    mov     \most, \a
    cmp     \b, \a
    it      hi
    movhi   \most, \b
    cmp     \c, \most
    it      hi
    movhi   \most, \c
    mov     \least, \a
    cmp     \b, \a
    it      lo
    movlo   \least, \b
    cmp     \c, \least
    it      lo
    movlo   \least, \c
    .endm

/* The lower word of \high:\low / 2^\drop, in \low; \up: 32 - \drop. 0 < \drop < 32. */
    .macro lower_of_shifted low, high, drop, up
    lsr     \low, \low, \drop
    lsl     \high, \high, \up
    orr     \low, \low, \high
    .endm

/* A value r0 of corner 0, and what the other two have more, r2 and r5, become the word at the first
 * centre, r0, and its changes along, r4, and down, r12. r1: the drop + \more, then the drop; r3, r6: where
 * corner 0 is; r8-r11: the coefficients. Goes to \refused where they are no words. */
    .macro words_of_values more, refused
    smull   r4, r7, r2, r11
    smlal   r4, r7, r5, r9
    smull   r12, lr, r2, r10
    smlal   r12, lr, r5, r8
    eor     r2, r7, r7, asr #31
    eor     r5, lr, lr, asr #31
    orr     r2, r2, r5
    sub     r5, r1, #\more + 1
    lsrs    r2, r2, r5
    bne     \refused
    .if     \more
    sub     r1, r1, #\more
    .endif
    rsb     r2, r1, #32
    lower_of_shifted r4, r7, r1, r2
    lower_of_shifted r12, lr, r1, r2
    smull   r5, r7, r4, r3
    smlal   r5, r7, r12, r6
    lsr     r5, r5, #16
    orr     r5, r5, r7, lsl #16
    rsb     r0, r5, r0, lsl #8
    .endm

/* Light, if it is nearly affine: r7:r4 and lr:r12 become along and down. */
    .macro find_light
    ldr     r7, [sp, #LIGHT]
    ldm     r7, {r0, r2, r5}
    extremes r7, r12, r0, r2, r5
    sub     r7, r7, r12
    ldrd    r4, r12, [sp, #LEAST]
    umull   r7, r12, r7, r12
    sub     r2, r2, r0
    sub     r5, r5, r0
    lsl     lr, r4, #15             /* 4 FXL_AFFINE_ERROR_LIGHT */
    subs    lr, lr, r7
    lsr     r4, r4, #17
    sbcs    r4, r4, r12
    blo     .Ltwisted_light
.Lbalanced_light:
    words_of_values 8, .Lrefused_light
    ldr     r5, [sp, #GRADIENTS]
    asr     r1, r0, #31
    strd    r0, r1, [r5, #GRADIENTS_ATTRIBUTES + GRADIENT_AT]
    asr     r1, r4, #31
    strd    r4, r1, [r5, #GRADIENTS_ATTRIBUTES + GRADIENT_ALONG]
    asr     r1, r12, #31
    strd    r12, r1, [r5, #GRADIENTS_ATTRIBUTES + GRADIENT_DOWN]
    movs    r0, #0
    mov     r1, #1 << 29            /* FXL_CONSTANT_WEIGHT */
    strd    r0, r1, [r5, #GRADIENT_AT]
    strd    r0, r0, [r5, #GRADIENT_ALONG]
    strd    r0, r0, [r5, #GRADIENT_DOWN]
    movs    r0, #53
    strb    r0, [r5, #GRADIENTS_SHIFTS]
    movs    r0, #1
    strb    r0, [r5, #GRADIENTS_COUNT]
    strd    r0, r0, [r5, #GRADIENTS_WEIGHT_MIN]
    .endm

/* Light at corner 0 gets the mean of the error, as mean_of_error finds it. r12:r7: the product. */
    .macro find_light_mean
.Ltwisted_light:
    ldr     r4, [sp, #LEAST]
    lsl     lr, r4, #16             /* 4 FXL_WORDS_ERROR_LIGHT */
    subs    lr, lr, r7
    lsr     lr, r4, #16
    sbcs    lr, lr, r12
    blo     .Lrefused_light
    ldrd    r7, lr, [sp, #APART]
    rsb     r4, lr, r7, lsl #1
    rsb     r7, r7, lr, lsl #1
    smull   r12, lr, r2, r4
    smlal   r12, lr, r5, r7
    lsr     r12, r12, #24
    orr     r12, r12, lr, lsl #8
    ldrd    r4, r7, [sp, #LEAST]
    add     r7, r7, r4, lsl #1
    add     r7, r7, r7, lsr #1
    lsr     r7, r7, #22
    sdiv    r12, r12, r7
    add     r0, r0, r12
    b       .Lbalanced_light
    .endm

/* The words of attribute \number; chord: a macro that leaves the product of the least weight, r7, and
 * four times what the chord may be off by in r7 and lr. r1: the drop; r3, r6: x, y; r8-r11: the
 * coefficients. Overwrites the others. */
    .macro texel_words number, chord, has_texels
    ldr     r7, [sp, #VALUES]
    ldrd    r0, r2, [r7, #12 * \number]
    ldr     r5, [r7, #12 * \number + 8]
    sub     r2, r2, r0
    sub     r5, r5, r0
    .if     \has_texels
    eor     r4, r2, r2, asr #31
    eor     r7, r5, r5, asr #31
    orr     r4, r4, r7
    lsrs    r4, r4, #23             /* 128 texels */
    bne     .Lrefused_texels
    .endif
    cmp     r2, r5
    ittee   gt
    movgt   r4, r2
    movgt   r12, r5
    movle   r4, r5
    movle   r12, r2
    bic     r4, r4, r4, asr #31
    and     r12, r12, r12, asr #31
    sub     r4, r4, r12             /* the range */
    ldrd    r7, r12, [sp, #LEAST]
    umull   r4, r12, r4, r12
    \chord
    subs    r7, r7, r4
    sbcs    lr, lr, r12
    blo     .Lrefused_texels
    words_of_values 0, .Lrefused_texels
    ldr     r5, [sp, #WORDS]
    str     r0, [r5, #4 + 4 * \number]
    str     r12, [r5, #TEXEL_OUTLINE_DOWN + 4 + 4 * \number]
    str     r4, [r5, #TEXEL_OUTLINE_ALONG + 4 + 4 * \number]
    .endm

    .macro chord_of_texels
    movw    lr, #(4 * 19660) & 0xFFFF /* 4 FXL_WORDS_ERROR_TEXEL */
    movt    lr, #(4 * 19660) >> 16
    umull   r7, lr, r7, lr
    .endm

    .macro chord_of_light
    lsr     lr, r7, #16             /* 4 FXL_WORDS_ERROR_LIGHT */
    lsl     r7, r7, #16
    .endm

/* Code r0 and its changes r2, r5, texels, and light where it is a third attribute. Where the face is
 * affine its weights count as equal. */
    .macro find_texels
    ldr     r7, [sp, #WORDS]
    str     r0, [r7]
    str     r5, [r7, #TEXEL_OUTLINE_DOWN]
    str     r2, [r7, #TEXEL_OUTLINE_ALONG]
    ldr     r7, [sp, #IS_AFFINE]
    cbz     r7, .Lperspective
    movs    r7, #0
    str     r7, [sp, #LEAST + 4]
.Lperspective:
    sub     r1, r1, #8
    texel_words 0, chord_of_texels, 1
    texel_words 1, chord_of_texels, 1
    ldr     r0, [sp, #COUNT]
    cmp     r0, #3
    bne     .Lhave_words
    texel_words 2, chord_of_light, 0
.Lhave_words:
    ldr     r0, [sp, #CROSSED]
    orr     r0, r0, #1 << 31
    .endm

/* The differences of two weights from the first one, r3, r6, r12, of which the least has 15 bits. */
    .macro shorten_weights
    ldr     r1, [sp, #LEAST]
    clz     r2, r1
    rsb     r2, r2, #17
    lsr     r1, r3, r2
    lsr     r5, r6, r2
    lsr     r2, r12, r2
    subs    r5, r5, r1
    subs    r2, r2, r1
    strd    r5, r2, [sp, #APART]
    .endm

/* A channel of the values at r7, in r0, along, in r4, and down, in r1. r3, r6: where corner 0 is,
 * lr: what moves a difference up. */
    .macro find_channel offset
    ldr     r0, [r7, #\offset]
    ldrd    r1, r2, [r7, #\offset + 4]
    lsl     r1, r1, lr
    lsl     r2, r2, lr
    smull   r5, r4, r1, r11
    smlal   r5, r4, r2, r9
    smull   r5, r1, r1, r10
    smlal   r5, r1, r2, r8
    smull   r5, r2, r4, r3
    smlal   r5, r2, r1, r6
    ldr     r5, [sp, #ROW]
    rsb     r0, r2, r0, lsl #6
    mls     r0, r1, r5, r0
    .endm

#define FIRST  GRADIENTS_ATTRIBUTES
#define SECOND (GRADIENTS_ATTRIBUTES + GRADIENT_SIZE)

/* The three channels, if a constant weight changes none too much. r7: the values of a channel,
 * whose second and third become differences from the first; r12: their end. */
    .macro find_channels
    ldr     r7, [sp, #VALUES]
    ldrd    r4, r5, [sp, #LEAST]
    add     r12, r7, #COLOUR_VALUES_LIMIT
    ldr     r2, [r12]
    cmp     r5, r4, lsr #7
    it      hi
    cmphi   r2, #0
    bls     .Lany_bend              /* weights are near, or are not asked for */
    clz     r0, r4
    rsb     r0, r0, #17
    lsrs    r4, r4, r0
    mul     r5, r2, r4
    ldrd    r3, r6, [sp, #APART]

    /* r4: the least weight, r3, r6: the others less the first one, r5: what needs no mean. */
.Lbend:
    ldm     r7, {r0, r1, r2}
    subs    r1, r1, r0
    subs    r2, r2, r0
    strd    r1, r2, [r7, #4]
    asrs    r1, r1, #8
    asrs    r2, r2, #8
    subs    r0, r2, r1
    sub     lr, r6, r3
    mul     r1, r3, r1
    mul     r2, r6, r2
    mul     r0, lr, r0
    add     lr, r1, r5
    cmp     lr, r5, lsl #1
    itt     ls
    addls   lr, r2, r5
    cmpls   lr, r5, lsl #1
    itt     ls
    addls   lr, r0, r5
    cmpls   lr, r5, lsl #1
    bhi     .Lmean
.Lbalanced:
    adds    r7, r7, #12
    cmp     r7, r12
    bne     .Lbend
.Ldifferences:
    ldr     r7, [sp, #VALUES]
    ldr     r0, [sp, #EXPONENT]
    mov     lr, #9
    subs    r0, r0, #29
    blt     .Lshort_side
    asr     r8, r8, r0
    asr     r9, r9, r0
    asr     r10, r10, r0
    asr     r11, r11, r0
.Lscaled:
    ldrd    r3, r6, [sp, #X]
    ldr     r12, [sp, #GRADIENTS]
    add     r0, r6, #32768
    add     r1, r3, #32768
    asrs    r0, r0, #16
    asrs    r1, r1, #16
    str     r0, [sp, #ROW]
    str     r1, [r12, #FIRST + GRADIENT_AT + 4]
    lsls    r3, r3, #16
    lsls    r6, r6, #16
    find_channel 0
    add     r0, r0, #1024
    str     r0, [r12, #FIRST + GRADIENT_AT]
    str     r1, [r12, #FIRST + GRADIENT_DOWN]
    str     r4, [r12, #SECOND + GRADIENT_ALONG]
    add     r4, r4, #1024
    asrs    r4, r4, #11
    str     r4, [r12, #FIRST + GRADIENT_ALONG]
    find_channel 12
    lsls    r4, r4, #4
    str     r0, [r12, #SECOND + GRADIENT_AT]
    str     r1, [r12, #FIRST + GRADIENT_DOWN + 4]
    str     r4, [r12, #FIRST + GRADIENT_ALONG + 4]
    find_channel 24
    add     r0, r0, #1024
    ldr     r2, [r12, #FIRST + GRADIENT_ALONG]
    str     r0, [r12, #SECOND + GRADIENT_AT + 4]
    str     r4, [r12, #SECOND + GRADIENT_ALONG + 4]
    add     r4, r4, #1024
    asrs    r4, r4, #11
    add     r2, r2, r4, lsl #16
    asrs    r5, r1, #31
    str     r2, [r12, #FIRST + GRADIENT_ALONG]
    strd    r1, r5, [r12, #SECOND + GRADIENT_DOWN]
    movs    r0, #0
    mov     r1, #1 << 29            /* FXL_CONSTANT_WEIGHT */
    strd    r0, r1, [r12, #GRADIENT_AT]
    strd    r0, r0, [r12, #GRADIENT_ALONG]
    strd    r0, r0, [r12, #GRADIENT_DOWN]
    movs    r0, #1
    strd    r0, r0, [r12, #GRADIENTS_WEIGHT_MIN]
    mov     r1, #0x7f7f7f7f         /* FXL_SHIFT_OF_WORDS */
    movs    r2, #2                  /* FXL_GRADIENTS_OF_WORDS */
    str     r1, [r12, #GRADIENTS_SHIFTS]
    strb    r2, [r12, #GRADIENTS_COUNT]
    .endm

/* What find_channels does in other faces. */
    .macro find_channel_mean
.Lany_bend:
    ldm     r7, {r0, r1, r2}
    subs    r1, r1, r0
    subs    r2, r2, r0
    strd    r1, r2, [r7, #4]
    adds    r7, r7, #12
    cmp     r7, r12
    bne     .Lany_bend
    b       .Ldifferences

    /* A channel bends by r1, r2 and r0: as find_means and mean_of have it. r5: the most, r6: the
     * least, r3: the sum, then the mean; lr: what the most may be above the least. */
.Lmean:
    ldr     lr, [r12]
    cmp     lr, #60                 /* FXL_BEND_NONE */
    bne     .Lrefused_colours
    push    {r3, r5, r6}
    adds    r3, r1, r2
    adds    r3, r3, r0
    cmp     r1, r2
    itete   lt
    movlt   r5, r2
    movge   r5, r1
    movlt   r6, r1
    movge   r6, r2
    cmp     r0, r5
    it      gt
    movgt   r5, r0
    cmp     r0, r6
    it      lt
    movlt   r6, r0
    bic     r5, r5, r5, asr #31
    and     r6, r6, r6, asr #31
    mov     lr, #600                /* BEND_BOTH */
    mul     lr, lr, r4
    subs    r0, r5, r6
    cmp     r0, lr
    bhi     .Ltoo_bent
    sub     r0, r5, lr, lsr #1
    add     r0, r0, r0, lsl #1
    add     r1, r6, lr, lsr #1
    add     r1, r1, r1, lsl #1
    cmp     r3, r0
    it      lt
    movlt   r3, r0
    cmp     r3, r1
    it      gt
    movgt   r3, r1
    lsls    r3, r3, #4
    sdiv    r3, r3, r4
    lsls    r3, r3, #2
    movs    r0, #3
    sdiv    r3, r3, r0
    rsbs    r6, r6, #0
    cmp     r6, r5
    it      hi
    movhi   r5, r6                  /* to the farther side */
    ldm     r7, {r0, r1, r2}
    adds    r0, r0, r3
    add     r1, r1, r0
    add     r2, r2, r0
    sub     r6, r12, r7
    cmp     r6, #24                 /* green */
    ite     eq
    moveq   r6, #64 << 16
    movne   r6, #32 << 16
    sub     r6, r6, #2 * 4096
    sub     r3, r0, #4096
    cmp     r3, r6
    itt     ls
    subls   r1, r1, #4096
    cmpls   r1, r6
    itt     ls
    subls   r2, r2, #4096
    cmpls   r2, r6
    itt     ls
    strls   r0, [r7]
    movls   r5, #0
    cmp     r5, lr, lsr #1
    bhi     .Ltoo_bent
    pop     {r3, r5, r6}
    b       .Lbalanced
.Ltoo_bent:
    add     sp, sp, #12
    b       .Lrefused_colours

    /* A side of the face is short: coefficients and differences share the shift, -r0. */
.Lshort_side:
    rsbs    r0, r0, #0
    eor     r1, r8, r8, asr #31
    .irp    coefficient, r9, r10, r11
    eor     r2, \coefficient, \coefficient, asr #31
    orrs    r1, r1, r2
    .endr
    clz     r1, r1
    subs    r1, r1, #1
    cmp     r1, r0
    it      hi
    movhi   r1, r0
    .irp    coefficient, r8, r9, r10, r11
    lsl     \coefficient, \coefficient, r1
    .endr
    subs    r0, r0, r1
    beq     .Lscaled
    cmp     r0, #4                  /* LESS_MAX */
    bhi     .Lrefused_colours
    add     lr, lr, r0
    movs    r5, #0
.Lfits:
    ldrd    r1, r2, [r7, #4]
    eor     r1, r1, r1, asr #31
    eor     r2, r2, r2, asr #31
    orrs    r1, r1, r2
    orrs    r5, r5, r1
    adds    r7, r7, #12
    cmp     r7, r12
    bne     .Lfits
    ldr     r7, [sp, #VALUES]
    add     r5, r5, #1 << 14
    rsb     r0, r0, #22
    lsrs    r5, r5, r0
    bne     .Lrefused_colours
    b       .Lscaled
    .endm

/* The planes of a face; kind: _light, _colours or _texels; range: the longest side less the least; thin:
 * 0: it may be neither thin nor steep. r0: corners, r1: lens, r2: light or values, r3: gradients; on
 * the stack: depth; of texels r3: words; on the stack: count, is_affine. */
    .macro find_planes kind, range, thin
    push    {r0-r11, lr}
    sub     sp, sp, #OWN_SIZE
    ldrb    r6, [r0, #SCREEN_CORNERS_IS_TRIANGLE]
    ldrd    r4, r5, [r0, #SCREEN_CORNERS_WIDTH]
    cmp     r6, #0
    beq     .Lrefused\kind
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
    sbc     lr, lr, r2
    asr     r3, lr, #31             /* its sign */
    eor     r12, r12, r3
    eor     lr, lr, r3
    subs    r12, r12, r3
    sbc     lr, lr, r3
    umull   r1, r2, r4, r5          /* the box */
    lsl     r6, lr, #3
    orr     r6, r6, r12, lsr #29
    lsl     r7, r12, #3
    cmp     r7, r1
    sbcs    r6, r6, r2
    sbc     r0, r0, r0              /* all ones: it is thin, so may be steep */
    bcc     .Lthin_area\kind
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
    eor     r6, r6, r3
    sub     r6, r6, r3
    orr     r2, r4, r5
    clz     r2, r2
    sub     r2, r2, #1
    add     r1, r1, r2
    coefficient r8                  /* down[1] */
    coefficient r9                  /* along[1] */
    coefficient r10                 /* down[0] */
    coefficient r11                 /* along[0] */
    str     r1, [sp, #EXPONENT]
    cmp     r4, r5
    it      hi
    movhi   r4, r5
    orr     r4, r4, r0              /* the shorter side, or all ones */

    /* The weights, r3, r6, r12; r0: 32 less their exponent, negated. */
    ldr     r0, [sp, #CORNERS]
    add     r0, r0, #SCREEN_CORNERS_DEPTHS
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
    lsl     r3, r3, r5
    lsl     r6, r6, r5
    lsl     r12, r12, r5
    lsr     r3, r3, #1
    lsr     r6, r6, #1
    lsr     r12, r12, #1
    ldr     r7, [sp, #LENS]
    ldr     r7, [r7, #LENS_NEAR_Z]
    clz     lr, r7
    lsl     r7, r7, lr
    sub     r0, lr, r0
    upper_product r2, r3, lr
    clz     r5, r2
    orr     r2, r2, #1
    lsl     r2, r2, r5
    sub     r0, r0, r5
    reciprocal r2, r5, lr
    upper_product r7, r2, lr        /* the factor */
    upper_product r3, r7, lr
    upper_product r6, r7, lr
    upper_product r12, r7, lr
    extremes r5, r2, r3, r6, r12
    sub     r1, r5, r2
    strd    r2, r1, [sp, #LEAST]
    umull   lr, r7, r5, r4
    subs    lr, lr, r1, lsl #20
    sbcs    r7, r7, r1, lsr #12
    blo     .Lsteep\kind                 /* they differ much for the shorter side */
.Lmay_be_steep\kind:

    /* The octave r0 of the lens's, r1, and at most the one beyond it; r2: bits of a code, lr: zeros of the weights. */
    clz     lr, r5
    clz     r7, r2
    add     r0, r0, lr
    sub     r7, r7, lr
    cmp     r7, #1                  /* octaves that it crosses */
    bhi     .Lrefused\kind
    ite     eq
    addeq   r7, r0, #1
    movne   r7, #0
    str     r7, [sp, #CROSSED]
    ldr     r7, [sp, #LENS]
    ldrd    r5, r7, [r7, #LENS_NEAR_Z]
    add     r7, r7, r7, lsr #8
    add     r7, r7, #1
    clz     r1, r5
    clz     r2, r7
    subs    r1, r1, r2
    beq     .Lrefused\kind               /* a single octave: codes of 15 bits */
    lsl     r5, r5, r1
    cmp     r5, r7
    it      lo
    addlo   r1, r1, #1
    cmp     r1, #1
    beq     .Lrefused\kind
    cmp     r0, r1
    bhs     .Lrefused\kind
    ldr     r2, [sp, #CROSSED]
    cmp     r2, r1
    bhs     .Lrefused\kind
    clz     r2, r1
    add     r2, r2, #1
    sub     r1, r1, r0
    sub     r1, r1, #2
    sub     r5, r2, #1
    lsl     r1, r1, r5              /* the bias */
    rsb     r7, lr, #32
    sub     r7, r7, r2              /* bits of a weight below a code's */
    rsb     r5, r7, #0
    lsr     r0, r3, r7
    lsl     r5, r3, r5              /* one of the two is 0, or both are equal */
    orr     r0, r0, r5
    add     r0, r0, r1
    add     r0, r0, #65536          /* the code of corner 0 */

    /* The plane of depth: r3:r2 and r6:r5 become along and down. */
    .ifc    \kind, _colours
    shorten_weights
    .endif
    sub     r6, r6, r3
    sub     r12, r12, r3
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
    lsr     r7, r7, #16
    orr     r7, r7, r12, lsl #16
    sub     r0, r0, r7
    .ifc    \kind, _texels
    find_texels
    .else
    ldr     r7, [sp, #DEPTH]
    asr     lr, r0, #31
    strd    r0, lr, [r7, #GRADIENT_AT]
    asr     lr, r2, #31
    strd    r2, lr, [r7, #GRADIENT_ALONG]
    asr     lr, r5, #31
    strd    r5, lr, [r7, #GRADIENT_DOWN]
    ldr     r0, [sp, #CROSSED]
    orr     r0, r0, #1 << 31        /* FXL_DEPTH_IS_LINEAR, or FXL_DEPTH_IS_BENT and the octave */
    str     r0, [r7, #DEPTH_PLANE_ONE]

    .ifc    \kind, _light
    find_light
    .else
    find_channels
    .endif
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
    b       .Lfilled\kind
    .endif

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
    sub     r7, r7, #32
    asr     r2, r3, r7
    asr     r5, r6, r7
    b       .Lsteps\kind
    .endm

    .section .text.fxl_find_smooth_planes, "ax", %progbits
    .global fxl_find_smooth_planes
    .type fxl_find_smooth_planes, %function
    .thumb_func
fxl_find_smooth_planes:
    find_planes _light, 127 << 16, 9 /* FXL_WORDS_SIDE_MAX */
    .size fxl_find_smooth_planes, . - fxl_find_smooth_planes

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
    find_planes _texels, 255 << 14, 0 /* FXL_SMALL_SIDE_MAX */
    .size fxl_find_texel_planes, . - fxl_find_texel_planes

#endif
