/* SPDX-License-Identifier: MIT */
/* The counts of the clock for work whose instructions are known. */
#include <stddef.h>
#include <stdint.h>

#include "cases.h"
#include "contract/clock.h"
#include "contract/system.h"
#include "parts/semihosting.h"
#include "parts/systick.h"

/* Two instructions a turn. */
static __attribute__((naked, noinline)) void spin(uint32_t turns)
{
    __asm__ volatile("1: subs r0, #1\n\tbne 1b\n\tbx lr");
    (void)turns;
}

static void print(const char *label, uint32_t number)
{
    semihosting_text(label);
    semihosting_decimal(number);
}

/* Prints the ticks for the same work with a period that is hardly wrapped and
 * with short ones that wrap all the time, and how often the clock went back. */
static void wraps(void)
{
    static const uint32_t reloads[] = {SYSTICK_RELOAD_MAX, 999, 99, 39};
    size_t i;

    print("clock: hz ", BOARD_SYSTICK_HZ);
    semihosting_text("\n");
    for (i = 0; i < sizeof reloads / sizeof reloads[0]; i++) {
        uint64_t before, now, last;
        uint32_t reading, backward = 0;

        systick_start(reloads[i]);
        before = systick_ticks();
        spin(1000000);
        now = systick_ticks() - before;
        last = systick_ticks();
        for (reading = 0; reading < 20000; reading++) {
            const uint64_t next = systick_ticks();

            backward += next < last;
            last = next;
        }
        print("clock: reload ", reloads[i]);
        print(" ticks ", (uint32_t)now);
        print(" backward ", backward);
        semihosting_text("\n");
    }
    semihosting_exit(SYSTEM_EXIT_DONE);
}

/* The count of clock.h for N instructions, for several N. */
static void instructions(void)
{
    static const uint32_t turns[] = {1, 100, 12345, 1000000, 50000000};
    size_t i;

    print("clock: hz ", BOARD_SYSTICK_HZ);
    semihosting_text("\n");
    for (i = 0; i < sizeof turns / sizeof turns[0]; i++) {
        const uint64_t before = clock_instructions();
        uint64_t none, some;

        none = clock_instructions();
        spin(turns[i]);
        some = clock_instructions();
        print("clock: spun ", 2u * turns[i]);
        print(" counted ", (uint32_t)(some - none));
        print(" reading ", (uint32_t)(none - before));
        semihosting_text("\n");
    }
    semihosting_exit(SYSTEM_EXIT_DONE);
}

/* The same across a wrap of the whole counter, 2^24 ticks: 671 million
 * instructions at 25 MHz. */
static void wrap_of_all(void)
{
    uint64_t before, spent;

    systick_start(SYSTICK_RELOAD_MAX);
    before = clock_instructions();
    spin(400000000);
    spent = clock_instructions() - before;
    print("clock: ticks ", (uint32_t)systick_ticks());
    print(" instructions ", (uint32_t)spent);
    semihosting_text("\n");
    semihosting_exit(SYSTEM_EXIT_DONE);
}

const fault_case clock_cases[] = {
    {"clock", wraps},
    {"clock-instructions", instructions},
    {"clock-long", wrap_of_all},
    {NULL, NULL},
};
