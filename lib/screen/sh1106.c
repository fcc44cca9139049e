/* SPDX-License-Identifier: MIT */
#include "driver.h"

static const uint8_t commands[] = {
    0xAD, 0x8B, /* its own voltage converter on */
    0xD9, 0x22, /* lengths of precharge and discharge: as after reset */
    0xDB, 0x35, /* voltage of a row at rest: as after reset */
};

/* It has 132 columns, and the glass is joined to the middle 128. */
const fxl_display_driver fxl_sh1106 = {&fxl_display_pages,
                                       commands,
                                       sizeof commands,
                                       132,
                                       64,
                                       128,
                                       64,
                                       2,
                                       {0x09, 0x00, 0x00, 0x00},
                                       false,
                                       false};
