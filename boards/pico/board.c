/* SPDX-License-Identifier: MIT */
/* Raspberry Pi Pico. An alarm of its timer is the watchdog. clock_instructions counts the
 * emulator's cycles. */
#include <stddef.h>

#include "contract/clock.h"
#include "contract/system.h"
#include "parts/cortexm.h"
#include "parts/semihosting.h"
#include "parts/watchdog.h"
#include "pico/rp2040.h"

#define ALARM0    RP2040_REGISTER(RP2040_TIMER + 0x10u)
#define ALARM_ON  RP2040_REGISTER(RP2040_TIMER + 0x38u)
#define EXCEPTION 16u /* of interrupt 0, TIMER_IRQ_0 */

static uint32_t limit; /* microseconds without a sign of life */

void board_start(void)
{
    if (!rp2040_start()) {
        system_text("pico: the crystal, the PLL or the timer does not start\n");
        system_exit(SYSTEM_EXIT_BOARD);
    }
}

void watchdog_start(uint32_t milliseconds)
{
    limit = milliseconds * 1000u; /* <= 60,000,000 */
    watchdog_feed();
    ALARM_ON = 1u;
    NVIC_ISER = 1u;
}

void watchdog_feed(void)
{
    ALARM0 = rp2040_microseconds() + limit;
}

bool watchdog_barked(uint32_t exception)
{
    return exception == EXCEPTION;
}

/* Its interrupt is never turned on. A call would change LR, by which a handler finds what the core
 * pushed. */
__attribute__((naked)) void cortexm_systick(void)
{
    __asm__ volatile("ldr r0, =cortexm_fault\n\tbx r0\n\t.ltorg");
}

/* What the emulator says that it counted: cycles, by counts= of board.mk. */
uint64_t clock_instructions(void)
{
    return semihosting_elapsed();
}
