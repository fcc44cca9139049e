/* SPDX-License-Identifier: MIT */
/* Scan conversion: from a polygon of the screen to the pixels that it covers.
 * This states the fill rule; CONTRIBUTING.md lists the code that obeys it.
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

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A chain: the edges on one side of an outline, from its top to its bottom. */
typedef struct {
    uint8_t vertex;  /* at which the next edge begins */
    uint8_t onward;  /* step from a vertex to the next of the chain, modulo the count */
    int16_t end_row; /* one past the last row for which the trapezoid's edge holds */
} fxl_chain;

/* An edge on a row and its step to the next row, as integers with remainders. */
typedef struct {
    int32_t x;           /* first pixel whose centre is not left of the edge */
    uint32_t error;      /* remainder, < height */
    int32_t step;        /* whole pixels a row */
    uint32_t error_step; /* remainder, < height */
    uint32_t height;     /* in 1/65536 pixel */
} fxl_slope;

/* An edge that crosses the current row. */
typedef struct {
    fxl_slope slope;
    int32_t winding; /* +1 downward, -1 upward */
} fxl_active_edge;

/* The scan of an outline that goes up and down more than once, or leaves the band at a
 * side. With FXL_SMALL (config.h) every outline is scanned so. */
typedef struct {
    const fxl_screen_point *points;
    int16_t row, end_row; /* the current row; one past the last row */
    int16_t steady_end;   /* no edge begins or ends above this row */
    int16_t width;        /* of the band */
    uint8_t count;        /* points */
    uint8_t found_count;  /* edges that cross the row */
    int32_t x;            /* on the row, where the next stretch of pixels may begin */
    fxl_active_edge found[FXL_POLYGON_CAPACITY];
} fxl_active_edges;

/* A polygon that is being scanned. The caller owns it; all members belong to scan. */
typedef struct {
    const fxl_screen_point *points;
    uint8_t count;
    bool by_chains;  /* if false, by active edges */
    int16_t end_row; /* one past the last row by chains; above all rows by active edges */
    fxl_chain chains[2];
    int16_t row;    /* of the next span */
    uint8_t colour; /* for a caller that fills */
    fxl_trapezoid trapezoid;
    int16_t outline_first, outline_end; /* rows of the whole outline, as fxl_scan_rows says */
    fxl_active_edges active_edges;
} fxl_scan;

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

/* Finds the next span: the same pixels, for visibility methods that decide by spans.
 * Spans come by rows downward; those of a row come left to right and do not overlap.
 * Returns false if there are no more: span untouched. A scan is read either by
 * trapezoids or by spans, not by both. Exact. Source: A6. */
bool fxl_scan_next(fxl_scan *scan, fxl_span *span);

#ifdef __cplusplus
}
#endif

#endif
