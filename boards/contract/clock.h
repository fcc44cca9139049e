/* SPDX-License-Identifier: MIT */
/* Board contract: a measure of the work that was done. */
#ifndef BOARD_CLOCK_H
#define BOARD_CLOCK_H

#include <stdint.h>

/* Returns the instructions executed since the board started; the cycles, where the board's note for
 * the tools says counts=cycles. It never decreases; only differences have a meaning. The resolution
 * depends on the board; its board.c states it. Always 0 where the board cannot count. */
uint64_t clock_instructions(void);

#endif
