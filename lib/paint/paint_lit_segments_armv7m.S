/* SPDX-License-Identifier: MIT */
/* Segments of faces with light, for Armv7-M and Armv8-M Mainline: fxl_paint_lit_run and
 * fxl_paint_lit_runs. A texel takes 8 instructions if the texture is 32 to 256 texels wide and no
 * higher than wide; any other takes 12. A segment of 16 columns takes 47 more, a shorter one 66, and
 * a run about 140. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_TEXELS_IN_ASSEMBLY

#define SAVED        36
#define WHOLE        420 /* bytes of the code of a whole segment */
#include "segments_armv7m.h"

/* The frame: */
    slots   0
    slot    .LENDS, 6       /* weight, u and v at the end of the segment */
    slot    .LSTEPS, 6      /* theirs */
    slot    .LFRAME_BLOCK   /* the address of the block */
    slot    .LBLOCK, 8      /* 2^31 - 1, the least drop, the light's upper word, its step and its drop, those of
                           * U and V, its most */
    slot    .LBEGIN, 2      /* U and V at the beginning of the segment */
    slot    .LENDS_LIGHT    /* the light there */
    slot    .LLOADED, 3     /* six words for one load: texels, mask, ramp, FRAME_LAST, the end, FRAME_GO */
    slot    .LFRAME_LAST, 2 /* 0 if segments have less than 16 columns; then the end */
    slot    .LFRAME_GO
    slot    .LFRAME_FULL
    slot    .LFRAME_SHORT   /* columns of 16 that a segment has not */
    slot    .LFRAME_BEFORE
    slot    .LFRAME_SKIP
    slot    .LFRAME_COLUMN, 2
    slot    .LFRAME_CODE, 2 /* of 16 pixels; then its bytes a pixel, 0 for a loop */
    slot    .LFRAME_SHIFT, 2 /* 4 + log of the columns of a segment; then 8 times these */
    slot    .LFRAME_LOG     /* for which the frame is; above 4: for none */
    slot    .LFRAME_DONE    /* what follows a run */
    slot    .LFRAME_ROW
    slot    .LFRAME, 0
    slot_of .LFRAME_TEXELS, .LLOADED
/* Within the block: */
#define BLOCK_LIGHT  8
#define BLOCK_STEP   12
#define BLOCK_MOST   28
#define BLOCK_BYTES  32

pixels  .req r0
p       .req r1
step    .req r2
texels  .req r4
mask    .req r5
ramp    .req r6
last    .req r7     /* FRAME_LAST */
change  .req r9     /* of light, a pixel */
light   .req r10    /* 1/256 level: of an even pixel */
other   .req r11    /* of an odd one */

/* r2, r4, r7: U, V and light, of the weight in r2, r4: u / z, r6: v / z, and light's upper word in
 * r7. The block is in r3, r5 and r8 to r12. Goes away if a drop has fewer leading zeros. */
    .macro  divide_all far
    reciprocal r3, r1, r2, r3, r2, r8
    cmp     r1, r5
    bgt     \far
    sub     r9, r9, r1
    sub     r10, r10, r1
    sub     r11, r11, r1
    smull   r1, r2, r4, r3
    asr     r2, r2, r10
    smull   r1, r4, r6, r3
    asr     r4, r4, r11
    smull   r1, r7, r7, r3
    asr     r7, r7, r9
    .endm

