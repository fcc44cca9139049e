/* SPDX-License-Identifier: MIT */
/* fxl_paint_divided for Armv7-M and Armv8-M Mainline. lib/paint/paint_divided.h states what it
 * requires and does. A pixel takes 15 instructions if the texels
 * are plain and less than 256 a row, and 19 to 25 if not; a segment takes about 90 more. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_TEXELS_IN_ASSEMBLY

/* clang-format off */
    .syntax unified
    .thumb

/* The frame: the row's numbers at the next segment, then: */
#define FRAME_WEIGHT 0
#define FRAME_U      8
#define FRAME_V      16
#define FRAME_FACE   24
#define FRAME_X      28 /* the next pixel; then the end of the pixels */
#define FRAME_PIXELS 36 /* of column 0 */
#define FRAME_Y      40 /* of the row; then the key, the colours, or the pattern of the pixels that are left */
#define FRAME_OWN    44
#define FRAME        48

#define LEAST 0x40004000 /* FXL_DIVIDED_LEAST */
#define U_BITS 18
#define V_BITS 11
#define SIZE_BITS 22 /* FXL_DIVIDED_SIZE_BITS */
#define PIXEL  52 /* bytes of the code of a pixel */

pixels  .req r0
texels  .req r1
columns .req r2
rows    .req r3
w       .req r4
w_step  .req r5
u       .req r6
u_step  .req r7
v       .req r8
v_step  .req r9
most    .req r10 /* 2^30 - 1 */

    .section .text.fxl_paint_divided, "ax", %progbits
    .global fxl_paint_divided
    .type fxl_paint_divided, %function
    .thumb_func

