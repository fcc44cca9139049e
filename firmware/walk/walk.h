/* SPDX-License-Identifier: MIT */
/* Draws a scene along its path. Uses a board only through boards/contract. */
#ifndef WALK_H
#define WALK_H

#include "path.h"

/* Opens the board's scene, draws the frames that system.h asks for, and prints the end marker
 * "walk: done N frames". Built with WALK_REPEATS it draws them again and again, and returns only when something failed. Unless the run is live, frames 3, 7, 11 ... are drawn as two rectangles of
 * columns, and noted with 0 instructions. Requires that system_start was called. Returns a SYSTEM_EXIT_... code.
 * Unless it is SYSTEM_EXIT_DONE, a sentence was printed before. Memory: WALK_BAND_BYTES for
 * pixels, WALK_ORDER_ENTRIES for the order of drawing, and WALK_LIST_BYTES, of which the scene's parts
 * take what they need (plan.h). The board's board.mk sets both. */
int walk(void);

#if defined WALK_IN_PARTS
/* The parts of it, for a program that does not wait until all frames are drawn. They return a code as walk does. Other programs have them
 * inside walk, which takes less stack. */

/* Opens the board's scene, and sets the renderer and the path up. When it is called again, the scene begins as it was made. */
int walk_open(walk_path *path);

/* Opens journal and display for so many frames. Requires walk_open. */
int walk_show(uint32_t frames);

/* Draws a frame and goes on along the path. Requires walk_show. */
int walk_frame(walk_path *path, uint32_t frame);
#endif

#endif
