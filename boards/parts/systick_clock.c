/* SPDX-License-Identifier: MIT */
/* clock.h with SysTick, under QEMU with -icount shift=0, where one instruction takes one
 * nanosecond. BOARD_SYSTICK_HZ, of board.mk, is its clock. board_start has called systick_start.
 * The resolution is a tick. The clock's own interrupt, about twenty instructions in 2^24 ticks,
 * is counted, too. */
#include "contract/clock.h"
#include "parts/systick.h"

#define NANOSECONDS 1000000000u /* in a second */

uint64_t clock_instructions(void)
{
    const uint64_t ticks = systick_ticks(); /* < 2^50 for years */

    if (NANOSECONDS % BOARD_SYSTICK_HZ == 0) {
        return ticks * (NANOSECONDS / BOARD_SYSTICK_HZ);
    }
    /* Whole seconds and the rest, < 2^30 * 2^30: exact, and rounded down once. */
    return ticks / BOARD_SYSTICK_HZ * NANOSECONDS +
           ticks % BOARD_SYSTICK_HZ * NANOSECONDS / BOARD_SYSTICK_HZ;
}
