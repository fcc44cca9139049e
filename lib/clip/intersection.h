/* SPDX-License-Identifier: MIT */
/* Where an edge crosses a plane: functions that clippers of lines and polygons share. Internal. */
#ifndef FXL_INTERSECTION_H
#define FXL_INTERSECTION_H

#include "../math/arith.h"
#include "fixel/line.h"
#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Returns floor(2^64 inside / (inside - outside)). Requires inside >= 0 > outside and a
 * difference below 2^63. Distances of points below 2^61 from one plane meet this. */
uint64_t fxl_intersection_fraction(fxl_q18_46 inside, fxl_q18_46 outside)
    FXL_REQUIRES(inside >= 0 && outside < 0 && inside <= INT64_MAX + outside) FXL_ASSIGNS();

/* Returns from + (to - from) fraction / 2^64, rounded towards from: error less than one unit.
 * Requires both below 2^61. */
fxl_q18_46 fxl_intersection_part(fxl_q18_46 from, fxl_q18_46 to, uint64_t fraction)
    FXL_REQUIRES(FXL_BELOW(from, (int64_t)1 << 61) && FXL_BELOW(to, (int64_t)1 << 61)) FXL_ASSIGNS()
    FXL_ENSURES(from <= to ? FXL_RESULT >= from && FXL_RESULT <= to
                           : FXL_RESULT <= from && FXL_RESULT >= to);

/* Returns where an edge of the screen crosses a border, along the border: from + (to - from)
 * inside / (inside - outside), rounded to the nearest, halves upward. inside and outside are the
 * ends' distances from the border. Requires inside >= 0 > outside, and points within
 * FXL_SCREEN_COORDINATE_MAX: the distances, their difference and that of the coordinates are then
 * below 2^29, and the product is below 2^58. */
static inline fxl_q16_16 fxl_intersection_screen(fxl_q16_16 from, fxl_q16_16 to, fxl_q18_46 inside,
                                                 fxl_q18_46 outside)
{
    FXL_ASSERT(inside >= 0 && outside < 0);
    int64_t product = ((int64_t)to - from) * inside;
    return from + fxl_divide_round(product, (uint32_t)(inside - outside));
}

/* Interpolates a varying, rounded to the nearest: error half a unit. */
fxl_q16_16 fxl_intersection_varying(fxl_q16_16 from, fxl_q16_16 to, uint64_t fraction)
    FXL_REQUIRES(1) FXL_ASSIGNS()
    FXL_ENSURES(from <= to ? FXL_RESULT >= from && FXL_RESULT <= to
                           : FXL_RESULT <= from && FXL_RESULT >= to);

/* Computes the vertex at a fraction of the way from the inside to the outside end. The direction
 * is always this one, so both polygons that share the edge get the same bits. vertex must be
 * neither end.
 * Error: less than 1 unit of 2^-46 a coordinate, 0.51 unit of 2^-16 a varying. */
void fxl_intersection_vertex(const fxl_varying_vertex *inside, const fxl_varying_vertex *outside,
                             uint64_t fraction, uint32_t carried, fxl_varying_vertex *vertex)
    FXL_REQUIRES(FXL_OBJECT(inside) && FXL_OBJECT(outside) && FXL_OBJECT(vertex))
    FXL_REQUIRES(FXL_POINT_BELOW(&inside->position, ((int64_t)1 << 61) - 1))
    FXL_REQUIRES(FXL_POINT_BELOW(&outside->position, ((int64_t)1 << 61) - 1))
    FXL_REQUIRES(carried <= FXL_CARRIED_MAX) FXL_ASSIGNS(*vertex)
    FXL_ENSURES(FXL_POINT_BELOW(&vertex->position, ((int64_t)1 << 61) - 1));

/* Copies a vertex with only the varyings that are used. */
void fxl_copy_vertex(const fxl_varying_vertex *from, uint32_t carried, fxl_varying_vertex *to)
    FXL_REQUIRES(FXL_OBJECT(from) && FXL_OBJECT(to) && carried <= FXL_CARRIED_MAX)
    FXL_ASSIGNS(*to) FXL_ENSURES(to->position.x == from->position.x)
    FXL_ENSURES(to->position.y == from->position.y && to->position.z == from->position.z);

/* *point = from + (to - from) fraction / 2^64, each coordinate rounded towards from, where fraction
 * is floor(2^64 inside / (inside - outside)). Error: less than one unit, and what the fraction's
 * error is of the edge's length. *inside and *outside are the distances of from and to.
 * Requires 0 < *inside and *outside < 0, both below 2^62, and coordinates whose difference is below
 * 2^62. */
void fxl_intersect_edge(const fxl_view_point *from, const fxl_view_point *to,
                        const fxl_q18_46 *inside, const fxl_q18_46 *outside, fxl_view_point *point)
    FXL_REQUIRES(FXL_OBJECT(from) && FXL_OBJECT(to) && FXL_OBJECT(point) && FXL_OBJECT(inside))
    FXL_REQUIRES(FXL_OBJECT(outside) && *inside > 0 && *inside < (int64_t)1 << 62 && *outside < 0)
    FXL_REQUIRES(*outside >= -((int64_t)1 << 62) && FXL_POINT_BELOW(from, ((int64_t)1 << 61) - 1))
    FXL_REQUIRES(FXL_POINT_BELOW(to, ((int64_t)1 << 61) - 1)) FXL_ASSIGNS(*point)
    FXL_ENSURES(FXL_POINT_BELOW(point, ((int64_t)1 << 61) - 1));

#ifdef __cplusplus
}
#endif

#endif
