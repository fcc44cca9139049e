/* SPDX-License-Identifier: MIT */
/* From a polygon on the screen to covered pixels. Owns the fill rule.
 *
 * A pixel is covered where the winding number of the outline about its centre
 * (i + 1/2, j + 1/2) is not zero. Ties are top-left: a centre exactly on a
 * left or a top edge is covered, on a right or bottom edge it is not. Each
 * edge is judged by itself and exactly, whichever way it is walked, so two
 * polygons that share an edge neither leave a gap nor draw a pixel twice,
 * also where rounding made one of them slightly concave.
 */
#ifndef FXL_SCAN_H
#define FXL_SCAN_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One way down an outline, from its top to its bottom. */
typedef struct {
    uint8_t vertex;  /* where the next edge begins that will be set up */
    uint8_t onward;  /* how much further the next vertex is, modulo the count */
    int16_t end_row; /* one past the last row that the trapezoid's edge is good for */
} fxl_chain;

/* Where an edge crosses a row. */
typedef struct {
    int32_t x;       /* first pixel of the row whose centre is not left of the edge */
    int16_t winding; /* +1 downward, -1 upward */
} fxl_crossing;

/* An outline that goes up and down more than once, or leaves the band at a
 * side; with FXL_SMALL (config.h) any. */
typedef struct {
    const fxl_screen_point *points;
    int16_t row, end_row; /* whose crossings were found; one past the last */
    int16_t width;
    uint8_t count;                            /* points */
    uint8_t found_count, next;                /* crossings of the row; the first not yet used */
    fxl_crossing found[FXL_POLYGON_CAPACITY]; /* by x */
} fxl_active_edges;

/* A polygon being scanned. The caller owns it; all members belong to scan. */
typedef struct {
    const fxl_screen_point *points;
    uint8_t count;
    bool by_chains;  /* else by crossings */
    int16_t end_row; /* one past the last row by chains; above all rows by crossings */
    fxl_chain chains[2];
    int16_t row; /* the row that the next span is for */
    fxl_trapezoid trapezoid;
    int16_t outline_first, outline_end; /* the rows of all of the outline, see fxl_scan_rows */
    fxl_active_edges crossings;
} fxl_scan;

/* Begins to scan a polygon into a band; the polygon must outlive the scan.
 * Requires 3 <= count <= FXL_POLYGON_CAPACITY, |x|, |y| <=
 * FXL_SCREEN_COORDINATE_MAX, and a band as its record says.
 * Exact: given the 16.16 vertices, coverage has no error at all.
 * FXL_E_ARGUMENT, FXL_E_DEGENERATE, FXL_E_CAPACITY, FXL_E_RANGE: scan holds
 * no pixels. Source: the edge walk of Bresenham with an exact start. */
fxl_status fxl_scan_begin(const fxl_screen_polygon *polygon, const fxl_band *band, fxl_scan *scan);

/* The same for an outline of count points that is known to meet what
 * fxl_scan_begin requires, for a band that meets it too: nothing is checked.
 * The points must outlive the scan. */
void fxl_scan_outline(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                      fxl_scan *scan);

/* Whether the outline reaches a row of a screen of height rows; its band may hold
 * none of them. Exact. Requires a scan that was begun with an outline. */
static inline bool fxl_scan_is_on_screen(const fxl_scan *scan, uint16_t height)
{
    return scan->outline_first < scan->outline_end && scan->outline_end > 0 &&
           scan->outline_first < height;
}

/* The rows, of a screen of height rows, that hold every centre which the
 * polygon may cover: those from its highest to its lowest vertex. Exact: scan
 * finds an edge on each of them, and none on others.
 * Requires what fxl_scan_begin requires of a polygon. */
fxl_rows fxl_scan_rows(const fxl_screen_polygon *polygon, uint16_t height);

/* The next trapezoid, rows downward, left to right within a row; no pixel is
 * in two of them. It belongs to scan and is good until the next call. Null
 * when there are no more. A kernel: one for each family of cores (lib/kernels),
 * all with the same bits. */
const fxl_trapezoid *fxl_scan_next_trapezoid(fxl_scan *scan);

/* Whether there is no trapezoid after the last one: one that says so saves a call. */
static inline bool fxl_scan_is_over(const fxl_scan *scan)
{
    return scan->trapezoid.end_row == scan->end_row;
}

/* The same pixels a span at a time, for what decides by span: spans of a row
 * neither overlap nor touch out of order. False when there are no more; span
 * is then untouched. A scan is read by trapezoids or by spans, not by both. */
bool fxl_scan_next(fxl_scan *scan, fxl_span *span);

#ifdef __cplusplus
}
#endif

#endif
