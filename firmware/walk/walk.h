/* SPDX-License-Identifier: MIT */
/* Draws a scene along its path. Knows a board only by boards/contract. */
#ifndef WALK_H
#define WALK_H

/* Opens the board's scene, draws the frames that system.h asks for, and prints
 * the end marker "walk: done N frames". Requires system_start called.
 * Answers with a SYSTEM_EXIT_... code, after a sentence unless it is
 * SYSTEM_EXIT_DONE.
 * Memory: WALK_BAND_BYTES for pixels and WALK_ORDER_ENTRIES for the order of
 * drawing, which the board's board.mk sets. */
int walk(void);

#endif
