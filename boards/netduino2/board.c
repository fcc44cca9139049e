/* SPDX-License-Identifier: MIT */
/* Netduino 2 (STM32F205), under QEMU. */
#include <stddef.h>

#include "contract/panel.h"
#include "parts/cortexm.h"
#include "parts/dump.h"
#include "parts/systick.h"

void board_start(void)
{
    systick_start(SYSTICK_RELOAD_MAX);
}

const panel *const *board_panels(void)
{
    static const panel *const panels[] = {&dump_panel, NULL};

    return panels;
}
