/* SPDX-License-Identifier: MIT */
/* The file in which the tools find what a display's driver sent (docs/formats.md, section 5).
 * Each function returns false where the host did not take everything. Each is called between a
 * record_open that returned true and record_close. */
#ifndef BOARD_RECORD_H
#define BOARD_RECORD_H

#include <stdbool.h>
#include <stddef.h>

#define RECORD_NAME "wires.bin" /* in the directory in which board or emulator were started */

bool record_open(void);
bool record_write(const void *bytes, size_t size);
bool record_close(void);

#endif
