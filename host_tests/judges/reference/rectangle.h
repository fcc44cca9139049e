/* SPDX-License-Identifier: MIT */
/* Polygons of the screen clipped to a rectangle (docs/extras/clippers.md, section 3), in double. */
#ifndef REF_RECTANGLE_H
#define REF_RECTANGLE_H

#include "reference/record.h"

/* In pixels, y down. */
typedef struct {
    double left, top, right, bottom;
} ref_rectangle;

/* Clips a convex polygon. Returns false where fewer than three vertices are left. Requires room for
 * four vertices more in REF_POLYGON_CAPACITY. */
bool ref_clip_to_rectangle(const ref_screen_polygon *in, const ref_rectangle *rectangle,
                           ref_screen_polygon *out);

#endif
