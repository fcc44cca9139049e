/* SPDX-License-Identifier: MIT */
/* Scanning any outline: every edge walked, crossings sorted row by row.
 * Internal to scan. */
#ifndef FXL_SCAN_CROSSINGS_H
#define FXL_SCAN_CROSSINGS_H

#include "fixel/scan.h"

/* Begins with an outline and a band that were checked. */
void fxl_crossings_begin(fxl_crossings *crossings, const fxl_screen_point *points, uint32_t count,
                         const fxl_band *band);

/* The next span; false, and span untouched, when there are no more. */
bool fxl_crossings_next(fxl_crossings *crossings, fxl_span *span);

#endif
