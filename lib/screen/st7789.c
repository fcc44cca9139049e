/* SPDX-License-Identifier: MIT */
#include "driver.h"

const fxl_display_driver fxl_st7789 = {&fxl_display_colour,      NULL, 0,   240, 320, 240, 320, 0,
                                       {0x00, 0x60, 0xC0, 0xA0}, true, true};
