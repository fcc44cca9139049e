/* SPDX-License-Identifier: MIT */
#include "driver.h"

static const uint8_t commands[] = {
    0x20, 0x02, /* page addressing */
    0x8D, 0x14, /* its own charge pump on */
    0xD9, 0xF1, /* lengths of precharge and discharge, for the charge pump */
    0xDB, 0x40, /* voltage of a row at rest */
};

const fxl_display_driver fxl_ssd1306 = {&fxl_display_pages,
                                        commands,
                                        sizeof commands,
                                        128,
                                        64,
                                        128,
                                        64,
                                        0,
                                        {0x09, 0x00, 0x00, 0x00},
                                        false,
                                        false};
