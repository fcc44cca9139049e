/* SPDX-License-Identifier: MIT */
/* Edges on the grid of pixel centres, for both kinds of scan. Internal. */
#ifndef FXL_EDGE_H
#define FXL_EDGE_H

#include "../math/family.h"
#include "fixel/types.h"
#include "../math/arith.h"
#include "../math/core.h"
#include "../math/pixel_centre.h"
#include "edge_divide.h"
#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* For contracts: a point in the range of the screen, and what fxl_slope_set makes. */
#define FXL_ON_SCREEN(p) \
    (FXL_BELOW((p)->x, FXL_SCREEN_COORDINATE_MAX) && FXL_BELOW((p)->y, FXL_SCREEN_COORDINATE_MAX))
#define FXL_SLOPE(s) \
    ((s)->height > 0 && (s)->height <= 1u << 29 && (s)->error < (s)->height && \
     (s)->error_step < (s)->height && FXL_BELOW((s)->step, (1 << 29) + 1))

/* --- on the first row ---------------------------------------------------------------------- */

/* By the kernel of this core's family. All give the same bits. */
#if FXL_KERNELS_ARMV6M

/* edge_near_armv6m.S */

bool fxl_edge_set_near(const fxl_screen_point *top, const fxl_screen_point *bottom, uint32_t last,
                       fxl_edge *edge);

#else

/* place fill-rule: the first column of an edge in a row */
/* Sets an edge on the first row that it crosses, and its step. Returns false, with edge untouched,
 * if the edge does not hold from there to the row that is `last` rows below: see fxl_edge_set_far.
 * Requires two rows or more, so a height above 65535, and what fxl_edge_set requires. The dividends
 * are dx, for a step, and that of fxl_slope_set, for the first row, which is below height + |dx|
 * and so within FXL_EDGE_DIVIDEND_MAX. */
static inline bool fxl_edge_set_near(const fxl_screen_point *top, const fxl_screen_point *bottom,
                                     uint32_t last, fxl_edge *edge)
{
    int32_t dx = bottom->x - top->x;
    int32_t height = bottom->y - top->y;
    int32_t start = top->x - FXL_HALF_PIXEL;
    fxl_edge_divider divider = fxl_edge_divider_of((uint32_t)height);
    if (last >> fxl_edge_divider_shift(&divider) != 0) {
        return false;
    }
    int32_t x;
    fxl_edge_divide(&divider, fxl_edge_first_dividend(start, dx, height, top->y), &x,
                    &edge->fraction);
    edge->x = (start >> 16) + x + 1;
    fxl_edge_divide(&divider, dx, &edge->step, &edge->step_fraction);
    return true;
}

#endif

/* The first pixel whose centre is not left of the edge, on a row that the edge crosses; the row's
 * centre is at y. *error becomes the remainder. Exact. */
static inline int32_t fxl_edge_first_pixel(const fxl_screen_point *top,
                                           const fxl_screen_point *bottom, int32_t y,
                                           uint32_t *error)
    FXL_REQUIRES(FXL_OBJECT(top) && FXL_OBJECT(bottom) && FXL_OBJECT(error) && FXL_ON_SCREEN(top))
    FXL_REQUIRES(FXL_ON_SCREEN(bottom) && y >= top->y && y < bottom->y) FXL_ASSIGNS(*error)
    FXL_ENSURES(FXL_BELOW(FXL_RESULT, 1 << 29) && *error < (uint32_t)(bottom->y - top->y))
{
    int32_t height = bottom->y - top->y;
    int32_t start = top->x - FXL_HALF_PIXEL;
    FXL_ASSERT(height > 0 && y >= top->y && y < bottom->y);
    int64_t dividend = fxl_edge_dividend(start, bottom->x - top->x, height, y - top->y);
    int32_t quotient = fxl_divide_down(dividend, (uint32_t)height);
    /* Modulo 2^32: the remainder is below height. */
    *error = fxl_low_32(fxl_bits_64(dividend)) - fxl_bits_32(quotient) * (uint32_t)height;
    FXL_LEMMA(*error < (uint32_t)height);
    return (start >> 16) + quotient + 1;
}

/* Sets the edge on the same row. The next row adds 65536 dx to the sum of fxl_edge_dividend, so
 * it adds dx to the dividend. Exact. */
