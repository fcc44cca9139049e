/* SPDX-License-Identifier: MIT */
/* Tells which of two planes a line crosses first, exactly. Internal. */
#ifndef FXL_INTERSECTION_ORDER_H
#define FXL_INTERSECTION_ORDER_H

#include "../math/arith.h"
#include "fixel/records.h"

/* Where a plane cuts a line from one point to another, given as the distances of the two points
 * from the plane. Each is below 2^63, and one of the points counts as inside. */
typedef struct {
    int plane; /* FXL_PLANE_COUNT: none */
    fxl_q18_46 from, to;
} fxl_plane_intersection;

/* Tells whether intersection a comes before b on the line: compares |from| / (|from| + |to|) as
 * exact fractions. The sums are below 2^64. The products are taken as 128 bits; the lower 64 are
 * those of a product that wraps. */
static inline bool fxl_intersection_is_before(const fxl_plane_intersection *a,
                                              const fxl_plane_intersection *b)
{
    uint64_t a_part = fxl_magnitude(a->from), b_part = fxl_magnitude(b->from);
    uint64_t a_whole = a_part + fxl_magnitude(a->to), b_whole = b_part + fxl_magnitude(b->to);
    uint64_t a_high = fxl_multiply_high(a_part, b_whole);
    uint64_t b_high = fxl_multiply_high(b_part, a_whole);
    return a_high < b_high || (a_high == b_high && a_part * b_whole < b_part * a_whole);
}

/* Keeps the later (or the earlier) of two intersections in *best. *best may be none as yet. */
static inline void fxl_intersection_prefer(fxl_plane_intersection *best,
                                           const fxl_plane_intersection *one, bool later)
{
    if (best->plane == FXL_PLANE_COUNT ||
        (later ? fxl_intersection_is_before(best, one) : fxl_intersection_is_before(one, best))) {
        *best = *one;
    }
}

#endif
