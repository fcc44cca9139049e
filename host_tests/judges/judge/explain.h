/* SPDX-License-Identifier: MIT */
/* Explains why a pixel may differ from that of the reference renderer (docs/accuracy.md, section
 * 4). */
#ifndef JUDGE_EXPLAIN_H
#define JUDGE_EXPLAIN_H

#include "reference/render.h"

/* The bounds of a polygon's outline, in pixels. */
typedef struct {
    double left, right, top, bottom;
} judge_box;

/* The distance in pixels within which an edge explains a difference, unless the caller asks for
 * another one (docs/accuracy.md, section 4). */
#define JUDGE_DISTANCE (1.0 / 8192)

/* Why a pixel may have its colour. */
typedef struct {
    double distance; /* in pixels, as judge_pixel finds it */
    bool near_far;   /* it needs near and far moved by the bound on depths */
    bool texels;     /* it needs another texel within the bound */
} judge_reason;

/* Returns the bounds of a frame's polygons, for the caller to free; null where memory is short. */
judge_box *judge_boxes_of(const ref_display_list *list);

/* Explains a colour at pixel (x, y) of the renderer's frame, which was begun with keeps_doubt. The
 * reason is within the bound if its distance is at most `limit`. line: the palette index of the
 * outlines that were drawn; below 0: none. */
judge_reason judge_pixel(const ref_renderer *renderer, const judge_box *boxes, uint8_t background,
                         int line, int x, int y, uint16_t colour, double limit);

#endif
