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

#define INSTRUCTIONS_PER_TICK 40u /* SysTick runs at 25 MHz */

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
    return 0; /* it has no keys */
}

const panel *const *board_panels(void)
{
    static const panel *const panels[] = {&dump_panel, NULL};

    return panels;
}
