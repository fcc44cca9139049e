/* SPDX-License-Identifier: MIT */
/* Board contract: what is told about each frame, beside its pixels. A board
 * that nobody listens to may ignore it and answer true. */
#ifndef BOARD_JOURNAL_H
#define BOARD_JOURNAL_H

#include <stdbool.h>
#include <stdint.h>

#include "fixel/types.h"

/* Announces how many frames will follow; before display_open.
 * Requires frames >= 1. */
bool journal_open(uint32_t frames);

/* Begins frame number, counted from 0, before its first pixel: where the eye
 * was. False where it could not be noted. */
bool journal_begin(uint32_t number, const fxl_pose *pose);

/* Ends the frame after its last pixel: what became of its polygons, in how
 * many steps of the walk so far a coordinate was held at the range's end, and
 * how many instructions drawing took (0: the board cannot tell).
 * False where it could not be noted, or where pixels of the frame are missing. */
bool journal_end(const fxl_counters *counters, uint32_t clamped, uint64_t instructions);

#endif
