/* SPDX-License-Identifier: MIT */
/* Outlines on the screen, exactly: which pixels one covers, and how far two are apart. */
#ifndef ORACLE_COVER_H
#define ORACLE_COVER_H

#include <stdint.h>

/* Exact coverage by SPEC.md, section 5, row by row. The intersection of each edge with a row is
 * one exact quotient. */

/* A point of the screen in units of 2^-(16 + bits) pixel; bits is given with it. |x|, |y| <=
 * 2^60. */
typedef struct {
    int64_t x, y;
} oracle_spot;

enum {
    ORACLE_COVER_EDGES = 96
};

/* place fill-rule: definition: the claims coverage and watertight */
/* Adds 1 to row[x] for each pixel of row y, 0 <= x < width, if the winding number of the closed
 * outline about its centre is not 0. At most ORACLE_COVER_EDGES points; bits is 0 or 32. */
void oracle_cover_row(const oracle_spot *points, int count, int bits, int y, int width,
                      uint8_t *row);

/* The winding number about one centre by the text of SPEC.md, section 5, and nothing
 * else: the check of the above. */
int oracle_winding(const oracle_spot *points, int count, int bits, int x, int y);

/* Distances between closed outlines on the screen, in units of 1/65536 pixel.
 * Spots are in units of 2^-48 pixel; differences of spots are exact. */

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
