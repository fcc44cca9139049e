/* SPDX-License-Identifier: MIT */
/* The frame dump of docs/formats.md, section 2, as a panel, and its sink. It takes frames of every
 * size. */
#ifndef BOARD_DUMP_H
#define BOARD_DUMP_H

#include <stdbool.h>
#include <stddef.h>

#include "contract/panel.h"

extern const panel dump_panel;

/* The destination of the dump, byte by byte: what parts/dump.c needs from a board. Each returns
 * false where the host did not take everything. Each is called between a sink_open that returned
 * true and sink_close. */
bool sink_open(void);
bool sink_write(const void *bytes, size_t size);

/* Closes the sink. whole: every byte of the dump was taken. Otherwise the sink must not leave
 * anything that looks like a complete dump. */
bool sink_close(bool whole);

#endif
