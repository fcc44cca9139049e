/* SPDX-License-Identifier: MIT */
/* The fill rule (SPEC.md, section 5): every pixel centre is tested by itself against
 * the whole outline. */
#ifndef REF_SCAN_H
#define REF_SCAN_H

#include "reference/record.h"

/* Whether the winding number about (cx, cy) is not 0. Exact where points and
 * centre are multiples of 1/65536 within 4095 pixels. */
bool ref_scan_covers(const ref_screen_polygon *polygon, double cx, double cy);

/* The rows of a screen whose centres lie from the polygon's highest vertex (it
 * included) to its lowest (not included); first == end where there are none. */
ref_rows ref_scan_rows(const ref_screen_polygon *polygon, int height);

/* A polygon being tested, pixel by pixel, within its bounding box grown by one
 * pixel and cut to the band. */
typedef struct {
    const ref_screen_polygon *polygon;
    int x0, x1, y, y1; /* columns x0 <= x < x1, rows y <= row < y1 still to do */
    int x;             /* next column of row y */
} ref_scan;

void ref_scan_begin(const ref_screen_polygon *polygon, const ref_band *band, ref_scan *scan);
bool ref_scan_next(ref_scan *scan, ref_span *span);

#endif
