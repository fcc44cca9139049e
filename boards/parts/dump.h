/* SPDX-License-Identifier: MIT */
/* The frame dump of docs/formats.md, section 2, as a panel, and its sink. It takes frames of every
 * size. */
#ifndef BOARD_DUMP_H
#define BOARD_DUMP_H

#include <stdbool.h>
#include <stddef.h>

#include "contract/panel.h"

extern const panel dump_panel;

/* A frame of boxes: what differs from the frame before. The number that the panel's begin is given has
 * this bit too. dump_box comes before the rows of each box, and once more with a box of 0 columns
 * before the panel's end. It returns false where the sink did not take everything. */
#define DUMP_BOXES 0x80000000u
bool dump_box(const fxl_screen_box *box);

/* The destination of the dump, byte by byte: what parts/dump.c needs from a board. Each returns
 * false where the host did not take everything. Each is called between a sink_open that returned
 * true and sink_close. */
bool sink_open(void);
bool sink_write(const void *bytes, size_t size);

/* Closes the sink. whole: every byte of the dump was taken. Otherwise the sink must not leave
 * anything that looks like a complete dump. */
bool sink_close(bool whole);

#endif
