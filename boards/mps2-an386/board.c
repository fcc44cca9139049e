/* SPDX-License-Identifier: MIT */
/* Arm MPS2 with image AN386, under QEMU. */
#include "parts/cortexm.h"
#include "parts/systick.h"

void board_start(void)
{
    systick_start(SYSTICK_RELOAD_MAX);
}
