/* SPDX-License-Identifier: MIT */
/* Splitting polygons of the world by planes, both parts kept, in 16.16: for trees
 * and light beams (A14, C6). */
#ifndef FXL_SPLIT_H
#define FXL_SPLIT_H

#include "fixel/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A polygon of the world, or a part of one. */
typedef struct {
    uint32_t count; /* 3..FXL_POLYGON_CAPACITY; 2: an edge, there and back */
    fxl_point points[FXL_POLYGON_CAPACITY];
} fxl_piece;

typedef enum {
    FXL_SPLIT_FRONT,   /* no point behind the plane: the piece itself; also one that lies in it */
    FXL_SPLIT_BACK,    /* none in front of it, and not all in it: the piece itself */
    FXL_SPLIT_BOTH,    /* split: both parts are in the output */
    FXL_SPLIT_CAPACITY /* a part would have more than FXL_POLYGON_CAPACITY points: refused */
} fxl_split_result;

/* Where an edge crosses a plane, from the end in front (distance > 0) to the end behind
 * (distance < 0). Always in this direction, so that all owners of an edge get the same
 * bits, whichever way they walk it and on whichever side they lie. Each coordinate is that
 * of the exact crossing, rounded to the nearest unit of 1/65536; halves, to within 2^-25
 * unit, go away from the end in front. Those integers are the crossing.
 * Requires both in range and their distances from one plane (fxl_plane_distance).
 * Error: 0.5 + 2^-25 unit a coordinate from the edge, so 0.87 unit from the edge and from
 * the plane. */
fxl_point fxl_split_edge(const fxl_point *front, const fxl_point *behind, fxl_q18_46 front_distance,
                         fxl_q18_46 behind_distance);

/* Splits a piece by a plane: points at distance >= 0 into front, points at distance <= 0
 * into back. A point on the plane belongs to both, and so does each crossing, which is
 * worked out once. A convex piece gains one point in each part at most.
 * Requires 2 <= in->count <= FXL_POLYGON_CAPACITY, points in range, a plane made by its
 * function; in, front and back apart from each other. Both parts are written only for
 * FXL_SPLIT_BOTH, and up to the capacity for FXL_SPLIT_CAPACITY. Error of a new point: as
 * above. */
fxl_split_result fxl_split_piece(const fxl_piece *in, const fxl_plane *plane, fxl_piece *front,
                                 fxl_piece *back);

#ifdef __cplusplus
}
#endif

#endif
