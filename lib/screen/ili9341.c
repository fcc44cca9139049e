/* SPDX-License-Identifier: MIT */
#include "driver.h"

/* Its glass is blue, green, red (bit 3), and its columns run from right to left. */
const fxl_display_driver fxl_ili9341 = {&fxl_display_colour,      NULL, 0,    240, 320, 240, 320, 0,
                                        {0x48, 0x28, 0x88, 0xE8}, true, false};
