/* SPDX-License-Identifier: MIT */
/* The destination of what a display's driver sends, where no real display hangs on the board: a
 * record of the wires (docs/formats.md, section 5), from which the tools make the picture again.
 * Each function returns false where the host did not take everything. Each is called between a
 * record_open that returned true and record_close. */
#ifndef BOARD_WIRES_H
#define BOARD_WIRES_H

#include <stdbool.h>
#include <stddef.h>

#define WIRES_NAME "wires.bin" /* in the directory in which board or emulator were started */

bool record_open(void);
bool record_write(const void *bytes, size_t size);
bool record_close(void);

#endif
