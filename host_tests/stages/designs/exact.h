/* SPDX-License-Identifier: MIT */
/* The exact values that the designs are measured against: __int128, and double
 * only for the last division, so that the figures are the same on every
 * machine. Of the library only the planes of the view are taken, as given. */
#ifndef DESIGNS_EXACT_H
#define DESIGNS_EXACT_H

#include "designs/design.h"

/* Sine of a binary angle to within 2^-50. */
double exact_sine(fxl_angle angle);

/* right, up and forward of a pose, in units of 2^-30, to within 2^-18. */
void exact_matrix(const fxl_pose *pose, double entries[9]);

/* points[number] in the view, in units of 2^-46: exact. */
fxl_view_point exact_view_point(const designs_input *input, int number);

/* The larger of the errors in x and y of a vertex, in 1/65536 pixel. */
double exact_vertex_error(const designs_input *input, const designs_screen *screen);

/* How far a point of the screen lies from the exact image of the line through
 * points[0] and points[1], in 1/65536 pixel. Negative where the line runs
 * through the eye and has no image. */
double exact_edge_distance(const designs_input *input, const designs_screen *screen);

/* Where the edge points[0]..points[1] crosses the input's plane, to about 2^-50
 * of its length; false where, exactly, points[0] is not inside and points[1]
 * not outside. */
bool exact_crossing(const designs_input *input, fxl_view_point *cut);

/* Where a vertex lies, for people: to about 2^-50 of it. */
designs_screen exact_screen(const designs_input *input, const fxl_view_point *point);

void exact_fill(const fxl_screen_polygon *outline, const designs_bitmap *bitmap);

#endif
