/* SPDX-License-Identifier: MIT */
/* An OLED of 128 x 64 pixels and 16 greys with an SSD0323 controller, as a
 * panel. Frames of any other size are not for it. */
#ifndef BOARD_SSD0323_H
#define BOARD_SSD0323_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "contract/panel.h"

#define SSD0323_WIDTH  128u
#define SSD0323_HEIGHT 64u
#define SSD0323_LEVELS 16u

extern const panel ssd0323_panel;

/* The wires to the controller, which each board with one has. */
typedef enum {
    SSD0323_COMMAND, /* D/C low */
    SSD0323_DATA     /* D/C high */
} ssd0323_kind;

/* Turns on what the wires need: clocks, pins, the serial port; then the
 * display's own supply. False where that failed. */
bool ssd0323_wires_open(void);

/* Sends size bytes, and returns when the controller has them all.
 * False where they could not be sent. */
bool ssd0323_send(ssd0323_kind kind, const uint8_t *bytes, size_t size);

#endif
