/* SPDX-License-Identifier: MIT */
/* Scanning any outline: on each row its edges' crossings, by x.
 * Internal to scan. */
#ifndef FXL_SCAN_CROSSINGS_H
#define FXL_SCAN_CROSSINGS_H

#include "fixel/scan.h"

/* Begins with an outline and a band that were checked. first_row is that of the highest vertex,
 * end_row that of the lowest (fxl_first_centre_from). The points must outlive the scan. */
void fxl_crossings_begin(fxl_crossings *crossings, const fxl_screen_point *points, uint32_t count,
                         int32_t first_row, int32_t end_row, const fxl_band *band);

/* The next span; false, and span untouched, when there are no more. */
bool fxl_crossings_next(fxl_crossings *crossings, fxl_span *span);

#endif
