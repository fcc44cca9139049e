/* SPDX-License-Identifier: MIT */
/* Fixel: a fixed-point 3-D renderer for microcontrollers.
 *
 * The rules. SPEC.md states them in full:
 *   - x right, y up, z forward, left-handed; screen y down; pixel centres at .5
 *   - world units 16.16 within +-8191; unit vectors 2.30; a full turn is 2^32
 *   - a pixel is covered where the winding number at its centre is not zero; ties are top-left
 *   - instances are drawn by layer, then far to near, then by their index in the scene
 *   - the caller owns all memory; integers only; no heap; no hidden state
 *   - the same input gives the same frame, bit for bit, on every core
 *   - a function refuses input outside its range with a status. Its documentation says what it
 *     has changed then: most functions nothing, but for the count of refused calls.
 * Far-to-near order is right only for convex instances that are far enough apart. Nothing is
 * promised about input that breaks a stated requirement of a function without a status.
 */
/* place fill-rule: the rule in a header */
#ifndef FIXEL_H
#define FIXEL_H

#include "fixel/config.h"
#include "fixel/render.h"
#include "fixel/scene.h"
#include "fixel/types.h"
#include "fixel/version.h"

#endif
