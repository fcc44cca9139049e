/* SPDX-License-Identifier: MIT */
/* Arm MPS2 with image AN500, under QEMU. */
#include <stddef.h>

#include "contract/input.h"
#include "contract/panel.h"
#include "parts/cortexm.h"
#include "parts/dump.h"
#include "parts/systick.h"

void board_start(void)
{
    systick_start(SYSTICK_RELOAD_MAX);
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
