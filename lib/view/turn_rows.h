/* SPDX-License-Identifier: MIT */
/* The matrix of an instance that is turned and not scaled. It is a kernel: Armv7-M has its own.
 * Internal. */
#ifndef FXL_TURN_ROWS_H
#define FXL_TURN_ROWS_H

#include "fixel/stage/camera.h"

#ifdef __cplusplus
extern "C" {
#endif

/* *matrix = view * of, each entry rounded once to 2.30. Requires rows of the view and columns of
 * the orientation that are at most 1 + 2^-24 long: then an entry fits, and a sum of three products
 * is below 2^60 (1 + 2^-23), as is each of its parts. Error: half a unit an entry. */
void fxl_turn_rows(const fxl_axes *view, const fxl_orientation *of, fxl_axes *matrix);

#ifdef __cplusplus
}
#endif

#endif
