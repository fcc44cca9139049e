/* SPDX-License-Identifier: MIT */
/* Exact coverage by SPEC.md, section 5, row by row. The intersection of each edge with a row is
 * one exact quotient. */
#ifndef ORACLE_COVER_H
#define ORACLE_COVER_H

#include <stdint.h>

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

#endif
