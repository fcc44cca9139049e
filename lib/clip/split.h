/* SPDX-License-Identifier: MIT */
/* Splits polygons of the world by a plane into a front part and a back part, in 16.16. The BSP
 * (A14) and the light beams (C6) use it. */
#ifndef FXL_SPLIT_H
#define FXL_SPLIT_H

#include "../math/contract.h"
#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A polygon of the world, or a part of one. */
typedef struct {
    uint32_t count; /* 3..FXL_POLYGON_CAPACITY; 2: an edge, in both directions */
    fxl_point points[FXL_POLYGON_CAPACITY];
} fxl_piece;

typedef enum {
    FXL_SPLIT_FRONT, /* no point is behind the plane: the piece itself. A piece in the plane, too */
    FXL_SPLIT_BACK,  /* a point is behind the plane and none is in front: the piece itself */
    FXL_SPLIT_BOTH,  /* both parts are in the output */
    FXL_SPLIT_CAPACITY /* a part would have more than FXL_POLYGON_CAPACITY points: refused */
} fxl_split_result;

/* Computes the point where an edge crosses a plane, from the end in front (distance > 0) to the
 * end behind (distance < 0). The direction is always this one. So all polygons that share the
 * edge get the same bits, in whichever direction their outline passes the edge and on whichever
 * side they lie. Each coordinate is that of the exact intersection, rounded to the nearest unit
 * of 1/65536. A half is rounded away from the end in front; a value within 2^-25 unit of a half
 * counts as a half. These integers are the intersection from here on.
 * Requires both ends in range, and their distances from one plane (fxl_plane_distance).
 * Error: 0.5 + 2^-25 unit a coordinate from the edge, so 0.87 unit from the edge and from the
 * plane. */
fxl_point fxl_split_edge(const fxl_point *front, const fxl_point *behind, fxl_q18_46 front_distance,
                         fxl_q18_46 behind_distance)
    FXL_REQUIRES(FXL_OBJECT(front) && FXL_OBJECT(behind) && front_distance > 0 && behind_distance < 0)
    FXL_REQUIRES(front_distance < (int64_t)1 << 62 && behind_distance > -((int64_t)1 << 62))
    FXL_REQUIRES(FXL_POINT_BELOW(front, FXL_COORDINATE_MAX) && FXL_POINT_BELOW(behind, FXL_COORDINATE_MAX))
    FXL_ASSIGNS() FXL_ENSURES(FXL_POINT_BELOW(&FXL_RESULT, FXL_COORDINATE_MAX));

/* Splits a piece by a plane. Points at distance >= 0 go into front, points at distance <= 0 into
 * back. A point on the plane belongs to both parts. So does each intersection, which is computed
 * once. A convex piece gains at most one point in each part.
 * Requires 2 <= in->count <= FXL_POLYGON_CAPACITY, points in range, a plane made by its
 * function, and three distinct records in, front and back. Both parts are written only for
 * FXL_SPLIT_BOTH, and up to the capacity for FXL_SPLIT_CAPACITY. Error of a new point: that of
 * fxl_split_edge. */
fxl_split_result fxl_split_piece(const fxl_piece *in, const fxl_plane *plane, fxl_piece *front,
                                 fxl_piece *back);

#ifdef __cplusplus
}
#endif

#endif
