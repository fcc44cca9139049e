/* SPDX-License-Identifier: MIT */
/* watchdog.h for a board whose own watchdog is not emulated: the wraps of SysTick count the
 * time, so systick_start must be called first. It does not detect a hang with interrupts masked. */
#include "parts/systick.h"
#include "parts/watchdog.h"

#define SYSTICK_EXCEPTION 15u

static uint32_t wraps; /* wraps that the program may take without a sign of life */

void watchdog_start(uint32_t milliseconds)
{
    const uint64_t ticks = (uint64_t)milliseconds * (BOARD_SYSTICK_HZ / 1000u); /* < 2^44 */

    /* The current period may end at once. */
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
