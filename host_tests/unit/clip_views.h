/* SPDX-License-Identifier: MIT */
/* Views from anywhere, and points and polygons of the world that lie at given places of a view. */
#ifndef CLIP_VIEWS_H
#define CLIP_VIEWS_H

#include "unit.h"

/* Any pose within 100 units, with the tests' standard lens. */
fxl_view clip_random_view(uint16_t width, uint16_t height);

/* A point so far to the right, up and ahead, to within a unit or two. */
fxl_point clip_place(const fxl_view *view, fxl_q16_16 x, fxl_q16_16 y, fxl_q16_16 z);

/* A flat, convex polygon of 3 to 6 vertices; before the eye, or partly behind it. */
fxl_polygon clip_random_face(const fxl_view *view);

#endif
