/* SPDX-License-Identifier: MIT */
/* SysTick; clock.h with it; and watchdog.h with it, for a board whose own watchdog is not emulated.
 */
#include "parts/systick.h"

#include "contract/clock.h"
#include "parts/cortexm.h"
#include "parts/watchdog.h"

#define CSR_ENABLE     1u
#define CSR_INTERRUPT  2u
#define CSR_CORE_CLOCK 4u
#define ICSR_PENDSTSET (1u << 26)
#define ICSR_PENDSTCLR (1u << 25)

static volatile uint64_t wraps; /* of this period; written by the interrupt only */
static uint64_t before;         /* ticks of other periods */
static uint32_t period;
static volatile uint32_t alarm; /* wraps to go; 0: none */
static volatile bool is_alarmed;

static void count_from(uint64_t ticks, uint32_t reload)
{
    SYST_CSR = 0;
    SCB_ICSR = ICSR_PENDSTCLR; /* a wrap that has not been counted yet is in ticks */
    before = ticks;
    wraps = 0;
    period = reload + 1u;
    SYST_RVR = reload;
    SYST_CVR = 0; /* any write clears; the first tick then loads reload */
    SYST_CSR = CSR_ENABLE | CSR_INTERRUPT | CSR_CORE_CLOCK;
}

void systick_start(uint32_t reload)
{
    alarm = 0;
    count_from(0, reload);
}

void systick_nap(uint32_t ticks)
{
    const uint32_t reload = period - 1u, left = alarm;

    alarm = 0; /* it counts wraps of the long period */
    count_from(systick_ticks(), ticks - 1u);
    __asm__ volatile("wfi" ::: "memory");
    count_from(systick_ticks(), reload);
    alarm = left;
}

/* Counts a wrap. Returns whether it sets off the alarm. */
static __attribute__((used)) bool count_wrap(void)
{
    const uint32_t left = alarm;

    wraps++;
    if (left == 0) {
        return false;
    }
    alarm = left - 1u;
    is_alarmed = left == 1;
    return left == 1;
}

/* The fault report needs sp and lr as the core left them. */
__attribute__((naked)) void cortexm_systick(void)
{
    __asm__ volatile("push {r4, lr}\n\t"
                     "bl count_wrap\n\t"
                     "pop {r2, r3}\n\t"
                     "mov lr, r3\n\t"
                     "mov r4, r2\n\t"
                     "cmp r0, #0\n\t"
                     "bne 1f\n\t"
                     "bx lr\n\t"
                     "1: ldr r3, =cortexm_fault\n\t"
                     "bx r3\n\t"
                     ".ltorg");
}

void systick_alarm(uint32_t count)
{
    alarm = count;
}

bool systick_alarmed(void)
{
    return is_alarmed;
}

uint32_t systick_period(void)
{
    return period;
}

/* Not inline: clock_instructions is small where nothing needs it to be fast. */
__attribute__((noinline)) uint64_t systick_ticks(void)
{
    uint32_t masked, value;
    uint64_t whole;

    __asm__ volatile("mrs %0, primask\n\tcpsid i" : "=r"(masked)::"memory");
    value = SYST_CVR;
    whole = wraps;
    if ((SCB_ICSR & ICSR_PENDSTSET) != 0) {
        /* The counter wrapped before or just after value was read, and the wrap has not been
         * counted yet. A value that is read now is certainly after the wrap. */
        value = SYST_CVR;
        whole++;
    }
    __asm__ volatile("msr primask, %0" ::"r"(masked) : "memory");
    /* The interrupt comes as the counter reaches 0, one tick before it
     * reloads: at 0 the new period has begun. */
    return before + whole * period + (value == 0 ? 0 : period - value);
}

/* --- clock.h: QEMU with -icount shift=0, where one instruction takes one nanosecond ----------- */

#define NANOSECONDS 1000000000u /* in a second */

/* By a divisor below 2^16, digit by digit of 16 bits: a board may have no room for a long division. */
static inline uint64_t divided(uint64_t value, uint32_t divisor)
{
    uint64_t quotient = 0;
    uint32_t rest = 0, shift;

    for (shift = 64; shift > 0; shift -= 16u) {
        rest = rest << 16 | ((uint32_t)(value >> (shift - 16u)) & 0xFFFFu);
        quotient = quotient << 16 | rest / divisor;
        rest %= divisor;
    }
    return quotient;
}

/* BOARD_SYSTICK_HZ, of board.mk, is its clock. board_start has called systick_start. The resolution
 * is a tick. The clock's own interrupt, about twenty instructions in 2^24 ticks, is counted, too.
 */
uint64_t clock_instructions(void)
{
    const uint64_t ticks = systick_ticks(); /* < 2^50 for years */

    if (NANOSECONDS % BOARD_SYSTICK_HZ == 0) {
        return ticks * (NANOSECONDS / BOARD_SYSTICK_HZ);
    }
    if (BOARD_SYSTICK_HZ % 1000000u == 0) {
        return divided(ticks * 1000u, BOARD_SYSTICK_HZ / 1000000u); /* < 2^60 */
    }
    /* Whole seconds and the rest, < 2^30 * 2^30: exact, and rounded down once. */
    return ticks / BOARD_SYSTICK_HZ * NANOSECONDS +
           ticks % BOARD_SYSTICK_HZ * NANOSECONDS / BOARD_SYSTICK_HZ;
}

/* --- watchdog.h, where no other part has it --------------------------------------------------- */

#define SYSTICK_EXCEPTION 15u

/* The wraps count the time. A hang with interrupts masked is not detected. */
static uint32_t patience; /* wraps that the program may take without a sign of life */

__attribute__((weak)) void watchdog_start(uint32_t milliseconds)
{
    const uint32_t span = systick_period() / (BOARD_SYSTICK_HZ / 1000u); /* whole milliseconds of a wrap */

    /* The current period may end at once. */
    patience = milliseconds / (span > 0 ? span : 1u) + 2u;
    systick_alarm(patience);
}

__attribute__((weak)) void watchdog_feed(void)
{
    systick_alarm(patience);
}

__attribute__((weak)) bool watchdog_barked(uint32_t exception)
{
    return exception == SYSTICK_EXCEPTION && systick_alarmed();
}
