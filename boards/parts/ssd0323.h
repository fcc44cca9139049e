/* SPDX-License-Identifier: MIT */
/* An OLED of 128 x 64 pixels and 16 greys with an SSD0323 controller, as a panel. It is
 * unsuitable for frames of any other size. */
#ifndef BOARD_SSD0323_H
#define BOARD_SSD0323_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "contract/panel.h"

#define SSD0323_WIDTH  128u
#define SSD0323_HEIGHT 64u

extern const panel ssd0323_panel;

/* The connection to the controller, which each board with one implements. */
typedef enum {
    SSD0323_COMMAND, /* D/C low */
    SSD0323_DATA     /* D/C high */
} ssd0323_kind;

/* Turns on what the connection needs: clocks, pins, the serial port; then the display's own
 * supply. Returns false where that failed. */
bool ssd0323_wires_open(void);

/* Sends size bytes, and returns when the controller has them all. Returns false where they could
 * not be sent. */
bool ssd0323_send(ssd0323_kind kind, const uint8_t *bytes, size_t size);

#endif
