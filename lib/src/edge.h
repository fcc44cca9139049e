/* SPDX-License-Identifier: MIT */
/* Edges on the grid of pixel centres: what both ways of scanning share.
 * Internal. */
#ifndef FXL_EDGE_H
#define FXL_EDGE_H

#include "arith.h"

#define FXL_HALF_PIXEL 32768

/* The first row (or column) whose centre is at or past a coordinate below
 * 2^30. */
static inline int32_t fxl_first_centre_from(fxl_q16_16 coordinate)
{
    return (coordinate + FXL_HALF_PIXEL - 1) >> 16;
}

/* An edge's slope as whole numbers, and its place on its first row. */
typedef struct {
    int32_t x;           /* first pixel whose centre is not left of the edge */
    uint32_t error;      /* what is left over, < height */
    int32_t step;        /* whole pixels a row */
    uint32_t error_step; /* what is left over, < height */
    uint32_t height;     /* in 1/65536 pixel */
} fxl_slope;

/* The edge from top to bottom, which crosses `first_row` first of all rows:
 * that row's centre is less than a pixel below the top.
 *
 * The edge's x there is top.x + dx t / height, t the distance of the row's
 * centre from the top, and the first pixel is ceil(x - 1/2). With
 * top.x - 1/2 = 65536 whole + part (0 <= part < 65536) that is
 *   whole + ceil((part height + dx t) / (65536 height)),
 * and ceil(n / m) = floor((n - 1) / m) + 1, and a floor of a floor is the floor
 * of the whole quotient. height, |dx| < 2^29 and part, t < 2^16, so the sum is
 * below 2^46 and, without its low 16 bits, below 2^30. A row further down adds
 * 65536 dx to the sum, so dx to what is divided by height. Exact. */
static inline void fxl_slope_set(const fxl_screen_point *top, const fxl_screen_point *bottom,
                                 int32_t first_row, fxl_slope *slope)
{
    int32_t dx = bottom->x - top->x;
    int32_t height = bottom->y - top->y;
    int32_t start = top->x - FXL_HALF_PIXEL;
    int32_t t = first_row * 65536 + FXL_HALF_PIXEL - top->y;
    FXL_ASSERT(height > 0 && t >= 0 && t < 65536);
    int64_t sum = (int64_t)(start & 65535) * height + (int64_t)dx * t;
    int32_t error, error_step;
    int32_t quotient = fxl_divide_floor((int32_t)((sum - 1) >> 16), height, &error);
    slope->x = (start >> 16) + quotient + 1;
    slope->error = (uint32_t)error;
    slope->step = fxl_divide_floor(dx, height, &error_step);
    slope->error_step = (uint32_t)error_step;
    slope->height = (uint32_t)height;
}

/* Moves the place down by 0 < rows < 2^13 rows at once: the carries that single
 * steps would have made are floor((error + rows error_step) / height), found
 * by long division, as they are fewer than 2^13. The sum is below 2^43. */
static inline void fxl_slope_skip(fxl_slope *slope, int32_t rows)
{
    FXL_ASSERT(rows > 0 && rows < 8192);
    uint64_t error = slope->error + (uint64_t)(uint32_t)rows * slope->error_step;
    int32_t carries = 0;
    for (int32_t bit = 4096; bit != 0; bit >>= 1) {
        uint64_t part = (uint64_t)slope->height * (uint32_t)bit;
        if (error >= part) {
            error -= part;
            carries += bit;
        }
    }
    slope->x += rows * slope->step + carries;
    slope->error = (uint32_t)error;
}

/* 2^64 / divisor - 2^32 for 2^31 <= divisor < 2^32, off by -3.3 to +2.0 times
 * 2^32 / divisor (every divisor tried). One division of 32 bits gives 16 bits,
 * one step after Newton the rest; what is subtracted from its numerator shares
 * the first error out to both sides. */
static inline uint32_t fxl_edge_reciprocal(uint32_t divisor)
{
    FXL_ASSERT(divisor >> 31 != 0);
    uint32_t rough = (0xFFFF7FFFu / (divisor >> 16)) << 15; /* 2^63 / divisor */
    uint32_t product = (uint32_t)(((uint64_t)rough * divisor) >> 32);
    return (uint32_t)(((uint64_t)rough * (0u - product)) >> 30);
}

/* 2^32 error / height, up to 7 too large, never too small: scaled is error
 * 2^shift, below the divisor height 2^shift. The product loses less than 1 and
 * the reciprocal brings -3.3 to +2.0, so 5 more is too large by 0.7 to 7. As
 * height is below 2^29, error / height is at least 8 units below 1. */
static inline uint32_t fxl_edge_fraction(uint32_t scaled, uint32_t reciprocal)
{
    return scaled + (uint32_t)(((uint64_t)scaled * reciprocal) >> 32) + 5;
}

/* A slope as an edge; answers for how many rows it is good, 1 at least.
 *
 * Row k's first pixel is x + k step + floor((error + k error_step) / height).
 * That quotient's fraction is 1 - 1/height at most, and the edge's is larger by
 * at most 7 (k + 1) 2^-32; so the floors are the same while 7 (k + 1) height
 * is below 2^32. height is below 2^(32 - shift). */
static inline int32_t fxl_slope_to_edge(const fxl_slope *slope, fxl_edge *edge)
{
    unsigned shift = (unsigned)__builtin_clz(slope->height);
    uint32_t reciprocal = fxl_edge_reciprocal(slope->height << shift);
    FXL_ASSERT(shift >= 3);
    edge->x = slope->x;
    edge->fraction = fxl_edge_fraction(slope->error << shift, reciprocal);
    edge->step = slope->step;
    edge->step_fraction = fxl_edge_fraction(slope->error_step << shift, reciprocal);
    return (int32_t)(1u << (shift - 3));
}

#endif
