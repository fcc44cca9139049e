/* SPDX-License-Identifier: MIT */
/* Polygons for the tests of the family of clippers. */
#ifndef CLIP_SHAPES_H
#define CLIP_SHAPES_H

#include "unit.h"

/* World units of the view, exactly. */
#define V(units) ((fxl_q18_46)(units) * ((int64_t)1 << 46))

/* From whole numbers x, y, z of each vertex; two numbers ride along: 65536 x and
 * the vertex's place in the list. */
fxl_varying_polygon clip_shape(const int *numbers, size_t count);
#define SHAPE(...) clip_shape((const int[]){__VA_ARGS__}, sizeof((const int[]){__VA_ARGS__}) / 12)

/* Every second vertex at x = -reach, the others at x = 0, all at depth 10. */
fxl_varying_polygon clip_saw(uint8_t count, int reach);

/* The same vertices in the same order, from whichever vertex on, and what is
 * carried. */
bool clip_same(const fxl_varying_polygon *a, const fxl_varying_polygon *b);

/* A flat convex polygon about somewhere before the eye, up to 2^bits units of
 * 2^-46 in size. */
fxl_varying_polygon clip_random_shape(unsigned bits);

#endif
