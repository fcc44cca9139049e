/* SPDX-License-Identifier: MIT */
/* From a polygon on the screen to spans of covered pixels. Owns the fill rule.
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

#include "fixel/record.h"
#include "fixel/status.h"

/* An edge being walked, top to bottom. All members belong to scan.c. */
typedef struct {
    int32_t x;          /* first pixel of the row whose centre is not left of the edge */
    int32_t step;       /* whole pixels a row */
    int32_t error;      /* remainder, 0 <= error < height */
    int32_t error_step; /* remainder a row, 0 <= error_step < height */
    int32_t height;     /* of the edge, in 1/65536 pixel */
    int16_t row;        /* the row that x is for; at first the edge's first row */
    int16_t end_row;    /* one past its last row */
    int16_t winding;    /* +1 downward, -1 upward */
} fxl_edge;

/* A polygon being scanned. The caller owns it; all members belong to scan.c. */
typedef struct {
    fxl_edge edges[FXL_POLYGON_CAPACITY];    /* by first row */
    uint8_t crossings[FXL_POLYGON_CAPACITY]; /* edges that cross the row, by x */
    uint8_t edge_count, next_edge;           /* edges; the first not yet reached */
    uint8_t crossing_count, next_crossing;   /* crossings; the first not yet used */
    int16_t row, width;
} fxl_scan;

/* Begins to scan a polygon into a band.
 * Requires 3 <= count <= FXL_POLYGON_CAPACITY, |x|, |y| <=
 * FXL_SCREEN_COORDINATE_MAX, and a band as its record says.
 * Exact: given the 16.16 vertices, coverage has no error at all.
 * FXL_E_ARGUMENT, FXL_E_DEGENERATE, FXL_E_CAPACITY, FXL_E_RANGE: scan holds
 * no spans. Source: the edge walk of Bresenham with an exact start. */
fxl_status fxl_scan_begin(const fxl_screen_polygon *polygon, const fxl_band *band, fxl_scan *scan);

/* The same for an outline of count points that is known to meet what
 * fxl_scan_begin requires, for a band that meets it too: nothing is checked. */
void fxl_scan_outline(const fxl_screen_point *points, uint32_t count, const fxl_band *band,
                      fxl_scan *scan);

/* The rows, of a screen of height rows, that hold every centre which the
 * polygon may cover: those from its highest to its lowest vertex. Exact: scan
 * finds an edge on each of them, and none on others.
 * Requires what fxl_scan_begin requires of a polygon. */
fxl_rows fxl_scan_rows(const fxl_screen_polygon *polygon, uint16_t height);

/* The next span, rows downward, left to right within a row; spans of a row
 * neither overlap nor touch out of order. False when there are no more; span
 * is then untouched. */
bool fxl_scan_next(fxl_scan *scan, fxl_span *span);

#endif
