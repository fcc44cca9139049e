/* SPDX-License-Identifier: MIT */
/* Endings that could be taken for a success, and programs that do not end. */
#include <stddef.h>
#include <stdint.h>

#include "cases.h"
#include "contract/system.h"
#include "parts/cortexm.h"
#include "parts/semihosting.h"
#include "parts/systick.h"
#include "parts/watchdog.h"

#define AIRCR_RESET 0x05FA0004u

static __attribute__((noinline)) void hang(void)
{
    for (;;) {
    }
}

/* The same with more work in a turn, which the emulator runs tens of times
 * faster: enough of it for the watchdog's own patience. */
static __attribute__((noinline)) void hang_at_work(void)
{
    for (;;) {
        __asm__ volatile(".rept 200\n\tnop\n\t.endr");
    }
}

static void hang_watched(void)
{
    system_alive();
    hang_at_work();
}

/* A watchdog that bites soon, also where SysTick's wraps are its clock. */
static void watch(uint32_t milliseconds)
{
    systick_start(9999);
    watchdog_start(milliseconds);
}

static void hang_shortly(void)
{
    watch(20);
    hang();
}

/* No interrupt can tell of it but one that cannot be masked. */
static void hang_masked(void)
{
    __asm__ volatile("cpsid i");
    watch(20);
    hang();
}

/* Lives for far longer than the watchdog waits, and feeds it. */
static void alive(void)
{
    uint32_t round;

    watch(1);
    for (round = 0; round < 400; round++) {
        volatile uint32_t turn;

        for (turn = 0; turn < 10000; turn++) {
        }
        watchdog_feed();
    }
    semihosting_text("alive\n");
    system_exit(SYSTEM_EXIT_DONE);
}

static void chatter(void)
{
    for (;;) {
        semihosting_text("and so on, and so on, and so on, and so on, and so on, and so on\n");
    }
}

static void reset(void)
{
    semihosting_text("walk: done 1 frames\n");
    SCB_AIRCR = AIRCR_RESET;
    hang();
}

static void mute(void)
{
    semihosting_exit(SYSTEM_EXIT_DONE);
}

static void liar(void)
{
    semihosting_text("walk: done 1 frames\n");
    semihosting_exit(0);
}

static void no_dump(void)
{
    semihosting_text("walk: done 1 frames\n");
    semihosting_exit(SYSTEM_EXIT_DONE);
}

const fault_case ending_cases[] = {
    {"hang", hang},
    {"hang-watched", hang_watched},
    {"hang-shortly", hang_shortly},
    {"hang-masked", hang_masked},
    {"alive", alive},
    {"chatter", chatter},
    {"reset", reset},
    {"mute", mute},
    {"liar", liar},
    {"no-dump", no_dump},
    {NULL, NULL},
};
