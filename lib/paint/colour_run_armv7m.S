/* SPDX-License-Identifier: MIT */
/* fxl_paint_colour_run, fxl_paint_lit_columns, fxl_paint_unlit_columns and fxl_paint_texel_list for Armv7-M
 * and Armv8-M Mainline. A run takes 7 instructions a pixel, and 2 for each eight of them; compilers take 9. A
 * lit texel takes 33, of the palette 35, and 9 less if the dark colour is 0; a segment of them takes 95. An
 * added texel takes 14.5, another one without light 9 or 10, a segment of them 79; a run takes 88, and 12 more if it is lit. */
#include "../math/family.h"
#include "black_texels_armv7m.h"

#if FXL_KERNELS_ARMV7M

    .syntax unified
    .thumb

pixels     .req r1
count      .req r2     /* then eights */
both       .req r3
green      .req r4
step       .req r5
green_step .req r6
colour     .req r7
channel    .req r12

    .section .text.fxl_paint_colour_run, "ax", %progbits
    .global fxl_paint_colour_run
    .type fxl_paint_colour_run, %function
    .thumb_func

    .macro paint_pixel
    lsrs    colour, green, #26
    and     channel, both, #0xf800
    orr     colour, channel, colour, lsl #5
    orr     colour, colour, both, lsr #27
    add     both, both, step
    add     green, green, green_step
    strh    colour, [pixels], #2
    .endm

/* r0: words, r1: pixels, r2: count. What is left over eights is painted first. */
fxl_paint_colour_run:
    push    {r4-r7}
    ldm     r0, {both, green, step, green_step}
    adds    count, #7
    and     r0, count, #7
    lsrs    count, #3
    tbb     [pc, r0]
.Lparts:
    .byte   (.Lpixel7 - .Lparts) / 2, (.Lpixel6 - .Lparts) / 2
    .byte   (.Lpixel5 - .Lparts) / 2, (.Lpixel4 - .Lparts) / 2
    .byte   (.Lpixel3 - .Lparts) / 2, (.Lpixel2 - .Lparts) / 2
    .byte   (.Lpixel1 - .Lparts) / 2, (.Lpixel0 - .Lparts) / 2
    .irp    number, 0, 1, 2, 3, 4, 5, 6, 7
.Lpixel\number:
    paint_pixel
    .endr
    subs    count, #1
    bne     .Lpixel0
    pop     {r4-r7}
    bx      lr

    .size fxl_paint_colour_run, . - fxl_paint_colour_run

#if !FXL_IS_COMPACT

#include "../math/offsets.h"

/* --- texels in segments ------------------------------------------------------------------------ */

/* The frame */
#define LIT_PALETTE    0 /* what pixels need of the run, in its order */
#define LIT_PART       4
#define LIT_RED_DARK   8
#define LIT_RED_STEP   12
#define LIT_GREEN_DARK 16
#define LIT_GREEN_STEP 20
#define LIT_END        24 /* of the segment's pixels */
#define LIT_RUN        28
#define LIT_PIXELS     32 /* of column 0 */
#define LIT_X          36 /* the next column, then the last one plus 1 */
#define LIT_MASKS      44
#define LIT_FRAME      52

