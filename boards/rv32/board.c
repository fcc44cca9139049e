/* SPDX-License-Identifier: MIT */
/* QEMU's virt machine, RISC-V of 32 bits. Its timer, of 10 MHz, is the watchdog. */
#include <stddef.h>

#include "contract/clock.h"
#include "parts/cortexm.h"
#include "parts/riscv.h"
#include "parts/watchdog.h"

/* The core-local interruptor. The comparison is two words, as the time is. */
#define CLINT(offset) (*(volatile uint32_t *)(0x02000000u + (offset)))
#define COMPARE_LOW   CLINT(0x4000u)
#define COMPARE_HIGH  CLINT(0x4004u)
#define TIME_LOW      CLINT(0xBFF8u)
#define TIME_HIGH     CLINT(0xBFFCu)
#define TICKS_A_MS    10000u
#define TIMER_CAUSE   0x80000007u
#define NEVER         0xFFFFFFFFu

static uint64_t limit; /* ticks without a sign of life */

void board_start(void)
{
    COMPARE_HIGH = NEVER;
}

static uint64_t ticks(void)
{
    uint32_t high, low;

    do {
        high = TIME_HIGH;
        low = TIME_LOW;
    } while (high != TIME_HIGH);
    return (uint64_t)high << 32 | low;
}

void watchdog_start(uint32_t milliseconds)
{
    limit = (uint64_t)milliseconds * TICKS_A_MS; /* < 2^46 */
    watchdog_feed();
    riscv_enable_timer();
}

void watchdog_feed(void)
{
    const uint64_t end = ticks() + limit;

    COMPARE_HIGH = NEVER; /* no time in between is past */
    COMPARE_LOW = (uint32_t)end;
    COMPARE_HIGH = (uint32_t)(end >> 32);
}

bool watchdog_barked(uint32_t exception)
{
    return exception == TIMER_CAUSE;
}

/* Counts single instructions: QEMU's -icount shift=0 makes its counter exact. */
uint64_t clock_instructions(void)
{
    return riscv_instructions();
}
