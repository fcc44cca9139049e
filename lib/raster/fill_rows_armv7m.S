/* SPDX-License-Identifier: MIT */
/* fxl_fill_trapezoid for Armv7-M and Armv8-M Mainline. lib/raster/fill.h states
 * what it requires and does; it writes the same bytes as lib/raster/fill.c. The
 * rows are fxl_fill_rows, which fxl_draw_outline uses too.
 *
 * Both edges are kept as addresses: the row's address is added to x, and the stride is added
 * to the step. So a row's span goes from one address to the other, and a step is two
 * additions an edge. Every store is aligned. */
#include "../math/family.h"
#include "../math/offsets.h"
#include "draw_frame_armv7m.h"

#if FXL_KERNELS_ARMV7M && !FXL_FILLS_COMPACT && (!FXL_KERNELS_MVE || defined FXL_ROWS_BY_VECTORS)
#include "fill_entry_armv7m.h"

#define NARROW_ROWS 16      /* from here on the test for narrow rows pays */

/* Pixels of 64 bytes, and of 32. */
#ifdef FXL_PIXELS_OF_16_BITS
#define LONG_ROW    32
#define UPRIGHT_ROW 16
#else
#define LONG_ROW    64
#define UPRIGHT_ROW 32
#endif

#ifndef FXL_PIXELS_OF_16_BITS
    .global fxl_fill_rows
#endif
    .hidden FILL_ROWS
    .type FILL_ROWS, %function
    .thumb_func

/* Fills rows with the registers above and the frame of draw_frame_armv7m.h, and continues at
 * fxl_draw_rows_below. There r4-r11 are those of the row below. It keeps none of the other
 * registers. */
FILL_ROWS:
    cmp     left_step, right_step
    beq     .Ltest_upright
.Lslanted:
#ifdef FXL_ROWS_BY_VECTORS
#ifdef FXL_PIXELS_OF_16_BITS
    vdup.16 q0, colour
#else
    vdup.8  q0, colour
#endif
#endif
    cmp     rows, #NARROW_ROWS
    bhs     .Ltest_narrow

    .macro next_row
    step_edges
    bcs     .Lrow
    b.w     DRAW_ROWS_BELOW
    .endm

.Lrow:
    sub     bytes, right, left
#ifdef FXL_ROWS_BY_VECTORS
    cmp     bytes, #LONG_ROW
    bhs     .Llong
    /* 16 bytes at a time, the last time only the bytes that remain. lr is free. */
#ifdef FXL_PIXELS_OF_16_BITS
    lsls    pixel, left, #1
    wlstp.16 lr, bytes, .Lnext
.Lvector:
    vstrh.16 q0, [pixel], #16
#else
    mov     pixel, left
    wlstp.8 lr, bytes, .Lnext
.Lvector:
    vstrb.8 q0, [pixel], #16
#endif
    letp    lr, .Lvector
.Lnext:
    next_row
#elif defined FXL_PIXELS_OF_16_BITS
    cmp     bytes, #8
    blo     .Lshort
    cmp     bytes, #LONG_ROW
    bhs     .Llong
    lsls    pixel, left, #1
    lsrs    spare, left, #1
    bcc     .Lrest
    strh    colour, [pixel], #2
    subs    bytes, bytes, #1