/* The number of an attribute at the segment's end, and the attribute in \value. r3: the reciprocal of the
 * weight, r12: the weight's zeros; r11: gathers the drops. */
    .macro  divide_attribute at, left, value
    ldrd    r4, r5, [r0, #\at]
    ldrd    r6, r7, [r0, #LIT_RUN_STEPS + \at]
    adds    r4, r4, r6
    adc     r5, r5, r7
    strd    r4, r5, [r0, #\at]
    ldr     r6, [r0, #LIT_RUN_LEFTS + \left]
    smull   r4, r5, r5, r3
    sub     r6, r6, r12
    orr     r11, r11, r6
    asr     \value, r5, r6
    .endm

/* r0: run, r1: pixels, r2: x0, r3: x1. The first pixel of a segment in r3; r4-r6: u, v, where a row of texels
 * is 2^16, and light; r8-r10: steps; r7: texels, r11, r12: their masks; r0: palette, lr: the end of the pixels. */
    .macro  next_segment lit
    push    {r4-r11, lr}
    sub     sp, #LIT_FRAME
    add     r12, sp, #LIT_RUN
    stm     r12, {r0-r3}
    add     r12, r0, #LIT_RUN_PALETTE
    ldm     r12, {r4-r9}
    stm     sp, {r4-r9}

.Lsegment\lit:                       /* r0: the run */
    ldrd    r2, r3, [r0]
    ldrd    r4, r5, [r0, #LIT_RUN_STEPS]
    adds    r2, r2, r4
    adc     r3, r3, r5
    strd    r2, r3, [r0]
    cmp     r3, #1
    it      lt
    movlt   r3, #1
    clz     r12, r3
    orr     r3, r3, #1
    lsl     r3, r3, r12
    mvn     r1, #0x80000000
    lsr     r2, r3, #16
    udiv    r1, r1, r2
    mul     r2, r1, r1
    umull   r4, r2, r2, r3
    rsb     r3, r2, r1, lsl #16
    sub     r3, r3, r3, lsr #31
    movs    r11, #0
    divide_attribute 8, 0, r8
    divide_attribute 16, 4, r9
    .if     \lit
    divide_attribute 24, 8, r10
    .endif
    cmp     r11, #32                /* a drop below 0, or above 31 */
    bhs     .Lend\lit
    add     r12, r0, #LIT_RUN_FROM
    ldm     r12, {r4-r6}
    stm     r12, {r8-r10}
    ldrd    r1, r7, [r0, #LIT_RUN_BEGIN]
    movs    r12, #1
    lsl     r12, r12, r7
    add     r12, r12, r1            /* where the segment ends */
    str     r12, [r0, #LIT_RUN_BEGIN]
    ldrd    r2, r3, [sp, #LIT_X]
    cmp     r12, r2
    ble     .Lsegment\lit
    sub     r8, r8, r4
    sub     r9, r9, r5
    asr     r8, r8, r7
    asr     r9, r9, r7
    .if     \lit
    sub     r10, r10, r6
    asr     r10, r10, r7
    .endif
    subs    r1, r2, r1              /* pixels before the first one */
    ittt    ne
    mlane   r4, r8, r1, r4
    mlane   r5, r9, r1, r5
    mlane   r6, r10, r1, r6
    cmp     r12, r3
    it      gt
    movgt   r12, r3
    .if     \lit
    sub     r1, r12, r2
    subs    r1, r1, #1
    sub     r6, r6, #32768
    mla     r11, r10, r1, r6        /* light of the last pixel: it is linear */
    ldr     r1, [r0, #LIT_RUN_END_OF_LIGHT]
    cmp     r6, r1
    it      lo
    cmplo   r11, r1
    bhs     .Lend\lit
    .endif
    ldr     r1, [sp, #LIT_PIXELS]
    str     r12, [sp, #LIT_X]
    add     r3, r1, r2, lsl #1
    add     lr, r1, r12, lsl #1
    ldrd    r11, r12, [r0, #LIT_RUN_MASKS]
    ldrd    r1, r7, [r0, #LIT_RUN_MASKS + 8]
    lsl     r5, r5, r1
    lsl     r9, r9, r1
    .if     \lit == 0
    ldr     r6, [r0, #LIT_RUN_LOWEST]
    .endif
    ldr     r0, [sp, #LIT_PALETTE]
    .endm

    .macro  end_segment lit
.Lpainted\lit:
    add     r0, sp, #LIT_RUN
    ldm     r0, {r0-r3}
    cmp     r2, r3
    bne     .Lsegment\lit
.Lend\lit:
    ldr     r0, [sp, #LIT_X]
    add     sp, #LIT_FRAME
    pop     {r4-r11, pc}
    .endm

/* The colour of a texel, in one of r0 and r1. palette: a register. Overwrites r2. */
    .macro  find_texel colour, wide, palette
    and     \colour, r11, r4, lsr #16
    and     r2, r12, r5, lsr #16
    add     \colour, \colour, r2
    .if     \wide
    ldrh    \colour, [r7, \colour, lsl #1]
    .else
    ldrb    \colour, [r7, \colour]
    ldrh    \colour, [\palette, \colour, lsl #1]
    .endif
    .endm

/* --- lit texels ------------------------------------------------------------------------------ */

    .section .text.fxl_paint_lit_columns, "ax", %progbits
    .global fxl_paint_lit_columns
    .type fxl_paint_lit_columns, %function
    .thumb_func

/* A texel in r0, and the part of it in r1, as of light_row.h. Overwrites r2. */
    .macro  find_lit wide
    .if     \wide == 0
    ldr     r1, [sp, #LIT_PALETTE]
    .endif
    find_texel r0, \wide, r1
    ldr     r2, [sp, #LIT_PART]
    lsr     r1, r6, #8
    mul     r1, r1, r2
    add     r1, r1, #32768
    lsr     r1, r1, #16
    .endm

/* Writes r0, and goes on; r8-r10: steps, lr: the end of the pixels. */
    .macro  keep_lit text
    strh    r0, [r3], #2
    add     r4, r4, r8
    add     r5, r5, r9
    add     r6, r6, r10
    cmp     r3, lr
    bne     .Llit\text
    b       .Lpainted1
    .endm

/* The same, of which r12 is the part of a level, times 2^8, and the masks are in the frame. r11: HALF_STEPS. */
    .macro  paint_black text, wide
.Llit\text:
    ldrd    r0, r1, [sp, #LIT_MASKS]
    and     r0, r0, r4, lsr #16
    and     r1, r1, r5, lsr #16
    add     r0, r0, r1
    .if     \wide
    ldrh    r0, [r7, r0, lsl #1]
    .else
    ldr     r1, [sp, #LIT_PALETTE]
    ldrb    r0, [r7, r0]
    ldrh    r0, [r1, r0, lsl #1]
    .endif
    bic     r1, r6, #255
    umull   r2, r1, r1, r12
    add     r1, r1, r2, lsr #31
    mix_black r11
    keep_lit \text
    .endm

    .macro  paint_lit text, wide
.Llit\text:
    find_lit \wide
    and     r2, r0, #0x7E0
    lsr     lr, r0, #11
    and     r0, r0, #31
    orr     r0, r0, lr, lsl #19
    ldr     lr, [sp, #LIT_GREEN_STEP]
    add     r2, r2, lr
    ldr     lr, [sp, #LIT_RED_STEP]
    add     r0, r0, lr
    ldr     lr, [sp, #LIT_GREEN_DARK]
    mla     r2, r2, r1, lr
    ldr     lr, [sp, #LIT_RED_DARK]
    mla     r0, r0, r1, lr
    lsr     r2, r2, #13
    bfi     r0, r2, #13, #6         /* green above blue */
    lsr     r2, r0, #27
    lsr     r0, r0, #8
    bfi     r0, r2, #11, #5
    ldr     lr, [sp, #LIT_END]
    keep_lit \text
    .endm

fxl_paint_lit_columns:
    next_segment 1
    ldr     r1, [sp, #LIT_RED_STEP]
    ldr     r2, [sp, #LIT_GREEN_STEP]
    orrs    r1, r1, r2
    bne     .Llit_dark
    strd    r11, r12, [sp, #LIT_MASKS]
    ldr     r12, [sp, #LIT_PART]
    mov     r11, #HALF_STEPS
    lsl     r12, r12, #8
    cmp     r0, #0
    beq     .Llit_wide
    paint_black _narrow, 0
    paint_black _wide, 1
.Llit_dark:
    str     lr, [sp, #LIT_END]
    cmp     r0, #0
    beq     .Llit_dark_wide
    paint_lit _dark_narrow, 0
    paint_lit _dark_wide, 1

    end_segment 1

    .size fxl_paint_lit_columns, . - fxl_paint_lit_columns

/* --- texels without light --------------------------------------------------------------------- */

    .section .text.fxl_paint_unlit_columns, "ax", %progbits
    .global fxl_paint_unlit_columns
    .type fxl_paint_unlit_columns, %function
    .thumb_func

    .macro  next_texel colour, wide
    find_texel \colour, \wide, r10
    add     r4, r4, r8
    add     r5, r5, r9
    .endm

/* fxl_add_565 of r0 and r1, in r0. r6: the lowest bits of channels; the highest ones are one bit on.
 * Overwrites r2. */
    .macro  add_colours
    eor     r2, r0, r1
    and     r0, r0, r1
    bic     r1, r2, r6
    add     r0, r0, r1, lsr #1
    and     r1, r0, r6, ror #1
    eor     r0, r0, r1
    orr     r2, r2, r1, lsr #5
    and     r2, r2, r6
    orr     r2, r2, r0, lsl #1
    lsr     r0, r1, #4
    rsb     r0, r0, r1, lsl #1
    orr     r0, r0, r2
    .endm

/* Two pixels in each word. lr: the last pixel. */
    .macro  paint_added text, wide
    tst     r3, #2
    beq     .Lmore\text
.Lone\text:
    next_texel r0, \wide
    ldrh    r1, [r3]
    add_colours
    strh    r0, [r3], #2
    b       .Lmore\text
.Ltwo\text:
    next_texel r0, \wide
    next_texel r1, \wide
    orr     r0, r0, r1, lsl #16
    ldr     r1, [r3]
    add_colours
    str     r0, [r3], #4
.Lmore\text:
    cmp     r3, lr
    blo     .Ltwo\text
    beq     .Lone\text
    b       .Lpainted0
    .endm

    .macro  show text, wide
.Lpixel\text:
    next_texel r0, \wide
    strh    r0, [r3], #2
    cmp     r3, lr
    bne     .Lpixel\text
    b       .Lpainted0
    .endm

fxl_paint_unlit_columns:
    next_segment 0
    mov     r10, r0
    cmp     r6, #0
    beq     .Lshow
    sub     lr, lr, #2
    cmp     r10, #0
    beq     .Ladded_wide
    paint_added _added, 0
.Ladded_wide:
    paint_added _added_wide, 1
.Lshow:
    cmp     r10, #0
    beq     .Lpixel_shown_wide
    show    _shown, 0
    show    _shown_wide, 1
    end_segment 0

    .size fxl_paint_unlit_columns, . - fxl_paint_unlit_columns

/* --- runs of texels -------------------------------------------------------------------------- */

    .section .text.fxl_paint_texel_list, "ax", %progbits
    .global fxl_paint_texel_list
    .type fxl_paint_texel_list, %function
    .thumb_func

/* A number of the row, which comes to that of the row below. r5: runs. */
    .macro  number_below at
    ldrd    r0, r1, [r5, #\at]
    ldrd    r2, r3, [r5, #PLAIN_ROWS_DOWNS + \at]
    adds    r0, r0, r2
    adc     r1, r1, r3
    strd    r0, r1, [r5, #\at]
    .endm

/* The number of segment r7, in r1:r0; r3:r2 becomes what a segment adds. r4: run. */
    .macro  number_after at
    ldrd    r0, r1, [r5, #\at]
    ldrd    r2, r3, [r4, #LIT_RUN_STEPS + \at]
    umlal   r0, r1, r2, r7
    mla     r1, r3, r7, r1
    .endm

/* The number of the segment before. */
    .macro  number_before at
    number_after \at
    subs    r0, r0, r2
    sbc     r1, r1, r3
    strd    r0, r1, [r4, #\at]
    .endm

/* Goes to .Ltoo_far if the weight is not that of 16 columns. r11: the least one. */
    .macro  test_weight
    cmp     r1, #1
    it      lt
    movlt   r1, #1
    cmp     r1, r11
    blo     .Ltoo_far
    .endm

/* r0: run, r1: runs */
fxl_paint_texel_list:
    push    {r3-r11, lr}
    mov     r4, r0
    mov     r5, r1
    ldr     r6, [r4, #LIT_RUN_PALETTE + 4] /* 0: no light */
    ldrd    r11, r10, [r4, #LIT_RUN_LEAST] /* then the kernel of columns */
.Lrun:
    ldrd    r2, r3, [r5, #PLAIN_RUNS_NEXT]
    cmp     r2, r3
    beq     .Lno_run
    ldr     r9, [r2], #4
    str     r2, [r5, #PLAIN_RUNS_NEXT]
    cmp     r9, #0
    bpl     .Lsame_row
    ldr     r0, [r5, #PAINT_ROW_PIXELS]
    ldr     r1, [r5, #PLAIN_RUNS_STRIDE]
    add     r0, r0, r1
    str     r0, [r5, #PAINT_ROW_PIXELS]
    number_below PAINT_ROW_WEIGHT
    number_below PAINT_ROW_U
    number_below PAINT_ROW_V
    cbz     r6, .Lsame_row
    number_below PAINT_ROW_V + 8
.Lsame_row:
    uxth    r8, r9
    ubfx    r9, r9, #16, #15
    cmp     r8, r9
    beq     .Lrun
    add     r7, r9, #15
    lsr     r7, r7, #4
    number_after PAINT_ROW_WEIGHT
    test_weight
    lsr     r7, r8, #4
    number_before PAINT_ROW_WEIGHT
    adds    r0, r0, r2              /* that of the first segment */
    adc     r1, r1, r3
    test_weight
    number_before PAINT_ROW_U
    number_before PAINT_ROW_V
    cbz     r6, .Lat_segment
    number_before PAINT_ROW_V + 8
.Lat_segment:
    lsl     r0, r7, #4
    sub     r0, r0, #16
    movs    r1, #4
    strd    r0, r1, [r4, #LIT_RUN_BEGIN]
    mov     r0, r4
    ldr     r1, [r5, #PAINT_ROW_PIXELS]
    mov     r2, r8
    mov     r3, r9
    blx     r10
    cmp     r0, r9
    beq     .Lrun
    pop     {r3-r11, pc}
.Ltoo_far:
    mov     r0, r8
    pop     {r3-r11, pc}
.Lno_run:
    mvn     r0, #0
    pop     {r3-r11, pc}

    .size fxl_paint_texel_list, . - fxl_paint_texel_list

#endif

#endif
