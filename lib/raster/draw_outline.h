/* SPDX-License-Identifier: MIT */
/* Drawing an outline: scan and fill in one call, for what draws over the pixels that are there.
 * Internal. */
#ifndef FXL_DRAW_OUTLINE_H
#define FXL_DRAW_OUTLINE_H

#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Fills the pixels of a band that an outline covers with scan->colour. Returns whether the outline
 * reaches a row of the band; with FXL_SMALL it is always true. Requires what fxl_scan_begin
 * requires of outline and band; the rest of scan is workspace. It is a kernel: each family of
 * cores may have its own, and all write the same pixels. Exact. */
bool fxl_draw_outline(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                      fxl_scan *scan);

/* The same by active edges, for an outline that is not scanned between two chains, or with
 * FXL_SMALL. A kernel calls it. */
bool fxl_draw_by_active_edges(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                              fxl_scan *scan);

/* fxl_scan_rows of count points. */
fxl_rows fxl_rows_of_points(const fxl_screen_point *points, uint32_t count, uint16_t height);

/* Whether fxl_scan_rows finds a row. */
bool fxl_outline_has_rows(const fxl_screen_polygon *polygon, uint16_t height);

#ifdef __cplusplus
}
#endif

#endif
