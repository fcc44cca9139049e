/* SPDX-License-Identifier: MIT */
/* Where a frame dump goes, byte by byte: what parts/dump.c asks of a board.
 * Each answers false where the host did not take everything, and is called
 * between a sink_open that answered true and sink_close. */
#ifndef BOARD_SINK_H
#define BOARD_SINK_H

#include <stdbool.h>
#include <stddef.h>

bool sink_open(void);
bool sink_write(const void *bytes, size_t size);

/* Ends it. whole: every byte of the dump was taken; otherwise what came is not
 * to be mistaken for a dump. */
bool sink_close(bool whole);

#endif
