/* SPDX-License-Identifier: MIT */
/* Arm MPS2 with image AN385, under QEMU; a small OLED on the shield's I2C where
 * QEMU was told to have one (-device ssd0303,address=0x3d). */
#include <stddef.h>

#include "parts/cortexm.h"
#include "parts/dump.h"
#include "parts/sbcon.h"
#include "parts/ssd0303.h"
#include "parts/systick.h"
#include "parts/window.h"

#define SHIELD_I2C   0x4002A000u
#define OLED_ADDRESS 0x3Du

void board_start(void)
{
    systick_start(SYSTICK_RELOAD_MAX);
}

bool ssd0303_send(const uint8_t *bytes, size_t size)
{
    return sbcon_send(SHIELD_I2C, OLED_ADDRESS, bytes, size);
}

const panel *const *board_panels(void)
{
    static const panel *const alone[] = {&dump_panel, &ssd0303_panel, NULL};
    static const panel *const watched[] = {&window_panel, &ssd0303_panel, NULL};

    return window_invited() ? watched : alone;
}
