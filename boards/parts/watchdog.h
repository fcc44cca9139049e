/* SPDX-License-Identifier: MIT */
/* The board's watchdog. If it is not fed, its interrupt ends in cortexm_fault, which reports
 * SYSTEM_EXIT_HANG. */
#ifndef BOARD_WATCHDOG_H
#define BOARD_WATCHDOG_H

#include <stdbool.h>
#include <stdint.h>

/* How long the program may go without a sign of life. Time of the emulator:
 * under -icount shift=0 a thousand million instructions a second. */
#ifndef BOARD_WATCHDOG_MILLISECONDS
#define BOARD_WATCHDOG_MILLISECONDS 2000u
#endif

/* Starts the watchdog, or starts it anew. It interrupts unless it is fed within the time, which
 * is at least 1 and at most 60,000 and is rounded up to what the board can count. */
void watchdog_start(uint32_t milliseconds);

/* Feeds the watchdog: the whole time begins again. Requires watchdog_start. */
void watchdog_feed(void);

/* Tells whether the exception of this number is the watchdog's. */
bool watchdog_barked(uint32_t exception);

#endif
