/* SPDX-License-Identifier: MIT */
/* Scanning any outline by active edges: on each row, the crossings of the edges that reach it.
 * Internal to scan. */
#ifndef FXL_ACTIVE_EDGES_H
#define FXL_ACTIVE_EDGES_H

#include "fixel/records.h"

/* Right of every crossing. */
#define FXL_NO_CROSSING INT32_MAX

/* Begins a scan. Requires an outline and a band as fxl_scan_begin does. first_row and end_row are
 * fxl_first_centre_from of the highest and of the lowest vertex. The points must outlive the
 * scan. */
void fxl_active_edges_begin(fxl_active_edges *edges, const fxl_screen_point *points, uint32_t count,
                            int32_t first_row, int32_t end_row, const fxl_band *band);

/* Finds the next span. Returns false if there are no more: span untouched. */
bool fxl_active_edges_next(fxl_active_edges *edges, fxl_span *span);

/* For FXL_SMALL: fills the span that fxl_active_edges_next found. Where two edges cross its row, it
 * fills the rows below that the same two cross, too, and goes to the last of them. */
void fxl_active_edges_fill(fxl_active_edges *edges, const fxl_span *span, const fxl_band *band,
                           uint8_t colour);

#endif
