/* SPDX-License-Identifier: MIT */
/* Clips polygons of the screen to a rectangle, in two dimensions. Source: notes on clipping after
 * projection (B4). */
#ifndef FXL_RECTANGLE_H
#define FXL_RECTANGLE_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A rectangle of the screen, in pixels; y goes down. Its borders belong to it. */
typedef struct {
    fxl_q16_16 left, top, right, bottom;
} fxl_rectangle;

/* The memory that the clipper needs. The caller owns it. It keeps nothing from one call to the
 * next. */
typedef struct {
    fxl_screen_polygon polygons[2];
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
} fxl_rectangle_work;

/* Clips a convex polygon to a rectangle. A vertex on a border is inside.
 * FXL_CLIP_INSIDE: no vertex lies outside; *result is the input itself. FXL_CLIP_OUTSIDE: all
 * vertices lie outside one border, or nothing is left. FXL_CLIP_CUT: *result is a polygon of work,
 * of the input's colour and kind. FXL_CLIP_DEGENERATE: fewer than three vertices are left.
 * FXL_CLIP_CAPACITY: refused, because more than FXL_POLYGON_CAPACITY would be left. *result is null
 * where the polygon is neither inside nor cut. An edge that two polygons share is cut from its
 * inside end, so both get the same bits.
 * Requires 3 <= in->count <= FXL_POLYGON_CAPACITY, left <= right, top <= bottom, and all
 * coordinates within FXL_SCREEN_COORDINATE_MAX. The input must not be a polygon of work.
 * Error of a new vertex: none across the border. Along the border it is rounded to the nearest
 * 1/65536 pixel, so from the edge of the input it lies half a unit for each border that cut the
 * edge: at most 2 units. */
fxl_clip_result fxl_clip_to_rectangle(const fxl_screen_polygon *in, const fxl_rectangle *rectangle,
                                      fxl_rectangle_work *work, const fxl_screen_polygon **result);

#ifdef __cplusplus
}
#endif

#endif
