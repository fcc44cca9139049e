/* SPDX-License-Identifier: MIT */
/* Board contract: how much work was done. */
#ifndef BOARD_CLOCK_H
#define BOARD_CLOCK_H

#include <stdint.h>

/* Instructions executed since the board started, never decreasing; differences
 * count. Its step is the board's affair and stands in its board.c.
 * Always 0 where the board cannot tell. */
uint64_t clock_instructions(void);

#endif
