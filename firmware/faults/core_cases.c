/* SPDX-License-Identifier: MIT */
/* Faults that the core, or the memory protection, must catch. */
#include <stddef.h>
#include <stdint.h>

#include "cases.h"
#include "contract/system.h"
#include "parts/cortexm.h"
#include "parts/semihosting.h"

#define NOWHERE    0xE8000000u /* an address where no board has anything */
#define LONG_FRAME 262144u     /* more than any stack */

static volatile uint32_t sink;

static __attribute__((noinline)) uint32_t overflow_slowly(uint32_t depth)
{
    volatile uint32_t local[16];

    local[depth & 15u] = depth;
    sink = local[(depth + 1u) & 15u];
    return depth == UINT32_MAX ? 0 : overflow_slowly(depth + 1u) + local[depth & 15u];
}

static void stack(void)
{
    sink = overflow_slowly(0);
}

/* Farther below the stack than any guard is long. */
static void leap(void)
{
    volatile uint8_t local[LONG_FRAME];

    local[0] = 1;
    sink = local[0];
}

/* Uses the stack to its last byte and returns: no memory protection sees that. */
static void brim(void)
{
    uint32_t *word;

    if (cortexm_protected()) {
        cannot_show("the stack's end is guarded");
    }
    for (word = fxl_stack_limit; word < fxl_stack_limit + 4; word++) {
        *word = 0;
    }
    system_alive();
}

static void divide(void)
{
    volatile uint32_t zero = 0;

    sink = 100u / zero;
}

/* In the compiler's run-time, on every core. */
static void divide_long(void)
{
    volatile uint64_t zero = 0;

    sink = (uint32_t)(UINT64_MAX / zero);
}

static void divide_long_signed(void)
{
    volatile int64_t zero = 0;

    sink = (uint32_t)(INT64_MIN / zero);
}

static void flash_write(void)
{
    volatile uintptr_t address = (uintptr_t)fxl_scene_base + 64u;
    volatile uint32_t *const word = (volatile uint32_t *)address;
    const uint32_t before = *word;

    *word = ~before;
    if (!cortexm_protected() && *word == before) {
        cannot_show("no memory protection, and its flash ignores writes");
    }
}

static void null_read(void)
{
    volatile uintptr_t address = 4;

    sink = *(volatile uint32_t *)address;
    if (!cortexm_protected()) {
        cannot_show("no memory protection, and address 0 is memory");
    }
}

static void null_call(void)
{
    void (*volatile nothing)(void) = NULL;

    nothing();
}

static void unmapped(void)
{
    sink = *(volatile uint32_t *)NOWHERE;
    if (sink == 0) {
        cannot_show("it answers 0 where it has nothing");
    }
}

static void jump(void)
{
    void (*const nowhere)(void) = (void (*)(void))(NOWHERE + 1u);

    nowhere();
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
    __asm__ volatile("msr msp, %0\n\tudf #2" ::"r"(NOWHERE));
}

const fault_case core_cases[] = {
    {"stack", stack},
    {"leap", leap},
    {"brim", brim},
    {"divide", divide},
    {"divide-long", divide_long},
    {"divide-long-signed", divide_long_signed},
    {"flash", flash_write},
    {"null", null_read},
    {"null-call", null_call},
    {"unmapped", unmapped},
    {"jump", jump},
    {"undefined", undefined},
    {"interrupt", interrupt},
    {"lockup", lockup},
    {NULL, NULL},
};
