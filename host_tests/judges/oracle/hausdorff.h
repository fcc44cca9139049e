/* SPDX-License-Identifier: MIT */
/* Distances between closed outlines on the screen, in units of 1/65536 pixel.
 * Spots are in units of 2^-48 pixel; differences of spots are exact. */
#ifndef ORACLE_HAUSDORFF_H
#define ORACLE_HAUSDORFF_H

#include "oracle/cover.h"

/* Returns the distance from a spot to a segment. */
double oracle_from_segment(const oracle_spot *p, const oracle_spot *a, const oracle_spot *b);

/* Returns an upper bound of the Hausdorff distance between two outlines: the largest distance of
 * a point of either (of its edges, too) to the other. The bound is too large by at most 2^-10,
 * or by a 64th of itself. */
double oracle_hausdorff(const oracle_spot *a, int a_count, const oracle_spot *b, int b_count);

/* place fill-rule: what the two claims count */
/* Measures an outline against an empty one: returns an upper bound of its Hausdorff distance to
 * a stroke, forth and back, between the two of its own vertices that are the farthest apart. A
 * stroke has the winding number 0 everywhere, so it covers no pixel, like an empty outline. */
double oracle_from_stroke(const oracle_spot *spots, int count);

#endif
