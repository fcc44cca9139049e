/* SPDX-License-Identifier: MIT */
/* fxl_draw_outline for Armv7-M and Armv8-M Mainline. lib/raster/draw_outline.h states what it
 * requires and does; it writes the same bytes as lib/raster/draw_outline.c. The
 * arithmetic, with its bounds, is that of lib/raster/edge.h and
 * lib/raster/edge_divide.h. An outline is drawn here if it is scanned between two chains,
 * which survey in lib/raster/scan.c defines; fxl_draw_by_active_edges draws any other, and all
 * outlines into a band that has some columns alone. */
/* place fill-rule: outlines and rows for Armv7-M; half a pixel is a number here */
#include "../math/family.h"
#include "../math/offsets.h"
#include "draw_frame_armv7m.h"

#if FXL_KERNELS_ARMV7M

/* draw_outline_rgb565_armv7m.S has this text with other names, and FXL_PIXELS_OF_16_BITS. */
#ifndef FXL_PIXELS_OF_16_BITS
#define DRAW_OUTLINE         fxl_draw_outline
#define DRAW_ROWS_BELOW      fxl_draw_rows_below
#define DRAW_BY_ACTIVE_EDGES fxl_draw_by_active_edges
#define FILL_ROWS            fxl_fill_rows
    .global fxl_draw_outline
    .global fxl_draw_rows_below
#endif

    .syntax unified
    .thumb

#define NO_ROW 0

    .macro enter_outline
    str     r0, [sp, #FRAME_SCAN]
    adds    r0, r1, #SCREEN_POLYGON_POINTS
    ldrb    r5, [r1, #SCREEN_POLYGON_COUNT]
    ldrh    r6, [r2, #BAND_COLUMNS]
    ldrh    r4, [r2, #BAND_WIDTH]
    cbnz    r6, .Lcolumns
    .endm

    /* The colour in each byte, or the pixel in each half. */
    .macro begin_filling
#ifndef FXL_PIXELS_OF_16_BITS
    orr     r3, r3, r3, lsl #8
#endif
    orr     r3, r3, r3, lsl #16
    .endm

    /* Edges are addresses. */
    .macro find_base
    ldr     r6, [r2, #BAND_PIXELS]
    ldrh    r7, [r2, #BAND_STRIDE]
#ifdef FXL_PIXELS_OF_16_BITS
    lsrs    r6, r6, #1              /* places are counted in pixels, from address 0 */
#endif
    mls     r6, r12, r7, r6
    adds    r6, r6, #1
    .endm

    .macro leave_other
    subs    r1, r0, #SCREEN_POLYGON_POINTS
    ldr     r0, [sp, #FRAME_SCAN]
    add     sp, sp, #FRAME_SIZE
    pop     {r4-r11, lr}
    b.w     DRAW_BY_ACTIVE_EDGES
    .endm

    .macro begin_rows_below
    .hidden DRAW_ROWS_BELOW
    .type DRAW_ROWS_BELOW, %function
    .thumb_func
DRAW_ROWS_BELOW:
.Lrows_below:
    .endm

    .macro fill_rows
    b.w     FILL_ROWS
    .endm

    .section .text.DRAW_OUTLINE, "ax", %progbits
    .type DRAW_OUTLINE, %function
    .thumb_func

/* Input: r0: scan, r1: polygon, r2: band, r3: colour. */
DRAW_OUTLINE:
#include "outline_armv7m.h"

    .size DRAW_OUTLINE, . - DRAW_OUTLINE

#endif
