/* SPDX-License-Identifier: MIT */
/* Arm MPS3 with image AN547, under QEMU. */
#include "parts/cortexm.h"
#include "parts/systick.h"

void board_start(void)
{
    systick_start(SYSTICK_RELOAD_MAX);
}
