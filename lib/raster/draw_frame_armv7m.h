/* SPDX-License-Identifier: MIT */
/* The stack frame that draw_outline_armv7m.S and fill_rows_armv7m.S share, below the nine registers
 * that both push first. Offsets from sp, in bytes. */
#ifndef FXL_DRAW_FRAME_H
#define FXL_DRAW_FRAME_H

/* The left edge, then the right one, as fill_rows_armv7m.S has them in r4-r11. Free while rows are
 * filled. */
#define FRAME_EDGES 0
#define FRAME_SCAN 0 /* before the edges */
/* The next ones, up to the left chain, are written by one instruction. */
#define FRAME_BEGIN  32 /* the first point of the outline */
#define FRAME_END    36 /* one past the last point */
#define FRAME_COLOUR 40 /* in each of four bytes */
#define FRAME_LAST   44 /* the last row to draw */
#define FRAME_UNTIL  48 /* the last row of this trapezoid; with FRAME_EXCHANGED: see there */
#define FRAME_BASE   52 /* where row 0 of the screen would begin, plus 1 */
#define FRAME_STRIDE 56
#define FRAME_LEFT   60 /* left chain: the vertex where the next edge begins; the edge's last row */
#define FRAME_RIGHT  68 /* right chain */
#define FRAME_SIZE   76

/* Set in FRAME_UNTIL while the left and the right edge are exchanged. */
#define FRAME_EXCHANGED 0x40000000

#endif
