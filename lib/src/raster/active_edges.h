/* SPDX-License-Identifier: MIT */
/* Scanning any outline: on each row its edges' crossings, by x.
 * Internal to scan. */
#ifndef FXL_ACTIVE_EDGES_H
#define FXL_ACTIVE_EDGES_H

#include "fixel/stage/scan.h"

/* Begins with an outline and a band that were checked. first_row is that of the highest vertex,
 * end_row that of the lowest (fxl_first_centre_from). The points must outlive the scan. */
void fxl_active_edges_begin(fxl_active_edges *crossings, const fxl_screen_point *points,
                            uint32_t count, int32_t first_row, int32_t end_row,
                            const fxl_band *band);

/* The next span; false, and span untouched, when there are no more. */
bool fxl_active_edges_next(fxl_active_edges *crossings, fxl_span *span);

#endif
