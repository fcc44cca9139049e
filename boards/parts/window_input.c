/* SPDX-License-Identifier: MIT */
/* input.h for a board whose only keys are those of the player at a viewer; and the sleep between
 * the frames, with SysTick. */
#include "contract/input.h"
#include "parts/systick.h"
#include "parts/window.h"

#define NAPS_PER_SECOND 1000u

uint32_t input_keys(void)
{
    return window_keys();
}

void window_nap(void)
{
    systick_nap(BOARD_SYSTICK_HZ / NAPS_PER_SECOND);
}
