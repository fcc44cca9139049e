/* SPDX-License-Identifier: MIT */
/* The destination of a frame dump, byte by byte: the functions that parts/dump.c needs from a
 * board. Each returns false where the host did not take everything. Each is called between a
 * sink_open that returned true and sink_close. */
#ifndef BOARD_SINK_H
#define BOARD_SINK_H

#include <stdbool.h>
#include <stddef.h>

bool sink_open(void);
bool sink_write(const void *bytes, size_t size);

/* Closes the sink. whole: every byte of the dump was taken. Otherwise the sink must not leave
 * anything that looks like a complete dump. */
bool sink_close(bool whole);

#endif