/* What is linear, at the end of the next segment: the block of divide_all; lr: its end. */
    .macro  next_values
    ldm     sp, {r1-r12, lr}
    adds    r1, r1, r7
    adcs    r2, r2, r8
    adds    r3, r3, r9
    adcs    r4, r4, r10
    adds    r5, r5, r11
    adc     r6, r6, r12
    stm     sp, {r1-r6}
    ldm     lr!, {r3, r5, r7-r12}
    add     r7, r7, r8
    str     r7, [lr, #BLOCK_LIGHT - BLOCK_BYTES]
    .endm

    .section .text.fxl_paint_lit_run, "ax", %progbits
    .global fxl_paint_lit_run
    .type fxl_paint_lit_run, %function
    .thumb_func

/* r0: face, r1: row, r2: x0, r3: x1, on the stack: log */
fxl_paint_lit_run:
    push    {r4-r11, lr}
    sub     sp, #.LFRAME
    adr     r4, .Lreturn + 1
    strd    r4, r1, [sp, #.LFRAME_DONE]
    bl      .Lprepare
    ldr     r4, [sp, #.LFRAME + SAVED]
    b       .Lset_log
    .align  2
.Lreturn:
    movs    r0, #0
.Lleave:
    add     sp, #.LFRAME
    pop     {r4-r11, pc}
.Lnot_ours:
    movs    r0, #1
    b       .Lleave

    .global fxl_paint_lit_runs
    .type   fxl_paint_lit_runs, %function
    .thumb_func

/* r0: runs. Returns 0, or 1 after a run that is not the kernel's. */
fxl_paint_lit_runs:
    push    {r4-r11, lr}
    sub     sp, #.LFRAME
    adr     r4, .Lnext_run + 1
    strd    r4, r0, [sp, #.LFRAME_DONE]
    ldr     r0, [r0, #PAINT_ROW_SEGMENTS]
    bl      .Lprepare
    .align  2
.Lnext_run:
    ldr     r1, [sp, #.LFRAME_ROW]
    ldrd    r2, r3, [r1, #PLAIN_RUNS_NEXT]
    cmp     r2, r3
    beq     .Lreturn
    ldr     lr, [r2], #4
    str     r2, [r1, #PLAIN_RUNS_NEXT]
    cmp     lr, #0
    bpl     .Lcolumns
    add     r0, r1, #PLAIN_ROWS_DOWNS
    ldm     r1, {r2-r5}
    ldm     r0!, {r6-r9}
    adds    r2, r2, r6
    adc     r3, r3, r7
    adds    r4, r4, r8
    adc     r5, r5, r9
    stm     r1!, {r2-r5}
    ldm     r1, {r2-r6}                 /* v, light and the address */
    ldm     r0, {r7-r10}
    ldr     r11, [r0, #PLAIN_RUNS_STRIDE - PLAIN_ROWS_DOWNS - 16]
    adds    r2, r2, r7
    adc     r3, r3, r8
    adds    r4, r4, r9
    adc     r5, r5, r10
    add     r6, r6, r11
    stm     r1, {r2-r6}
    subs    r1, #16
.Lcolumns:                              /* lr: the run */
    uxth    r2, lr
    ubfx    r3, lr, #16, #15
    cmp     r2, r3
    beq     .Lnext_run

/* Which segments its columns have. r10, r11: the weight at the first 16 columns; r12, lr: at the end
 * of the last. */
    ldr     r0, [r1, #PAINT_ROW_SEGMENTS]
    weights_at_ends
    ldr     r9, [r0, #SEGMENT_FACE_LEAST]
    movs    r4, #4
    cmp     r11, r9
    it      ge
    cmpge   lr, r9
    bge     .Lrun

/* The 16 columns with the least weight, r11, and those with the largest, r8, have to be of one
 * length: r9 is the least weight of longer segments. */
    cmp     r7, #0
    blt     1f
    subs    r12, r12, r6
    sbc     r8, lr, r7
    b       2f
1:  adds    r10, r10, r6
    adc     r8, r11, r7
    mov     r11, lr
2:  movs    r4, #3
    ldr     r5, [r0, #SEGMENT_FACE_LEAST + 4]
    cmp     r11, r5
    bge     3f
    movs    r4, #2
    mov     r9, r5
    ldr     r5, [r0, #SEGMENT_FACE_LEAST + 8]
    cmp     r11, r5
    blt     .Lnot_ours
3:  cmp     r8, r9
    bge     .Lnot_ours
.Lrun:
    ldr     r5, [sp, #.LFRAME_LOG]
    cmp     r4, r5
    bne     .Lset_log

/* Segments of 2^r4 columns: the columns r2 to r3 of the row in r1. */
.Lsame_log:
    rsb     r5, r4, #32
    lsl     r6, r2, r5
    lsr     r6, r6, r5                  /* columns that are skipped */
    str     r6, [sp, #.LFRAME_SKIP]
    ldr     r7, [r1, #PAINT_ROW_PIXELS]
    ldr     r5, [sp, #.LFRAME_SHORT]
    subs    r7, #1
    add     r3, r3, r7
    sub     r0, r2, r6
    add     r0, r0, r7                  /* the address before the segment */
    rsb     r8, r5, #16
    sub     r8, r3, r8
    cmp     r0, r8
    it      ls
    cmpls   r6, #0
    ite     eq
    ldreq   r9, [sp, #.LFRAME_FULL]
    adrne   r9, .Lpartial + 1
    str     r9, [sp, #.LFRAME_GO]
    cmp     r5, #0
    it      ne
    movne   r8, #0
    strd    r8, r3, [sp, #.LFRAME_LAST]
    lsr     r12, r2, r4                 /* the first segment's number */

/* The row's values there: the steps times its number. */
    add     lr, sp, #.LBLOCK
    ldr     r5, [r1, #PAINT_ROW_LIGHT]
    ldr     r6, [lr, #BLOCK_STEP]
    mla     r5, r6, r12, r5
    str     r5, [lr, #BLOCK_LIGHT]
    ldm     r1, {r1-r6}
    ldrd    r7, r8, [sp, #.LSTEPS]
    umlal   r1, r2, r7, r12
    mla     r2, r8, r12, r2
    ldrd    r7, r8, [sp, #.LSTEPS + 8]
    umlal   r3, r4, r7, r12
    mla     r4, r8, r12, r4
    ldrd    r7, r8, [sp, #.LSTEPS + 16]
    umlal   r5, r6, r7, r12
    mla     r6, r8, r12, r6
    stm     sp, {r1-r6}
    ldm     lr!, {r3, r5, r7-r12}
    divide_all .Lfar_begin
.Lbegun:
    stm     lr, {r2, r4, r7}
    cmp     r7, r12
    bls     1f
    adr     r3, .Llimited + 1
    str     r3, [sp, #.LFRAME_GO]
1:  ldr     r3, [sp, #.LFRAME_SHORT]
    cmp     r3, #0
    bne     .Lshort

    /* The end of the next segment of 16 columns. */
    .align  2
.Lsegment:
    next_values
    divide_all .Lfar
.Lends:                                 /* r2: U, r4: V, r7: light at the end */
    cmp     r7, r12
    bhi     .Lbeyond
.Lwithin:
    ldm     lr, {r8-r10}
    stm     lr!, {r2, r4, r7}
    ubfx    p, r9, #4, #16
    lsr     r3, r8, #4
    add     p, p, r3, lsl #16
    sub     r2, r2, r8
    sub     r4, r4, r9
    asr     r7, r7, #4
    sub     change, r7, light, asr #4
    adds    r2, #128
    adds    r4, #128
    asrs    r2, r2, #8
    sbfx    r4, r4, #8, #16
    add     step, r4, r2, lsl #16
    ldm     lr, {texels, mask, ramp, last, r8, pc}

    /* Light that is not a level. */
.Lbeyond:
    adr     r3, .Llimited + 1
    str     r3, [sp, #.LFRAME_GO]
    b       .Lwithin

    /* The end of the next segment of 8 or 4 columns. */
.Lshort:
    next_values
    divide_all .Lfar_short
.Lends_short:
    cmp     r7, r12
    itt     hi
    adrhi   r3, .Llimited + 1
    strhi   r3, [sp, #.LFRAME_GO]
    ldrd    r11, r12, [sp, #.LFRAME_SHIFT]
    ldm     lr, {r8-r10}
    stm     lr!, {r2, r4, r7}
    ubfx    p, r9, #4, #16
    lsr     r3, r8, #4
    add     p, p, r3, lsl #16
    sub     r2, r2, r8
    sub     r4, r4, r9
    add     r2, r2, r12
    add     r4, r4, r12
    asr     r2, r2, r11
    asr     r4, r4, r11
    sxth    r4, r4
    add     step, r4, r2, lsl #16
    sub     r11, r11, #4
    asr     r7, r7, r11
    asr     r3, light, r11
    sub     change, r7, r3
    ldr     r3, [sp, #.LFRAME_SHORT]
    sub     pixels, pixels, r3
    ldm     lr, {texels, mask, ramp, last, r8, pc}

    /* Fewer leading zeros in a drop: some bits come from the lower word. */
.Lfar_begin:
    bl      .Ldivide_far
    b       .Lbegun
.Lfar:
    bl      .Ldivide_far
    b       .Lends
.Lfar_short:
    bl      .Ldivide_far
    b       .Lends_short
.Ldivide_far:
    sub     r9, r9, r1
    sub     r10, r10, r1
    sub     r11, r11, r1
    smull   r1, r2, r4, r3
    shift_down r2, r1, r10
    smull   r1, r4, r6, r3
    shift_down r4, r1, r11
    smull   r1, r7, r7, r3
    shift_down r7, r1, r9
    mov     r1, lr
    add     lr, sp, #(.LBLOCK + BLOCK_BYTES)
    bx      r1

/* --- the face ------------------------------------------------------------------------------- */

/* What the frame has of the face in r0. Keeps r0 to r3. */
.Lprepare:
    add     r4, sp, #.LBLOCK
    str     r4, [sp, #.LBLOCK - 4]
    mvn     r5, #0x80000000
    ldr     r6, [r0, #SEGMENT_FACE_DROP_MIN]
    strd    r5, r6, [r4]
    ldr     r5, [r0, #SEGMENT_FACE_LIGHT_DROP]
    ldrd    r6, r7, [r0, #SEGMENT_FACE_U_DROP]
    ldr     r8, [r0, #SEGMENT_FACE_LIGHT_MAX]
    adds    r4, #(BLOCK_STEP + 4)
    stm     r4, {r5-r8}
    ldrd    r5, r6, [r0, #SEGMENT_FACE_TEXELS]
    ldr     r7, [r0, #SEGMENT_FACE_RAMP]
    add     r4, sp, #.LLOADED
    stm     r4, {r5-r7}
    movs    r4, #255
    str     r4, [sp, #.LFRAME_LOG]
    ldrb    r5, [r0, #SEGMENT_FACE_LOG_WIDTH]
    ldrb    r6, [r0, #SEGMENT_FACE_ROW_DROP]
    rsb     r5, r5, #32
    strd    r5, r6, [sp, #.LFRAME_COLUMN]
    ldrb    r5, [r0, #SEGMENT_FACE_FORM]
    movs    r6, #26
    cbz     r5, 1f
    movw    r7, #WHOLE
    mul     r5, r5, r7
    adr     r7, .Lpixels_5 - WHOLE + 1  /* Thumb code */
    add     r5, r5, r7
    strd    r5, r6, [sp, #.LFRAME_CODE]
    bx      lr
1:  adr     r5, .Lloop + 1
    movs    r6, #0
    strd    r5, r6, [sp, #.LFRAME_CODE]
    bx      lr

/* A word of 64 bits is shifted to the right by r5, from 0 to 2. r6: 32 - r5. */
    .macro  shift_step low, high
    lsl     lr, \high, r6
    lsr     \low, \low, r5
    orr     \low, \low, lr
    asr     \high, \high, r5
    .endm

/* The frame for segments of 2^r4 columns: a step is that of 16, shifted. r0: face. Keeps r1 to r4. */
.Lset_log:
    str     r4, [sp, #.LFRAME_LOG]
    movs    r5, #1
    lsl     r5, r5, r4
    rsb     r6, r5, #16
    strd    r6, r6, [sp, #.LFRAME_SHORT]  /* FRAME_BEFORE too */
    ldrd    r7, r8, [sp, #.LFRAME_CODE]
    mla     r7, r6, r8, r7
    str     r7, [sp, #.LFRAME_FULL]
    adds    r7, r4, #4
    lsl     r8, r5, #3
    strd    r7, r8, [sp, #.LFRAME_SHIFT]
    rsb     r5, r4, #4
    rsb     r6, r5, #32
    ldm     r0, {r7-r12}
    shift_step r7, r8
    shift_step r9, r10
    shift_step r11, r12
    add     lr, sp, #.LSTEPS
    stm     lr, {r7-r12}
    ldr     r7, [r0, #SEGMENT_FACE_LIGHT_STEP]
    asr     r7, r7, r5
    str     r7, [sp, #.LBLOCK + BLOCK_STEP]
    b       .Lsame_log

/* --- pixels --------------------------------------------------------------------------------- */

#include "lit_texels_armv7m.h"

    .size fxl_paint_lit_run, . - fxl_paint_lit_run

#endif
