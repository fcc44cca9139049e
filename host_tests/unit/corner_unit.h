/* SPDX-License-Identifier: MIT */
/* A small face by three of its corners on the screen, and planes through them in double. */
#ifndef CORNER_UNIT_H
#define CORNER_UNIT_H

#include <math.h>

#include "clip_unit.h"
#include "paint/corner_planes.h"

/* Seeds of the checks of bounds that few faces come near. */
#ifdef UNIT_ON_TARGET
#define CORNER_SEEDS 2
#else
#define CORNER_SEEDS 20
#endif

typedef struct {
    fxl_view view;
    fxl_screen_corners corners;
    fxl_corner_planes planes;
} corner_triangle;

extern corner_triangle triangle; /* there is one */

/* Any lens. */
void corner_begin(void);

/* The numbers of a seed, and a lens of them. */
void corner_begin_seed(uint32_t seed);

/* Three corners in a box of some size on the screen, at depths that differ by less than `spread`.
 */
void corner_make(double spread);

/* Puts the corners where rounding costs most: corners 0 and 1 at opposite ends of the box, and the
 * other one so near their line that the triangle fills about `part` of the box, or less at a border
 * of the screen. */
void corner_make_thin(double part);

/* A point of the triangle. */
void corner_choose_point(double *x, double *y);

/* A corner or another point of the triangle: what is linear differs most at a corner. */
void corner_choose_place(double *x, double *y);

double corner_twice_area(void);

/* Of a plane that has values at the corners: at a point of the screen. */
double corner_plane_at(const double values[3], double x, double y);

/* Of an attribute that has values at the corners, in perspective. */
double corner_attribute_at(const double values[3], double x, double y);

/* What rounding costs them, and a depth, at most. */
double corner_plane_rounding(const double values[3]);
double corner_divided_rounding(const double values[3], double x, double y);
double corner_depth_rounding(const double values[3]);

#endif
