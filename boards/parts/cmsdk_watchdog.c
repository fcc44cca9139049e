/* SPDX-License-Identifier: MIT */
/* watchdog.h with the watchdog of Arm's Cortex-M System Design Kit, which the Stellaris chips
 * have, too. board.mk sets CMSDK_WATCHDOG_BASE, its address, and CMSDK_WATCHDOG_HZ, its clock.
 * If it does not interrupt through the NMI, board.mk also sets CMSDK_WATCHDOG_INTERRUPT, the
 * number of its interrupt.
 *
 * If it is not fed, it interrupts; after the same time again it resets the board. So the program
 * does not go on even if the interrupt could not be taken. */
#include "parts/watchdog.h"

#include "parts/cortexm.h"
#include "parts/cortexm_fault.h"

#define WATCHDOG(offset) CORTEXM_REGISTER(CMSDK_WATCHDOG_BASE + (offset))
#define LOAD             WATCHDOG(0x000u)
#define CONTROL          WATCHDOG(0x008u)
#define CLEAR            WATCHDOG(0x00Cu) /* a write reloads the counter */
#define MASKED_STATUS    WATCHDOG(0x014u)
#define LOCK             WATCHDOG(0xC00u)
#define LOCK_OPEN        0x1ACCE551u

#define CONTROL_INTERRUPT 1u
#define CONTROL_RESET     2u

#ifdef CMSDK_WATCHDOG_INTERRUPT
#define BARK (16u + CMSDK_WATCHDOG_INTERRUPT)
#else
#define BARK EXCEPTION_NMI
#endif

/* So many or a little more; UINT32_MAX where there are more. In words alone: a board may have no room for a long division. */
static uint32_t ticks_of(uint32_t milliseconds)
{
    const uint32_t seconds = milliseconds / 1000u, rest = milliseconds % 1000u;

    if (seconds >= UINT32_MAX / CMSDK_WATCHDOG_HZ) {
        return UINT32_MAX;
    }
    return seconds * CMSDK_WATCHDOG_HZ + rest * (CMSDK_WATCHDOG_HZ / 1000u) +
           (rest * (CMSDK_WATCHDOG_HZ % 1000u) + 999u) / 1000u;
}

void watchdog_start(uint32_t milliseconds)
{
    LOCK = LOCK_OPEN;
    LOAD = ticks_of(milliseconds);
    CLEAR = 1;
#ifdef CMSDK_WATCHDOG_INTERRUPT
    NVIC_ISER = 1u << CMSDK_WATCHDOG_INTERRUPT;
#endif
    CONTROL = CONTROL_INTERRUPT | CONTROL_RESET;
}

void watchdog_feed(void)
{
    CLEAR = 1;
}

bool watchdog_barked(uint32_t exception)
{
    return exception == BARK && (MASKED_STATUS & 1u) != 0;
}
