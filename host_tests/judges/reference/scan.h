/* SPDX-License-Identifier: MIT */
/* The fill rule (SPEC.md, section 5). Every pixel centre is tested on its own against the whole
 * outline. */
#ifndef REF_SCAN_H
#define REF_SCAN_H

#include "reference/record.h"

/* place fill-rule: definition: the reference */
/* Tells whether the winding number about (cx, cy) is not 0. Exact where points and centre are
 * multiples of 1/65536 within 4095 pixels. */
bool ref_scan_covers(const ref_screen_polygon *polygon, double cx, double cy);

/* Returns the rows of a screen whose centres lie between the polygon's highest vertex (included)
 * and its lowest (excluded); first == end where there are none. */
ref_rows ref_scan_rows(const ref_screen_polygon *polygon, int height);

/* The state of a scan: a polygon that is tested pixel by pixel, within its bounding box, which
 * is enlarged by one pixel and cut to the band. */
typedef struct {
    const ref_screen_polygon *polygon;
    int x0, x1, y, y1; /* columns x0 <= x < x1; rows y <= row < y1 are left */
    int x;             /* the next column of row y */
} ref_scan;

void ref_scan_begin(const ref_screen_polygon *polygon, const ref_band *band, ref_scan *scan);
bool ref_scan_next(ref_scan *scan, ref_span *span);

#endif
