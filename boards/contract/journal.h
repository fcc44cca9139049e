/* SPDX-License-Identifier: MIT */
/* Board contract: the data about each frame beside its pixels. A board without a listener may
 * ignore it and return true. */
#ifndef BOARD_JOURNAL_H
#define BOARD_JOURNAL_H

#include <stdbool.h>
#include <stdint.h>

#include "fixel/types.h"

/* Announces how many frames will follow. Called before display_open.
 * Requires frames >= 1. */
bool journal_open(uint32_t frames);

/* Begins frame `number`, counted from 0, before its first pixel, and notes the pose of the eye.
 * Returns false where that failed. */
bool journal_begin(uint32_t number, const fxl_pose *pose);

/* Ends the frame after its last pixel. Notes the outcome of its polygons, the number of steps so
 * far in which the player's position was clamped to the range, and the number of instructions
 * that drawing took (0: it was not counted). Returns false where that failed, or where
 * pixels of the frame are missing. */
bool journal_end(const fxl_counters *counters, uint32_t clamped, uint64_t instructions);

#endif