static inline void fxl_slope_set(const fxl_screen_point *top, const fxl_screen_point *bottom,
                                 int32_t y, fxl_slope *slope)
    FXL_REQUIRES(FXL_OBJECT(top) && FXL_OBJECT(bottom) && FXL_OBJECT(slope) && FXL_ON_SCREEN(top))
    FXL_REQUIRES(FXL_ON_SCREEN(bottom) && y >= top->y && y < bottom->y) FXL_ASSIGNS(*slope)
    FXL_ENSURES(FXL_SLOPE(slope) && FXL_BELOW(slope->x, 1 << 29))
{
    int32_t height = bottom->y - top->y, error_step;
    slope->x = fxl_edge_first_pixel(top, bottom, y, &slope->error);
    slope->step = fxl_divide_floor(bottom->x - top->x, height, &error_step);
    slope->error_step = (uint32_t)error_step;
    slope->height = (uint32_t)height;
}

/* Sets the edge from top to bottom on `row`, which it crosses, for this row and the
 * rows - 1 below it. Returns the number of these rows for which the edge holds, at least 1.
 * Requires a height of at most FXL_EDGE_HEIGHT_MAX and |dx| of at most 1025 pixels.
 *
 * The first pixel of row k is x + k step + floor((error + k error_step) / height), as in
 * fxl_slope. The fraction of that quotient is at most 1 - 1/height, and the edge's fraction
 * is larger by at most (k + 1) 2^-32. So the floors are the same while (k + 1) height is
 * below 2^32: while k + 1 <= 2^shift. */
int32_t fxl_edge_set_far(const fxl_screen_point *top, const fxl_screen_point *bottom, int32_t row,
                         int32_t rows, fxl_edge *edge)
    FXL_REQUIRES(FXL_OBJECT(top) && FXL_OBJECT(bottom) && FXL_OBJECT(edge) && FXL_ON_SCREEN(top))
    FXL_REQUIRES(FXL_ON_SCREEN(bottom) && FXL_BELOW(row, FXL_SCREEN_MAX) && rows > 0)
    FXL_REQUIRES(fxl_centre_of(row) >= top->y && fxl_centre_of(row) < bottom->y)
    FXL_REQUIRES(bottom->y - top->y <= FXL_EDGE_HEIGHT_MAX)
    FXL_ASSIGNS(*edge) FXL_ENSURES(FXL_RESULT >= 1 && FXL_RESULT <= rows);

/* Moves an edge down by 0 <= rows <= FXL_SCREEN_MAX rows. */
/* SPEC 5.3 */
static inline void fxl_edge_advance(fxl_edge *edge, uint32_t rows)
{
    uint64_t fraction = edge->fraction + fxl_multiply_u32(edge->step_fraction, rows);
    edge->fraction = fxl_low_32(fraction);
    edge->x += edge->step * (int32_t)rows + (int32_t)(fraction >> 32);
}

/* The same as fxl_edge_set_far, faster if the edge holds for all of its rows from the first on. For
 * an edge that crosses only one row, only that row's first pixel is computed. */
static inline int32_t fxl_edge_set(const fxl_screen_point *top, const fxl_screen_point *bottom,
                                   int32_t row, int32_t rows, fxl_edge *edge)
{
    int32_t dx = bottom->x - top->x;
    int32_t height = bottom->y - top->y;
    int32_t start = top->x - FXL_HALF_PIXEL;
    int32_t above = row - fxl_first_centre_from(top->y);
    FXL_ASSERT(height > 0 && height <= FXL_EDGE_HEIGHT_MAX && above >= 0 && rows > 0);
    FXL_ASSERT(fxl_within(dx, (FXL_SCREEN_MAX + 1) * 65536));
    if (above + rows == 1) {
        int32_t unused;
        edge->x =
            (start >> 16) + 1 +
            fxl_divide_floor(fxl_edge_first_dividend(start, dx, height, top->y), height, &unused);
        edge->fraction = 0;
        edge->step = 0;
        edge->step_fraction = 0;
        return 1;
    }
    if (!fxl_edge_set_near(top, bottom, (uint32_t)(above + rows - 1), edge)) {
        return fxl_edge_set_far(top, bottom, row, rows, edge);
    }
    if (above > 0) {
        fxl_edge_advance(edge, (uint32_t)above);
    }
    return rows;
}

#ifdef __cplusplus
}
#endif

#endif
