/* SPDX-License-Identifier: MIT */
#include "driver.h"

/* The glass is mounted with its first row at the bottom, and its first column at the right. */
const fxl_display_driver fxl_st7735 = {&fxl_display_colour,      NULL, 0,    132, 162, 128, 160, 0,
                                       {0xC0, 0xA0, 0x00, 0x60}, true, false};
