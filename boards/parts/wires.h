/* SPDX-License-Identifier: MIT */
/* The wires of the display to which driver_panel.c sends: real ones (BOARD_WIRES of board.mk), or a
 * record of them, from which the tools make the picture again. */
#ifndef BOARD_WIRES_H
#define BOARD_WIRES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fixel/display.h"

/* Sets the wires up. Returns false where they cannot be had; then nothing else is called. */
bool wires_open(void);

/* What a driver sends by. Used between wires_open and wires_close. */
extern const fxl_display_port wires_port;

/* Notes that a frame is over, and its number; the last transfer has been waited for. Returns false
 * if that, or a pause before it, could not be noted. */
bool wires_end_frame(uint32_t number);

/* Returns false if not everything was sent. */
bool wires_close(void);

/* The file of the record (docs/formats.md, section 5), where parts/recorded_wires.c writes: what
 * that needs from a board. Each function returns false where the host did not take everything. Each
 * is called between a record_open that returned true and record_close. */
#define RECORD_NAME "wires.bin" /* in the directory in which board or emulator were started */

bool record_open(void);
bool record_write(const void *bytes, size_t size);
bool record_close(void);

#endif
