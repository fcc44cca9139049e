/* SPDX-License-Identifier: MIT */
/* fxl_paint_segments_565 and fxl_paint_rows_565 for Armv7-M and Armv8-M Mainline. lib/paint/segments.h
 * and plain_rows.h state what they require and do. */
#include "../math/family.h"
#include "../math/offsets.h"

#if FXL_TEXELS_IN_ASSEMBLY

#define ROWS        fxl_paint_rows_565
#define RUNS        fxl_paint_runs_565
#define HOLES       fxl_paint_holes_565
#define WIDE        1
#define TABLE       SEGMENT_FACE_PALETTE
#define PIXEL       18
#define WHOLE       292
#define PIXEL_PLAIN 16
#define WHOLE_PLAIN 260

    .syntax unified
    .thumb
    .section .text.fxl_paint_segments_565, "ax", %progbits
    .global fxl_paint_rows_565
#if !FXL_IS_COMPACT
    .global fxl_paint_holes_565
    .global fxl_paint_runs_565
#endif
    .global fxl_paint_segments_565
    .type fxl_paint_segments_565, %function
    .thumb_func

fxl_paint_segments_565:
#include "plain_rows_armv7m.h"

    .macro  store_wide i
    .if     \i < 16
    strh    r3, [pixels, #(2 * \i)]
    .else
    strh    r3, [pixels, #(2 * \i)]!
    .endif
    .endm

    .macro  store_by_palette i
    ldrb    r3, [texels, r3]
    ldrh    r3, [table, r3, lsl #1]
    store_wide \i
    .endm

    .macro  store_colour i
    ldrh    r3, [texels, r3, lsl #1]
    store_wide \i
    .endm

    .align  2
.Lpixels_5:
    sixteen 5, store_by_palette
    .org    .Lpixels_5 + WHOLE
    sixteen 6, store_by_palette
    .org    .Lpixels_5 + 2 * WHOLE
    sixteen 7, store_by_palette
    .org    .Lpixels_5 + 3 * WHOLE
    sixteen 8, store_by_palette

    .org    .Lpixels_5 + 4 * WHOLE
.Lplain_5:
    sixteen 5, store_colour
    .org    .Lplain_5 + WHOLE_PLAIN
    sixteen 6, store_colour
    .org    .Lplain_5 + 2 * WHOLE_PLAIN
    sixteen 7, store_colour
    .org    .Lplain_5 + 3 * WHOLE_PLAIN
    sixteen 8, store_colour
    .size fxl_paint_segments_565, . - fxl_paint_segments_565

#endif
