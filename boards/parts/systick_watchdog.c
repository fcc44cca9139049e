/* SPDX-License-Identifier: MIT */
/* watchdog.h for a board whose own watchdog is not emulated: SysTick's wraps
 * count the time; systick_start comes first. It sees no hang with interrupts masked. */
#include "parts/systick.h"
#include "parts/watchdog.h"

#define SYSTICK_EXCEPTION 15u

static uint32_t wraps; /* that the program may go without a sign of life */

void watchdog_start(uint32_t milliseconds)
{
    const uint64_t ticks = (uint64_t)milliseconds * (BOARD_SYSTICK_HZ / 1000u); /* < 2^44 */

    /* The wrap under way may end at once. */
    wraps = (uint32_t)(ticks / systick_period()) + 2u;
    systick_alarm(wraps);
}

void watchdog_feed(void)
{
    systick_alarm(wraps);
}

bool watchdog_barked(uint32_t exception)
{
    return exception == SYSTICK_EXCEPTION && systick_alarmed();
}
