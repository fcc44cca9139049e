/* SPDX-License-Identifier: MIT */
/* The text of fxl_draw_smooth_outline_8 and fxl_draw_smooth_outline_16 for Armv7-M and Armv8-M
 * Mainline. lib/paint/smooth_outline.h states what they require and do; their pixels are those of
 * paint_lights in paint_pixels.c and paint_rgb565.c. A file defines PIXEL_BITS, and includes this
 * one right after the label of its function. A row takes 38 instructions before its pixels, a
 * visible pixel 14, of 16 bits 18, and a hidden one 8. */
#include "../math/family.h"
#include "../math/offsets.h"
#include "../raster/draw_frame_armv7m.h"
#include "cell_edges_armv7m.h"

/* Where the words of a row are, from those of the outline on. */
#define ROW_WORDS SMOOTH_OUTLINE_CODE

/* The words become those of the row above the first one, r6, at cell 0 of the band, and what a row adds
 * less a row of cells. r12: the band's first row. */
    .macro begin_filling
    test_clear SMOOTH_OUTLINE_CELLS
    ldrh    lr, [r2, #BAND_WIDTH]
    sub     r10, r6, #1
    ldr     r4, [r3, #SMOOTH_OUTLINE_CODE_ALONG]
    ldrd    r5, r8, [r3, #SMOOTH_OUTLINE_CODE]
    mul     r4, r4, lr
    sub     r8, r8, r4
    mla     r5, r12, r4, r5
    mla     r5, r10, r8, r5
    strd    r5, r8, [r3, #SMOOTH_OUTLINE_CODE]
    ldrd    r8, r5, [r3, #SMOOTH_OUTLINE_LIGHT_DOWN]
    ldr     r4, [r3, #SMOOTH_OUTLINE_LIGHT_ALONG]
    mul     r4, r4, lr
    sub     r8, r8, r4
    mla     r5, r12, r4, r5
    mla     r5, r10, r8, r5
    strd    r8, r5, [r3, #SMOOTH_OUTLINE_LIGHT_DOWN]
    adds    r3, r3, #ROW_WORDS
    .endm

    .macro fill_rows
    b       .Lrow
    .endm

#define OUTLINE_OF_ROW (FRAME_OUTLINE + 36) /* below what a row keeps: r4-r12 */

/* The pixel of r4 is tested: r3: its code. Goes to .Lhidden\text, or keeps the code. */
    .macro  test_pixel text
    lsr     r1, r3, #16
    test_code \text
    .endm

/* r1: the code of the cell. */
    .macro  test_code text
    ldrh    r0, [r4], #2
    cmp     r1, r0
    bls     .Lhidden\text
    strh    r1, [r4, #-2]
    .endm

/* The same where codes may have a border. */
    .macro  test_bent_pixel text
    ldr     r1, [sp, #OUTLINE_OF_ROW]
    ldr     r1, [r1, #SMOOTH_OUTLINE_BORDER - ROW_WORDS]
    subs    r1, r3, r1
    ite     lo
    addlo   r1, r1, r3
    movhs   r1, r3
    lsr     r1, r1, #16
    test_code \text
    .endm

/* On to the next pixel, whose cell is that of r4; r6, r7: light, along. */
    .macro  next_pixel text
.Lhidden\text:
    add     r3, r3, lr
    add     r6, r6, r7
#if PIXEL_BITS == 8
    adds    r5, r5, #1
#endif
    cmp     r4, r2
    blo     .Lpixel\text
    .endm

#if PIXEL_BITS == 16

/* light: not below 0; r8: the part of a level, r9-r12: the mixture. */
    .macro  paint_light light
    umull   r1, r0, \light, r8
    mla     r1, r10, r0, r9
    mla     r0, r12, r0, r11
    lsr     r0, r0, #13
    bfi     r1, r0, #13, #6         /* green above blue */
    lsr     r0, r1, #27
    lsr     r1, r1, #8
    bfi     r1, r0, #11, #5
    strh    r1, [r4, r5]
    .endm

#endif

#include "../raster/outline_armv7m.h"

#if PIXEL_BITS == 16

/* fxl_draw_smooth_triangle_16: the rows of a triangle whose box has so many columns and centres at most, and
 * the outline's small_rows, are found by edge functions, as those of small_triangle_armv7m.h. Others are drawn as
 * outlines are. */
#define SMALL_COLUMNS 8
#define SMALL_CENTRES 20

/* In the stack frame: the edge functions at the first centre of a row, their changes from row to row,
 * columns, the last row plus 1, cells a row, the last column plus 1, the first row, corners and band. Below
 * it are the spans: the end of the cells, code, cell and light, after a word that is 0. */
#define SMALL_CHANGES 12
#define SMALL_COLUMN  24
#define SMALL_END     28
#define SMALL_WIDTH   32
#define SMALL_RIGHT   36
#define SMALL_ROW     40
#define SMALL_POINTS  44

    .global fxl_draw_smooth_triangle_16
    .type fxl_draw_smooth_triangle_16, %function
    .thumb_func

/* r0: corners, r1: band, r2: outline; returns as above. */
fxl_draw_smooth_triangle_16:
    push    {r4-r11, lr}
    sub     sp, sp, #FRAME_SIZE
    ldm     r0, {r4-r9}
    ldrd    r10, r11, [r0, #SCREEN_CORNERS_WIDTH]
    strd    r0, r1, [sp, #SMALL_POINTS]
/* place fill-rule: small triangles for Armv7-M */
    ldrd    r12, lr, [r0, #INSIDE_CORNERS_LEAST]
    movw    r3, #0x7FFF
    add     r12, r12, r3
    add     lr, lr, r3
    add     r10, r10, r12
    add     r11, r11, lr
    asr     r12, r12, #16           /* the first column */
    asr     lr, lr, #16             /* the first row */
    rsb     r10, r12, r10, asr #16  /* columns */
    rsb     r11, lr, r11, asr #16   /* rows */
    mul     r3, r10, r11
    sub     r3, r3, #1              /* 2^32 - 1: no centre */
    ldr     r0, [r2, #SMOOTH_OUTLINE_SMALL_ROWS]
    cmp     r11, r0
    itt     ls
    cmpls   r10, #SMALL_COLUMNS
    cmpls   r3, #SMALL_CENTRES - 1
    bhi     .Lsmall_not
    ldrh    r3, [r1, #BAND_FIRST_ROW]
    ldrh    r0, [r1, #BAND_ROWS]
    ldrh    r1, [r1, #BAND_WIDTH]
    sub     r3, lr, r3              /* the row in the band */
    subs    r0, r0, r11
    it      hs
    cmphs   r0, r3
    blo     .Lsmall_not
    mul     r3, r3, r1              /* the first cell of the row */
    add     r11, r11, lr
    add     r0, r12, r10
    strd    r10, r11, [sp, #SMALL_COLUMN]
    strd    r1, r0, [sp, #SMALL_WIDTH]
    str     lr, [sp, #SMALL_ROW]
    test_clear SMOOTH_OUTLINE_CELLS, r2, lr, r11, r0, r1, r10
    lsl     r10, r12, #16
    lsl     r11, lr, #16
    add     r10, r10, #32768
    add     r11, r11, #32768
    add     lr, r0, r3, lsl #1
    adds    r3, r2, #SMOOTH_OUTLINE_CODE_ALONG
    relative_points
    functions_of_points .Lsmall_turned
    strd    r1, r2, [sp]
    str     r7, [sp, #8]
    strd    r5, r6, [sp, #SMALL_CHANGES]
    str     r4, [sp, #SMALL_CHANGES + 8]
    ldr     r8, [sp, #SMALL_ROW]
    mov     r9, sp
    movs    r5, #0
    str     r5, [sp, #-16]!
    mov     r12, lr

    /* A row. r1, r2, r7: the edge functions, r10, r11, r0: their change a column, r4: columns that are
     * left, r3: the words, r8: the row, r9: the frame, r12: the cell of column 0 */
.Lsmall_row:
    ldr     r4, [r9, #SMALL_COLUMN]
.Lsmall_outside:
    orr     r5, r1, r2
    orrs    r5, r5, r7
    bpl     .Lsmall_first
    subs    r4, r4, #1
    add     r1, r1, r10
    add     r2, r2, r11
    add     r7, r7, r0
    bne     .Lsmall_outside
    b       .Lsmall_next
.Lsmall_first:
    mov     r6, r4
.Lsmall_inside:
    subs    r4, r4, #1
    beq     .Lsmall_last
    add     r1, r1, r10
    add     r2, r2, r11
    add     r7, r7, r0
    orr     r5, r1, r2
    orrs    r5, r5, r7
    bpl     .Lsmall_inside
.Lsmall_last:
    ldr     lr, [r9, #SMALL_RIGHT]
    sub     lr, lr, r6              /* the first one's column */
    sub     r6, r6, r4              /* pixels */
    ldm     r3, {r1, r2, r4, r5, r7} /* code: along, at, down; light: down, at */
    mla     r2, r4, r8, r2
    ldr     r4, [r3, #SMOOTH_OUTLINE_LIGHT_ALONG - SMOOTH_OUTLINE_CODE_ALONG]
    mla     r5, r5, r8, r7
    mla     r2, r1, lr, r2
    mla     r5, r4, lr, r5
    add     r4, r12, lr, lsl #1
    add     r1, r4, r6, lsl #1
    push    {r1, r2, r4, r5}
.Lsmall_next:
    ldrd    r5, r6, [r9, #SMALL_END]
    add     r8, r8, #1
    cmp     r8, r5
    beq     .Lsmall_rows_done
    add     r12, r12, r6, lsl #1
    ldm     r9, {r1, r2, r4-r7}
    add     r1, r1, r5
    add     r2, r2, r6
    add     r7, r7, r4
    strd    r1, r2, [r9]
    str     r7, [r9, #8]
    b       .Lsmall_row

.Lsmall_rows_done:
    ldr     lr, [r3]
    ldr     r5, [r3, #SMOOTH_OUTLINE_PIXELS - SMOOTH_OUTLINE_CODE_ALONG]
    adds    r3, r3, #SMOOTH_OUTLINE_LIGHT_ALONG - SMOOTH_OUTLINE_CODE_ALONG
    ldm     r3, {r7-r12}            /* along, by, mixture */
.Lsmall_span:
    pop     {r2, r3, r4, r6}
    cmp     r2, #0
    beq     .Lsmall_done
.Lpixel_small:
    test_pixel _small
    paint_light r6
    next_pixel _small
    b       .Lsmall_span
.Lsmall_done:
    movs    r0, #1
    add     sp, sp, #FRAME_SIZE
    pop     {r4-r11, pc}

.Lsmall_turned:
    subs    r2, r3, #SMOOTH_OUTLINE_CODE_ALONG
.Lsmall_not:
    mov     r3, r2
    ldrd    r0, r2, [sp, #SMALL_POINTS]
    ldrh    r4, [r2, #BAND_WIDTH]
    movw    r11, #32767
    add     r4, r4, #1
    lsl     r4, r4, #16
    add     r1, r0, #24
    b       .Ltriangle

#endif

    return_not_clear

    /* The right edge is not right of the left one. */
.Lno_pixel:
    beq     .Lempty
    mov     r2, r8
    rsb     r0, r0, #0
    b       .Lspan
.Lempty:
    step_edges
    ldr     r1, [sp, #FRAME_OUTLINE]
    ldrd    r0, r2, [r1]
    ldrd    r3, lr, [r1, #SMOOTH_OUTLINE_LIGHT_DOWN - ROW_WORDS]
    add     r0, r0, r2
    add     lr, lr, r3
    str     r0, [r1]
    str     lr, [r1, #SMOOTH_OUTLINE_LIGHT - ROW_WORDS]
    b       .Lnext_row

.Lrow_done:
    pop     {r4-r12}
.Lnext_row:
    subs    r12, r12, #1
    bmi     .Lrows_below
.Lrow:
    mov     r2, r4
    subs    r0, r8, r4
    ble     .Lno_pixel
.Lspan:                             /* r0: pixels, r2: the first cell */
    ldr     r1, [sp, #FRAME_OUTLINE]
    step_edges
    push    {r4-r12}                /* no call is below */
#if PIXEL_BITS == 16
    ldm     r1, {r3-r12}            /* code, its change, that of light, light, along, by, mixture */
#else
    ldm     r1, {r3-r8}
    ldr     r9, [r1, #SMOOTH_OUTLINE_LAST - ROW_WORDS]
#endif
    add     r3, r3, r4
    add     r6, r6, r5
    str     r3, [r1]
    str     r6, [r1, #SMOOTH_OUTLINE_LIGHT - ROW_WORDS]
    ldrd    r4, r5, [r1, #SMOOTH_OUTLINE_CELLS - ROW_WORDS]
    ldrd    r1, lr, [r1, #SMOOTH_OUTLINE_LIMIT - ROW_WORDS]
    mla     r3, lr, r2, r3
    add     r4, r4, r2, lsl #1
    mla     r6, r7, r2, r6
    add     r2, r4, r0, lsl #1
#if PIXEL_BITS == 8
    add     r5, r5, r4, lsr #1
#endif
    /* Light is linear: where that of both ends is of the ramp, all is. Codes that
     * have a border are tested by the loop of other light. */
    subs    r0, r0, #1
    mla     r0, r7, r0, r6
    cmp     r6, r1
    it      lo
    cmplo   r0, r1
    bhs     .Lpixel_held

#if PIXEL_BITS == 16
.Lpixel:
    test_pixel
    paint_light r6
    next_pixel
    b       .Lrow_done

.Lpixel_held:
    test_bent_pixel _held
    ldr     r1, [sp, #OUTLINE_OF_ROW]
    ldr     r1, [r1, #SMOOTH_OUTLINE_LAST - ROW_WORDS]
    bic     r0, r6, r6, asr #31
    cmp     r0, r1
    it      gt
    movgt   r0, r1
    paint_light r0
    next_pixel _held
    b       .Lrow_done
#else
.Lpixel:
    test_pixel
    lsr     r0, r6, #24
    add     r0, r8, r0, lsl #8
    ldrb    r0, [r0]
    strb    r0, [r5]
    next_pixel
    b       .Lrow_done

.Lpixel_held:
    test_bent_pixel _held
    asr     r0, r6, #24
    bic     r0, r0, r0, asr #31
    cmp     r0, r9
    it      gt
    movgt   r0, r9
    add     r0, r8, r0, lsl #8
    ldrb    r0, [r0]
    strb    r0, [r5]
    next_pixel _held
    b       .Lrow_done
#endif
