/* SPDX-License-Identifier: MIT */
/* Part of smooth_planes_armv7m.S: the words of attributes, which are light and texels, and what they are
 * computed by. Assembly. */
#ifndef FXL_SMOOTH_WORDS_ARMV7M_H
#define FXL_SMOOTH_WORDS_ARMV7M_H

/* clang-format off */

/* \value, whose highest bit is set, becomes the value of its reciprocal as of fxl_reciprocal_of.
 * Overwrites \spare and \other. */
    .macro reciprocal value, spare, other
    mvn     \spare, #0x80000000
    lsrs    \other, \value, #16
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

/* \edge becomes a coefficient; r3: the shift, r6: the reciprocal of the area. */
    .macro coefficient edge
    lsl     \edge, \edge, r3
    smull   r7, \edge, \edge, r6
    .endm

/* \most and \least become those of 0 and of what two values have more than a third one. The three
 * differ by less than 2^31: no difference wraps. */
    .macro ends_of_differences most, least, d1, d2
    sub     \least, \d1, \d2
    and     \least, \least, \least, asr #31
    sub     \most, \d1, \least
    add     \least, \d2, \least
    bic     \most, \most, \most, asr #31
    and     \least, \least, \least, asr #31
    .endm

/* The lower word of \high:\low / 2^\drop, in \low; \up: 32 - \drop. 0 < \drop < 32. */
    .macro lower_of_shifted low, high, drop, up
    lsrs    \low, \low, \drop
    lsls    \high, \high, \up
    orrs    \low, \low, \high
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
    sub     r2, r2, r0
    sub     r5, r5, r0
    ends_of_differences r7, r12, r2, r5
    sub     r7, r7, r12
    ldrd    r4, r12, [sp, #LEAST]
    umull   r7, r12, r7, r12
    lsl     lr, r4, #15             /* 4 FXL_AFFINE_ERROR_LIGHT */
    subs    lr, lr, r7
    lsr     r4, r4, #17
    sbcs    r4, r4, r12
    blo     .Ltwisted_light
.Lbalanced_light:
    words_of_values 8, .Lrefused_light
    ldr     r5, [sp, #WORDS]
    strd    r12, r0, [r5, #SMOOTH_WORDS_LIGHT_DOWN]
    ldr     r0, [sp, #CROSSED]
    str     r4, [r5, #SMOOTH_WORDS_LIGHT_DOWN + 8]
    orr     r0, r0, #1 << 31        /* FXL_DEPTH_IS_LINEAR, or FXL_DEPTH_IS_BENT and the octave */
    .endm

/* Light at corner 0 gets the mean of the error, as mean_of_error finds it. r12:r7: the product. */
    .macro find_light_mean
.Ltwisted_light:
    ldr     lr, [sp, #CROSSED]
    orr     lr, lr, #1 << 30        /* FXL_WORDS_HAVE_MEAN */
    str     lr, [sp, #CROSSED]
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

/* The words of attribute \number, of light those of the values at r7; chord: a macro that leaves the product of the least weight, r7, and
 * four times what the chord may be off by in r7 and lr. r1: the drop; r3, r6: x, y; r8-r11: the
 * coefficients. Overwrites the others. */
    .macro texel_words number, chord, has_texels
    .if     \has_texels
    ldr     r7, [sp, #VALUES]
    ldm     r7, {r0, r2, r5}
    ldr     r0, [r0, #CORNER_TEXEL + 4 * \number]
    ldr     r2, [r2, #CORNER_TEXEL + 4 * \number]
    ldr     r5, [r5, #CORNER_TEXEL + 4 * \number]
    .else
    ldm     r7, {r0, r2, r5}
    .endif
    sub     r2, r2, r0
    sub     r5, r5, r0
    ends_of_differences r4, r12, r2, r5
    .if     \has_texels
    eor     r7, r12, r12, asr #31
    orr     r7, r7, r4
    lsrs    r7, r7, #23             /* 128 texels */
    bne     .Lrefused_texels
    .endif
    sub     r4, r4, r12             /* the range */
    ldrd    r7, r12, [sp, #LEAST]
    umull   r4, r12, r4, r12
    \chord
    subs    r7, r7, r4
    sbcs    lr, lr, r12
    blo     .Lrefused_texels
    words_of_values 0, .Lrefused_texels
    .if     \number == 1
    ldr     r5, [sp, #V_DROP]
    asr     r0, r0, r5
    asr     r12, r12, r5
    asr     r4, r4, r5
    .endif
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

/* Code r0 and its changes r2, r5, texels, and light where there are values of it. Where the face is
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
    ldr     r7, [sp, #TEXEL_LIGHT]
    cmp     r7, #0
    beq     .Lhave_words
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

/* clang-format on */

#endif
