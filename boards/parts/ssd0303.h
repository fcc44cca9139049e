/* SPDX-License-Identifier: MIT */
/* An OLED of 96 x 16 pixels, each dark or light, with an SSD0303 controller, as a panel. It
 * shows the middle of the frame, because nothing would be recognisable if the frame were shrunk
 * to 16 rows. The panel is unsuitable for a frame that is smaller than it, and where the display
 * does not acknowledge. */
#ifndef BOARD_SSD0303_H
#define BOARD_SSD0303_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "contract/panel.h"

#define SSD0303_WIDTH  96u
#define SSD0303_HEIGHT 16u

extern const panel ssd0303_panel;

/* The connection to the controller, which each board with one implements: sends one I2C message
 * to it. Returns false where the controller does not acknowledge. */
bool ssd0303_send(const uint8_t *bytes, size_t size);

#endif
