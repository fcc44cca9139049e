/* SPDX-License-Identifier: MIT */
/* Distances between closed outlines on the screen, in units of 1/65536 pixel.
 * Spots are in units of 2^-48 pixel; differences of spots are exact. */
#ifndef ORACLE_HAUSDORFF_H
#define ORACLE_HAUSDORFF_H

#include "oracle/cover.h"

/* From a spot to a segment. */
double oracle_from_segment(const oracle_spot *p, const oracle_spot *a, const oracle_spot *b);

/* The Hausdorff distance between two outlines: of every point of either, edges'
 * insides too, the largest distance to the other. From above, and too large by
 * 2^-10, or a 64th of itself, at the most. */
double oracle_hausdorff(const oracle_spot *a, int a_count, const oracle_spot *b, int b_count);

/* An outline against nothing: its Hausdorff distance to a stroke there and back
 * between two of its own corners, the farthest apart, from above. A stroke has
 * the winding number 0 everywhere and covers as much as nothing does. */
double oracle_from_stroke(const oracle_spot *spots, int count);

#endif
