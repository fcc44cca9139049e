/* SPDX-License-Identifier: MIT */
/* Fixel: a fixed-point 3-D renderer for microcontrollers.
 *
 * The laws, which SPEC.md states whole:
 *   - x right, y up, z forward, left-handed; screen y down; pixel centres at .5
 *   - world units 16.16 within +-8191; unit vectors 2.30; angles 2^32 a turn
 *   - coverage by non-zero winding at pixel centres, ties top-left
 *   - objects are drawn by layer, then far to near, then by number
 *   - the caller owns all memory; integers only; no heap; no hidden state
 *   - the same input gives the same frame, bit for bit, on every core
 *   - input outside its range is refused with a status and changes nothing
 * Not promised: that far-to-near order hides what it should (convex objects
 * that are well apart, it does); anything about input that breaks a stated
 * requirement of a function that returns no status.
 */
#ifndef FIXEL_H
#define FIXEL_H

#include "fixel/config.h"
#include "fixel/render.h"
#include "fixel/scene.h"
#include "fixel/types.h"

#endif
