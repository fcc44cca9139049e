/* SPDX-License-Identifier: MIT */
/* Arm MPS2 with image AN385, under QEMU. */
#include "contract/input.h"
#include "parts/cortexm.h"
#include "parts/systick.h"

void board_start(void)
{
    systick_start(SYSTICK_RELOAD_MAX);
}

uint32_t input_keys(void)
{
    return 0; /* it has no keys */
}