/* One of the row's numbers at a segment: its step times the segment's number in r12. */
    .macro  begin step, at, frame
    ldrd    r4, r5, [r0, #\step]
    umull   r6, r7, r4, r12
    mla     r7, r5, r12, r7
    ldrd    r4, r5, [r1, #\at]
    adds    r6, r6, r4
    adc     r7, r7, r5
    strd    r6, r7, [sp, #\frame]
    .endm

/* The words of a coordinate at a segment's first pixel, and of its slope. lr: the weight's leading zeros;
 * r12: the face. The next segment's number goes into the frame. */
    .macro  find_word word, slope_word, shift, step, slope, frame
    ldrd    r2, r3, [sp, #\frame]
    ldrd    r0, r1, [r12, #\step]
    adds    r0, r0, r2
    adc     r1, r1, r3
    strd    r0, r1, [sp, #\frame]
    ldr     r0, [r12, #\shift]
    adds    r0, r0, lr
    bmi     .Lnarrow_\word
    eor     r10, r3, r3, asr #31
    eor     r11, r1, r1, asr #31
    orr     r10, r10, r11
    clz     r10, r10
    cmp     r10, r0
    ble     .Lend
    rsb     r10, r0, #32
    lsl     \word, r3, r0
    lsr     r2, r2, r10
    orr     \word, \word, r2
    ldrd    r2, r3, [r12, #\slope]
    lsl     \slope_word, r3, r0
    lsrs    r2, r2, r10
    orr     \slope_word, \slope_word, r2
    adc     \slope_word, \slope_word, #0
.Lfound_\word:
    .endm

/* The same where r0, by which they are shifted to the left, is below 0. */
    .macro  narrow_word word, slope_word, slope
.Lnarrow_\word:
    rsb     r10, r0, #0
    asr     \word, r3, r10
    ldr     r3, [r12, #\slope + 4]
    asr     \slope_word, r3, r10
    b       .Lfound_\word
    .endm

/* Goes r0 pixels on, those of the segment before column r10. r0 becomes how many are painted from there
 * on, and r11 the column after them, which the frame has too. */
    .macro  begin_within
    mla     w, w_step, r0, w
    mla     u, u_step, r0, u
    mla     v, v_step, r0, v
    rsb     r0, r0, #16
    sub     r11, r11, r10
    cmp     r11, r0
    it      lo
    movlo   r0, r11
    add     r11, r10, r0
    str     r11, [sp, #FRAME_X]
    .endm

/* r0: face, r1: row, r2: x0, r3: x1 */
fxl_paint_divided:
    push    {r4-r11, lr}
    sub     sp, #FRAME
    strd    r2, r3, [sp, #FRAME_X]
    str     r0, [sp, #FRAME_FACE]
    lsr     r12, r2, #4
    ldrd    r2, r3, [r1, #PAINT_ROW_PIXELS] /* and y */
    strd    r2, r3, [sp, #FRAME_PIXELS]
    begin   DIVIDED_FACE_WEIGHT_STEP, PAINT_ROW_WEIGHT, FRAME_WEIGHT
    begin   DIVIDED_FACE_U_STEP, PAINT_ROW_U, FRAME_U
    begin   DIVIDED_FACE_V_STEP, PAINT_ROW_V, FRAME_V

.Lsegment:
    ldr     r12, [sp, #FRAME_FACE]
    ldrd    r0, r1, [sp, #FRAME_WEIGHT]
    ldrd    r2, r3, [r12, #DIVIDED_FACE_WEIGHT_STEP]
    adds    r2, r2, r0
    adc     r3, r3, r1
    strd    r2, r3, [sp, #FRAME_WEIGHT]
    cmp     r1, r3
    ite     gt
    movgt   r4, r3
    movle   r4, r1
    cmp     r4, #0
    ble     .Lend
    orr     r3, r3, r1
    clz     lr, r3
    lsl     r4, r4, lr
    cmp     r4, #LEAST
    blo     .Lend
    rsb     r2, lr, #32
    lsl     w, r1, lr
    lsr     r0, r0, r2
    orr     w, w, r0
    ldrd    r0, r1, [r12, #DIVIDED_FACE_WEIGHT_SLOPE]
    lsl     w_step, r1, lr
    lsr     r0, r0, r2
    orr     w_step, w_step, r0
    find_word u, u_step, DIVIDED_FACE_U_SHIFT, DIVIDED_FACE_U_STEP, DIVIDED_FACE_U_SLOPE, FRAME_U
    find_word v, v_step, DIVIDED_FACE_V_SHIFT, DIVIDED_FACE_V_STEP, DIVIDED_FACE_V_SLOPE, FRAME_V

    ldrd    r10, r11, [sp, #FRAME_X]
    ldrb    r1, [r12, #DIVIDED_FACE_KIND]
    ands    r0, r10, #15
    cmp     r1, #0
    bne     .Lother_kind
    cmp     r0, #0
    bne     .Lpartial
    add     r1, r10, #16
    cmp     r1, r11
    bhi     .Lpartial
    str     r1, [sp, #FRAME_X]
    ldr     r0, [sp, #FRAME_PIXELS]
    add     pixels, r0, r10
    add     r12, r12, #DIVIDED_FACE_TEXELS
    ldm     r12, {texels, columns, rows}
    mvn     most, #0xC0000000

    .align  2
.Lpixels:
    .irp    i, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
    lsr     r11, w, #16
    udiv    r11, most, r11
    mul     r12, r11, r11
    umull   r12, lr, r12, w
    add     w, w_step
    rsb     r11, lr, r11, lsl #15
    smull   r12, lr, r11, u
    add     u, u_step
    smull   r12, r11, r11, v
    add     v, v_step
    and     lr, columns, lr, lsr #U_BITS
    and     r11, rows, r11, lsr #V_BITS
    add     r11, texels
    ldrb    r11, [r11, lr]
    strb    r11, [pixels, #\i]
    .endr
    .if     . - .Lpixels - 16 * PIXEL
    .error  "PIXEL is not the size of a pixel's code"
    .endif
.Lsegment_end:
    ldrd    r0, r1, [sp, #FRAME_X]
    cmp     r0, r1
    bne     .Lsegment
.Lend:
    ldr     r0, [sp, #FRAME_X]
    add     sp, #FRAME
    pop     {r4-r11, pc}

    /* The last pixels of the code: as many as are painted. r0: those of the segment that are before them. */
.Lpartial:
    begin_within
    rsb     r0, r0, #16
    movs    r1, #PIXEL
    mul     r0, r0, r1
    adr     r1, .Lpixels + 1 /* Thumb code */
    add     lr, r0, r1
    ldr     r0, [sp, #FRAME_PIXELS]
    add     pixels, r0, r11
    subs    pixels, #16
    add     r12, r12, #DIVIDED_FACE_TEXELS
    ldm     r12, {texels, columns, rows}
    mvn     most, #0xC0000000
    bx      lr

/* --- texels that are not plain, or 256 a row ------------------------------------------------- */

/* The segment's pixels from r10 on, up to r11 at most; r0: how many it has before them; r12: the face. Pixels
 * are counted in r10, from bit 8 on; below are the bits of v, by which a shift goes. */
.Lother_kind:
    begin_within
    ldr     r3, [r12, #DIVIDED_FACE_KEY]
    cmp     r1, #2
    bne     1f
    ldr     r11, [sp, #FRAME_Y]
    and     r11, r11, #3
    lsl     r11, r11, #2
    lsr     r3, r3, r11
    and     r3, r3, #15
    orr     r3, r3, r3, lsl #4
    orr     r3, r3, r3, lsl #8
    orr     r3, r3, r3, lsl #16
    and     r11, r10, #3
    ror     r3, r3, r11
    rbit    r3, r3                      /* the first pixel is in the uppermost bit */
1:  str     r3, [sp, #FRAME_OWN]
    ldrb    r3, [r12, #DIVIDED_FACE_V_DROP]
    subs    r0, r0, #1
    orr     lr, r3, r0, lsl #8
    ldr     r0, [sp, #FRAME_PIXELS]
    add     pixels, r0, r10
    mov     r10, lr
    mov     r11, r1
    add     r12, r12, #DIVIDED_FACE_TEXELS
    ldm     r12, {texels, columns, rows}
    cmp     r11, #2
    blo     .Lkeyed
    beq     .Lstippled
    cmp     r11, #4
    blo     .Lfour_bits
    beq     .Lclamped
    b       .Lwide

/* u in lr, v in r11; on to the next pixel. */
    .macro  divide_pixel
    lsr     r11, w, #16
    mvn     r12, #0xC0000000
    udiv    r11, r12, r11
    mul     r12, r11, r11
    umull   r12, lr, r12, w
    add     w, w_step
    rsb     r11, lr, r11, lsl #15
    smull   r12, lr, r11, u
    add     u, u_step
    smull   r12, r11, r11, v
    add     v, v_step
    .endm

/* r11 = the number of the texel. */
    .macro  find_texel
    and     lr, columns, lr, lsr #U_BITS
    lsr     r11, r11, r10
    and     r11, r11, rows
    add     r11, lr
    .endm

    .macro  next_pixel first
    subs    r10, r10, #256
    bpl     \first
    b       .Lsegment_end
    .endm

    .align  2
.Lwide:
    divide_pixel
    find_texel
    ldrb    r11, [texels, r11]
    strb    r11, [pixels], #1
    next_pixel .Lwide

    .align  2
.Lclamped:
    divide_pixel
    usat    lr, #16, lr, asr #(SIZE_BITS - 16)
    usat    r11, #16, r11, asr #(SIZE_BITS - 16)
    lsr     lr, lr, columns
    lsr     r11, r11, r10
    and     r11, r11, rows
    add     r11, lr
    ldrb    r11, [texels, r11]
    strb    r11, [pixels], #1
    next_pixel .Lclamped

    .align  2
.Lkeyed:
    divide_pixel
    find_texel
    ldrb    r11, [texels, r11]
    ldr     r12, [sp, #FRAME_OWN]
    cmp     r11, r12
    it      ne
    strbne  r11, [pixels]
    adds    pixels, #1
    next_pixel .Lkeyed

    .align  2
.Lfour_bits:
    divide_pixel
    find_texel
    lsrs    r11, r11, #1
    ldrb    r11, [texels, r11]
    ite     cs
    lsrcs   r11, r11, #4
    andcc   r11, r11, #15
    ldr     r12, [sp, #FRAME_OWN]
    ldrb    r11, [r12, r11]
    strb    r11, [pixels], #1
    next_pixel .Lfour_bits

    .align  2
.Lstippled:
    ldr     r12, [sp, #FRAME_OWN]
    lsls    r12, r12, #1
    str     r12, [sp, #FRAME_OWN]
    bcs     1f
    add     w, w_step
    add     u, u_step
    add     v, v_step
    adds    pixels, #1
    b       2f
1:  divide_pixel
    find_texel
    ldrb    r11, [texels, r11]
    strb    r11, [pixels], #1
2:  next_pixel .Lstippled

    narrow_word u, u_step, DIVIDED_FACE_U_SLOPE
    narrow_word v, v_step, DIVIDED_FACE_V_SLOPE

    .size fxl_paint_divided, . - fxl_paint_divided

#endif
