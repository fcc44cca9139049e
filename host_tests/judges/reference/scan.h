/* SPDX-License-Identifier: MIT */
/* The pixels of a polygon: which it covers, and how they get their colour. */
#ifndef REF_SCAN_H
#define REF_SCAN_H

#include "reference/record.h"

/* The fill rule (SPEC.md, section 5). Every pixel centre is tested on its own against the whole
 * outline. */

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

/* Fills spans and bands with a colour. */

uint16_t ref_pixel(const ref_band *band, int x, int y);
void ref_fill_span(const ref_band *band, const ref_span *span, uint16_t colour);
void ref_fill_band(const ref_band *band, uint16_t colour);

/* The covered pixels of a band, a mark for each pixel (docs/extras/spans.md). */

/* The caller provides rows * width marks. */
typedef struct {
    bool *covered;
    int width, first_row, rows;
} ref_span_buffer;

/* Begins a band: nothing of it is covered. */
void ref_span_buffer_begin(ref_span_buffer *cover, bool *covered, const ref_band *band);

/* Returns the number of maximal intervals of covered pixels, over all rows. */
long ref_span_buffer_intervals(const ref_span_buffer *cover);

/* Colours the uncovered pixels of a span, and marks them covered. Returns false, and changes
 * nothing, where there would then be more than `runs` intervals. */
bool ref_span_buffer_draw(ref_span_buffer *cover, const ref_span *span, uint8_t colour,
                          const ref_band *band, long runs);

#endif
