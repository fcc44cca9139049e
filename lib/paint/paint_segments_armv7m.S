/* SPDX-License-Identifier: MIT */
/* fxl_paint_segments and fxl_paint_rows for Armv7-M and Armv8-M Mainline, and all of it for faces
 * without light. lib/paint/segments.h and plain_rows.h state what they require and do. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_TEXELS_IN_ASSEMBLY

#define ROWS        fxl_paint_rows
#define RUNS        fxl_paint_runs
#define HOLES       fxl_paint_holes
#define WIDE        0
#define TABLE       SEGMENT_FACE_TABLE
#define PIXEL       16
#define WHOLE       260
#define PIXEL_PLAIN 14
#define WHOLE_PLAIN 228

    .syntax unified
    .thumb
    .section .text.fxl_paint_segments, "ax", %progbits
    .global fxl_paint_rows
#if !FXL_IS_COMPACT
    .global fxl_paint_holes
    .global fxl_paint_runs
#endif
    .global fxl_paint_segments
    .type fxl_paint_segments, %function
    .thumb_func

fxl_paint_segments:
    ldr     r12, [r0, #SEGMENT_FACE_RAMP]
    cmp     r12, #0
    bne     fxl_paint_lit_segments
#include "plain_rows_armv7m.h"

    .macro  store i
    .if     \i < 16
    strb    r3, [pixels, #\i]
    .else
    strb    r3, [pixels, #\i]!
    .endif
    .endm

    .macro  store_by_table i
    ldrb    r3, [texels, r3]
    ldrb    r3, [table, r3]
    store   \i
    .endm

    .macro  store_texel i
    ldrb    r3, [texels, r3]
    store   \i
    .endm

    .align  2
.Lpixels_5:
    sixteen 5, store_by_table
    .org    .Lpixels_5 + WHOLE
    sixteen 6, store_by_table
    .org    .Lpixels_5 + 2 * WHOLE
    sixteen 7, store_by_table
    .org    .Lpixels_5 + 3 * WHOLE
    sixteen 8, store_by_table

    .org    .Lpixels_5 + 4 * WHOLE
.Lplain_5:
    sixteen 5, store_texel
    .org    .Lplain_5 + WHOLE_PLAIN
    sixteen 6, store_texel
    .org    .Lplain_5 + 2 * WHOLE_PLAIN
    sixteen 7, store_texel
    .org    .Lplain_5 + 3 * WHOLE_PLAIN
    sixteen 8, store_texel
    .size fxl_paint_segments, . - fxl_paint_segments

#endif
