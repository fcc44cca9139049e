/* SPDX-License-Identifier: MIT */
/* Scan conversion: from a polygon of the screen to the pixels that it covers.
 * This states the fill rule; `fixel places fill-rule` prints the code that obeys it.
 *
 * A polygon covers a pixel if the winding number of its outline about the pixel's
 * centre (i + 1/2, j + 1/2) is not zero. Ties follow the top-left rule: a centre
 * exactly on a left or a top edge is covered, a centre exactly on a right or a bottom
 * edge is not. Each edge is tested by itself, exactly, and with the same result in
 * either direction. So two polygons that share an edge neither leave a gap nor draw a
 * pixel twice, even if rounding made one of them slightly concave.
 */
#ifndef FXL_SCAN_H
#define FXL_SCAN_H

#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Begins to scan a polygon into a band. The polygon must outlive the scan.
 * Requires 3 <= count <= FXL_POLYGON_CAPACITY, |x|, |y| <=
 * FXL_SCREEN_COORDINATE_MAX, and a band as fxl_band describes it.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_DEGENERATE: fewer than three vertices are left.
 * FXL_E_CAPACITY: too little memory.
 * FXL_E_RANGE: a number is out of its range.
 * With each of these statuses: the scan has no pixels.
 * Exact: given the 16.16 vertices, coverage has no error at all.
 * Source: Bresenham's stepping along an edge, with an exact start. */
fxl_status fxl_scan_begin(const fxl_screen_polygon *polygon, const fxl_band *band, fxl_scan *scan);

/* Begins to scan an outline of count points into a band, without checks.
 * Requires what fxl_scan_begin requires, of outline and band. The points must outlive
 * the scan. Exact. */
void fxl_scan_outline(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                      fxl_scan *scan);

/* Whether the outline reaches a row of the band that the scan was begun with. Requires a scan that
 * was begun without an error. Exact. */
static inline bool fxl_scan_reaches(const fxl_scan *scan, const fxl_band *band)
{
    return scan->outline_first < scan->outline_end && scan->outline_end > band->first_row &&
           scan->outline_first < band->first_row + band->rows;
}

/* The rows, of a screen of height rows, that the polygon reaches: the rows whose
 * centres lie from its highest to its lowest vertex. It covers no centre of another row.
 * Requires what fxl_scan_begin requires of a polygon.
 * Exact: scan finds an edge on each of these rows, and on no others. */
fxl_rows fxl_scan_rows(const fxl_screen_polygon *polygon, uint16_t height);

/* Returns the next trapezoid, or null if there are no more. Trapezoids come by rows
 * downward, and left to right within a row; no pixel is in two of them. The trapezoid
 * belongs to scan and is valid until the next call. It is a kernel: each family of
 * cores has its own, and all give the same bits. Exact. Source: A6. */
const fxl_trapezoid *fxl_scan_next_trapezoid(fxl_scan *scan);

/* Whether the trapezoid that was returned is known to be the last; true saves a call. */
static inline bool fxl_scan_is_over(const fxl_scan *scan)
{
    return scan->trapezoid.end_row == scan->end_row;
}

/* Finds the next span: the same pixels, for targets that decide by spans.
 * Spans come by rows downward; those of a row come left to right and do not overlap.
 * Returns false if there are no more: span untouched. A scan is read either by
 * trapezoids or by spans, not by both. Exact. Source: A6. */
bool fxl_scan_next(fxl_scan *scan, fxl_span *span);

/* Returns the next span of a scan by active edges, as a trapezoid of one row; null if there are no
 * more. The kernel calls it if a scan has no more rows by chains and is not by chains. */
const fxl_trapezoid *fxl_scan_next_of_active_edges(fxl_scan *scan);

/* Right of every crossing. */
#define FXL_NO_CROSSING INT32_MAX

/* place fill-rule: the winding number */
/* place fill-rule: the rule in a header */
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

/* --- tiny triangles: of at most 2 x 2 pixel centres ------------------------ */

#define FXL_TINY_SIDE 2

/* Compiled for few bytes, triangles are scanned whatever their size. */
#define FXL_HAS_TINY (!FXL_IS_SMALL && !FXL_IS_COMPACT)

/* The pixels that a triangle covers in a band: bit FXL_TINY_SIDE j + i is that of column + i of
 * row + j. */
typedef struct {
    int32_t column, row;
    uint32_t pixels;
} fxl_tiny;

/* Finds the pixels of a band, all of whose columns are drawn, that a triangle covers: those of a
 * scan, by the exact edge functions at each centre. Returns false if it is not tiny: *tiny is
 * undefined then. Exact. */
bool fxl_tiny_find(const fxl_screen_point *points, const fxl_band *band, fxl_tiny *tiny);

#ifdef __cplusplus
}
#endif

#endif
