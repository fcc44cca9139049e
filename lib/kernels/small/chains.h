/* SPDX-License-Identifier: MIT */
/* In the place of lib/src/chains.h. */
#ifndef FXL_CHAINS_H
#define FXL_CHAINS_H

#include "fixel/scan.h"

#define FXL_SCAN_HAS_CHAINS 0

/* The rows from an outline's highest to its lowest vertex. */
void fxl_outline_rows(const fxl_screen_point *points, uint32_t count, int16_t *first, int16_t *end);

#endif
