/* SPDX-License-Identifier: MIT */
/* Arm MPS2 with image AN385, under QEMU with -icount shift=0, where one
 * instruction takes one nanosecond. */
#include <stddef.h>

#include "contract/clock.h"
#include "contract/input.h"
#include "contract/panel.h"
#include "parts/armv7m.h"
#include "parts/dump.h"
#include "parts/systick.h"
#include "parts/window.h"

#define INSTRUCTIONS_PER_TICK 40u /* SysTick runs at 25 MHz */
#define TICKS_PER_MILLISECOND 25000u

void board_start(void)
{
    systick_start(SYSTICK_RELOAD_MAX);
}

/* In steps of 40. The clock's own interrupt, about ten instructions in 671
 * million, is counted too. */
uint64_t clock_instructions(void)
{
    return systick_ticks() * INSTRUCTIONS_PER_TICK;
}

uint32_t input_keys(void)
{
    return window_keys(); /* it has none of its own */
}

void window_nap(void)
{
    systick_nap(TICKS_PER_MILLISECOND);
}

const panel *const *board_panels(void)
{
    static const panel *const panels[] = {&dump_panel, NULL};
    static const panel *const watched[] = {&window_panel, NULL};

    return window_invited() ? watched : panels;
}