#else
    cmp     bytes, #8
    blo     .Lshort
    cmp     bytes, #LONG_ROW
    bhs     .Llong

    /* Store up to a multiple of four: 0 to 3 bytes, of at least 8. Always three are stored, which
     * takes half of the cycles of a branch to the right number. */
    strb    colour, [left]
    strb    colour, [left, #1]
    strb    colour, [left, #2]
    adds    pixel, left, #3
    bic     pixel, pixel, #3
    sub     bytes, right, pixel
#endif
.Lrest:
    tbb     [pc, bytes]
.Lends:
    .irp    words, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
#ifdef FXL_PIXELS_OF_16_BITS
    .byte   (.Lend_0_\words - .Lends) / 2, (.Lend_2_\words - .Lends) / 2
#else
    .byte   (.Lend_0_\words - .Lends) / 2, (.Lend_1_\words - .Lends) / 2
    .byte   (.Lend_2_\words - .Lends) / 2, (.Lend_3_\words - .Lends) / 2
#endif
    .endr

/* The words and the tail of 0 to 3 bytes, once for each length of the tail. The tail is
 * stored from the right end back. Words are stored from the last pair to the first, so each
 * number of words has a label at which to enter. */
    .macro tail length
    .if     \length == 3
    strh    colour, [right, #-3]
    .endif
    .if     \length == 2
#ifdef FXL_PIXELS_OF_16_BITS
    subs    bytes, bytes, #1
    strh    colour, [pixel, bytes, lsl #1]
#else
    strh    colour, [right, #-2]
#endif
    .endif
    .if     \length & 1
    strb    colour, [right, #-1]
    .endif
    next_row
    .endm

    .macro words_and_tail length
    .irp    words, 14, 12, 10, 8, 6, 4, 2
.Lend_\length\()_\words:
    strd    colour, colour, [pixel, #4 * \words - 8]
    .endr
.Lend_\length\()_0:
    tail    \length
    .irp    words, 15, 13, 11, 9, 7, 5, 3
.Lend_\length\()_\words:
    strd    colour, colour, [pixel, #4 * \words - 8]
    .endr
.Lend_\length\()_1:
    str     colour, [pixel]
    tail    \length
    .endm

    words_and_tail 0
#ifndef FXL_PIXELS_OF_16_BITS
    words_and_tail 1
#endif
    words_and_tail 2
#ifndef FXL_PIXELS_OF_16_BITS
    words_and_tail 3
#endif

/* Stores one of up to 7 pixels. */
    .macro one_pixel place
#ifdef FXL_PIXELS_OF_16_BITS
    strh    colour, [pixel, #2 * (\place)]
#else
    strb    colour, [left, #\place]
#endif
    .endm

#ifndef FXL_ROWS_BY_VECTORS
    /* Fewer than 8 pixels, perhaps none. */
.Lshort:
#ifdef FXL_PIXELS_OF_16_BITS
    lsls    pixel, left, #1
#endif
    tbb     [pc, bytes]
.Lshorts:
    .byte   (.Lnext - .Lshorts) / 2, (.Lshort1 - .Lshorts) / 2
    .byte   (.Lshort2 - .Lshorts) / 2, (.Lshort3 - .Lshorts) / 2
    .byte   (.Lshort4 - .Lshorts) / 2, (.Lshort5 - .Lshorts) / 2
    .byte   (.Lshort6 - .Lshorts) / 2, (.Lshort7 - .Lshorts) / 2
.Lshort7:
    one_pixel 6
.Lshort6:
    one_pixel 5
.Lshort5:
    one_pixel 4
.Lshort4:
    one_pixel 3
.Lshort3:
    one_pixel 2
.Lshort2:
    one_pixel 1
.Lshort1:
    one_pixel 0
.Lnext:
    next_row
#endif

    /* Many rows, each of fewer than 8 pixels. The distance of the edges changes evenly from row to
     * row: where it is -1 or more and below 7 on the first and on the last row, every row has -1 to
     * 7 pixels. */
.Ltest_narrow:
    subs    r0, right_fraction, left_fraction
    sbc     r1, right, left
    adds    r1, r1, #1
    cmp     r1, #8
    bhs     .Lrow
    subs    spare, right_step_fraction, left_step_fraction
    sbc     lr, right_step, left_step
    umlal   r0, r1, spare, rows
    mla     r1, lr, rows, r1
    cmp     r1, #8
    bhs     .Lrow
    adds    right, right, #1
.Lnarrow_row:
    sub     bytes, right, left
#ifdef FXL_PIXELS_OF_16_BITS
    lsls    pixel, left, #1
#endif
    tbb     [pc, bytes]
.Lnarrows:
    .byte   (.Lnarrow_crossed - .Lnarrows) / 2, (.Lnarrow_next - .Lnarrows) / 2
    .irp    length, 1, 2, 3, 4, 5, 6, 7
    .byte   (.Lnarrow\length - .Lnarrows) / 2
    .endr
    .align  1
    .irp    length, 7, 6, 5, 4, 3, 2, 1
.Lnarrow\length:
    one_pixel \length - 1
    .endr
.Lnarrow_next:
    step_edges
    bcs     .Lnarrow_row
    subs    right, right, #1
    b.w     DRAW_ROWS_BELOW
.Lnarrow_crossed:
    subs    right, right, #1
    b       .Lcrossed

    /* 64 bytes and more: eight registers at a time. */
.Llong:
    cmp     bytes, #0
    blt     .Lcrossed
#ifdef FXL_PIXELS_OF_16_BITS
    lsls    pixel, left, #1
    tst     left, #1
    itt     ne
    strhne  colour, [pixel], #2
    subne   bytes, bytes, #1
#else
    mov     pixel, left
    tst     left, #1
    it      ne
    strbne  colour, [pixel], #1
    tst     pixel, #2
    it      ne
    strhne  colour, [pixel], #2
    sub     bytes, right, pixel
#endif
    subs    bytes, #LONG_ROW
    blo     .Llong_end
    stm     sp, {r4-r11}
    mov     r4, colour
    mov     r5, colour
    mov     r6, colour
    mov     r7, colour
    mov     r8, colour
    mov     r9, colour
    mov     r10, colour
    mov     r11, colour
.Llong_block:
    stm     pixel!, {r4-r11}
    stm     pixel!, {r4-r11}
    subs    bytes, #LONG_ROW
    bhs     .Llong_block
    ldm     sp, {r4-r11}
.Llong_end:
    adds    bytes, #LONG_ROW
    b       .Lrest

.Lcrossed:
    exchange_edges
    b       .Lrow

/* place fill-rule: outlines and rows for Armv7-M; half a pixel is a number here */
    /* If both whole steps are 0 and no fraction will carry, every row has the same span. The
     * test pays from 32 bytes on. The step of an upright edge is 2^-32
     * (lib/raster/edge_divide.h). */
.Ltest_upright:
    ldr     lr, [sp, #FRAME_STRIDE]
    cmp     left_step, lr
    bne     .Lslanted
    orr     spare, left_step_fraction, right_step_fraction
    cmp     spare, #1
    bhi     .Lslanted
    sub     bytes, right, left
    cmp     bytes, #UPRIGHT_ROW
    blt     .Lslanted
    adds    spare, left_fraction, rows
    bcs     .Lslanted
    adds    spare, right_fraction, rows
    bcs     .Lslanted

    /* r4-r11: colour, lr: rows still to be filled. The edges stay in the frame. */
start   .req r3     /* of the row's span */
rest    .req r12    /* bytes of the row still to be stored */
stride  .req r2
    stm     sp, {r4-r11}
#ifdef FXL_PIXELS_OF_16_BITS
    lsls    start, left, #1
    lsls    bytes, bytes, #1        /* until the rows are filled */
#else
    mov     start, left
#endif
    .irp    register, r4, r5, r6, r7, r8, r9, r10, r11
    mov     \register, colour
    .endr
#ifdef FXL_PIXELS_OF_16_BITS
    lsl     stride, lr, #1
#else
    mov     stride, lr
#endif
    add     lr, rows, #1

.Lupright_row:
    ands    rest, start, #3
    mov     pixel, start
    bne     .Lupright_head
    mov     rest, bytes
.Lupright_body:
    lsrs    rest, rest, #5
#ifdef FXL_PIXELS_OF_16_BITS
    cmp     rest, #32
    bhi     .Lupright_wide
.Lupright_blocks:
#endif
    tbb     [pc, rest]
.Lblocks:
    .irp    blocks, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16
    .byte   (.Lblocks_end - 4 * \blocks - .Lblocks) / 2
    .endr
    .irp    blocks, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32
    .byte   (.Lblocks_end - 4 * \blocks - .Lblocks) / 2
    .endr
    .align  1
    .rept   32
    stm     pixel!, {r4-r11}
    .endr
.Lblocks_end:
    add     rest, start, bytes
    subs    rest, rest, pixel
    bne     .Lupright_tail
.Lupright_next:
    add     start, start, stride
    subs    lr, lr, #1
    bne     .Lupright_row
    ldm     sp, {r4-r11}
#ifdef FXL_PIXELS_OF_16_BITS
    lsrs    left, start, #1
    add     right, left, bytes, lsr #1
#else
    mov     left, start
    add     right, start, bytes
#endif
    b.w     DRAW_ROWS_BELOW

.Lupright_head:
#ifdef FXL_PIXELS_OF_16_BITS
    strh    r4, [pixel], #2
#else
    tst     rest, #1
    it      ne
    strbne  r4, [pixel], #1
    tst     pixel, #2
    it      ne
    strhne  r4, [pixel], #2
#endif
    add     rest, start, bytes
    sub     rest, rest, pixel
    b       .Lupright_body

#ifdef FXL_PIXELS_OF_16_BITS
    /* 33 to 63 blocks of 32 bytes: what is more than 31, and then the rest. */
.Lupright_wide:
    subs    rest, rest, #31
.Lupright_block:
    stm     pixel!, {r4-r11}
    subs    rest, rest, #1
    bne     .Lupright_block
    movs    rest, #31
    b       .Lupright_blocks
#endif

    /* Bits 4 to 0 of the rest, one after the other in the carry and sign flags. */
.Lupright_tail:
    lsls    rest, rest, #28
    it      cs
    stmcs   pixel!, {r4-r7}
    it      mi
    strdmi  r4, r5, [pixel], #8
    lsls    rest, rest, #2
    it      cs
    strcs   r4, [pixel], #4
    it      mi
    strhmi  r4, [pixel], #2
#ifndef FXL_PIXELS_OF_16_BITS
    lsls    rest, rest, #1
    it      mi
    strbmi  r4, [pixel]
#endif
    b       .Lupright_next

    .size FILL_TRAPEZOID, . - FILL_TRAPEZOID

#endif
