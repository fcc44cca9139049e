/* SPDX-License-Identifier: MIT */
/* The frame dump of docs/formats.md, section 2, as a panel. It takes frames of every size. The
 * board must have a parts/sink.h. */
#ifndef BOARD_DUMP_H
#define BOARD_DUMP_H

#include "contract/panel.h"

extern const panel dump_panel;

#endif
