/* SPDX-License-Identifier: MIT */
/* Fails in the way that it is told by its first argument, to show what is seen
 * of it from outside; and reads the clock, which is easy to get wrong. For
 * Armv7-M boards. */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "contract/system.h"
#include "parts/cortexm.h"
#include "parts/semihosting.h"
#include "parts/systick.h"

#define UNMAPPED    0x70000000u
#define LONG_FRAME  262144u /* more than any stack */
#define AIRCR_RESET 0x05FA0004u

static volatile uint32_t sink;

static uint32_t overflow_slowly(uint32_t depth)
{
    volatile uint32_t local[16];

    local[depth & 15u] = depth;
    sink = local[(depth + 1u) & 15u];
    return depth == UINT32_MAX ? 0 : overflow_slowly(depth + 1u) + local[depth & 15u];
}

/* Leaps over the guard. */
static void overflow_at_once(void)
{
    volatile uint8_t local[LONG_FRAME];

    local[0] = 1;
    sink = local[0];
}

static void stack(void)
{
    sink = overflow_slowly(0);
}

static void divide(void)
{
    volatile uint32_t zero = 0;

    sink = 100u / zero;
}

static void unaligned(void)
{
    static uint32_t words[2];
    uint32_t value;

    __asm__ volatile("ldr %0, [%1]" : "=r"(value) : "r"((uintptr_t)words + 1u));
    sink = value;
}

static void flash_write(void)
{
    *(volatile uint32_t *)(uintptr_t)(fxl_scene_base + 64) = 1;
}

static void null_read(void)
{
    volatile uintptr_t address = 4;

    sink = *(volatile uint32_t *)address;
}

static void unmapped(void)
{
    sink = *(volatile uint32_t *)UNMAPPED;
}

static void undefined(void)
{
    __asm__ volatile("udf #1");
}

static void interrupt(void)
{
    __asm__ volatile("svc #0");
}

/* A fault within a fault: the handlers' stack points nowhere. */
static void lockup(void)
{
    __asm__ volatile("msr msp, %0\n\tudf #2" ::"r"(UNMAPPED));
}

static void hang(void)
{
    for (;;) {
    }
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

/* Two instructions a turn. */
static __attribute__((naked, noinline)) void spin(uint32_t turns)
{
    __asm__ volatile("1: subs r0, r0, #1\n\tbne 1b\n\tbx lr");
    (void)turns;
}

/* Prints the ticks for the same work with a period that is hardly wrapped and
 * with short ones that wrap all the time, and how often the clock went back. */
static void clock_check(void)
{
    static const uint32_t reloads[] = {SYSTICK_RELOAD_MAX, 999, 99, 19};
    size_t i;

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
        semihosting_text("clock: reload ");
        semihosting_decimal(reloads[i]);
        semihosting_text(" ticks ");
        semihosting_decimal((uint32_t)now);
        semihosting_text(" backward ");
        semihosting_decimal(backward);
        semihosting_text("\n");
    }
    semihosting_exit(SYSTEM_EXIT_DONE);
}

/* The same across a wrap of the whole counter, 2^24 ticks. */
static void clock_long(void)
{
    uint64_t before, ticks;

    systick_start(SYSTICK_RELOAD_MAX);
    before = systick_ticks();
    spin(400000000); /* 800 million instructions; a wrap takes 671 million */
    ticks = systick_ticks() - before;
    semihosting_text("clock: ticks ");
    semihosting_decimal((uint32_t)ticks);
    semihosting_text("\n");
    semihosting_exit(SYSTEM_EXIT_DONE);
}

static const struct {
    const char *name;
    void (*run)(void);
} cases[] = {
    {"stack", stack},         {"leap", overflow_at_once},
    {"divide", divide},       {"unaligned", unaligned},
    {"flash", flash_write},   {"null", null_read},
    {"unmapped", unmapped},   {"undefined", undefined},
    {"interrupt", interrupt}, {"lockup", lockup},
    {"hang", hang},           {"chatter", chatter},
    {"reset", reset},         {"mute", mute},
    {"liar", liar},           {"no-dump", no_dump},
    {"clock", clock_check},   {"clock-long", clock_long},
};

/* Whether the last of the blank-separated words is name. */
static bool ends_with(const char *words, const char *name)
{
    const char *last = words;
    const char *at;

    for (at = words; *at != '\0'; at++) {
        if (*at == ' ') {
            last = at + 1;
        }
    }
    while (*last != '\0' && *last == *name) {
        last++;
        name++;
    }
    return *last == *name;
}

int main(int argc, char **argv)
{
    char words[128];
    size_t i;

    (void)argc;
    (void)argv;
    if (semihosting_arguments(words, sizeof words) != NULL) {
        for (i = 0; i < sizeof cases / sizeof cases[0]; i++) {
            if (ends_with(words, cases[i].name)) {
                cases[i].run();
                semihosting_text("nothing happened\n");
                return SYSTEM_EXIT_TEST;
            }
        }
    }
    semihosting_text("no such case\n");
    return SYSTEM_EXIT_ARGUMENT;
}
