/* SPDX-License-Identifier: MIT */
/* Splits polygons of the world by a plane at the intersections of fxl_split_edge, as beams and trees do: so tests show that parts of
 * neighbours fit. */
#ifndef SPLIT_PIECE_H
#define SPLIT_PIECE_H

#include "draw/stages.h"
#include "math/plane.h"

/* A polygon of the world, or a part of one. */
typedef struct {
    uint32_t count; /* 3..FXL_POLYGON_CAPACITY; 2: an edge, in both directions */
    fxl_point points[FXL_POLYGON_CAPACITY];
} split_piece;

typedef enum {
    SPLIT_FRONT,   /* no point is behind the plane: the piece itself. A piece in the plane, too */
    SPLIT_BACK,    /* a point is behind the plane and none is in front: the piece itself */
    SPLIT_BOTH,    /* both parts are in the output */
    SPLIT_CAPACITY /* a part would have more than FXL_POLYGON_CAPACITY points: refused */
} split_result;

/* Appends a point. Returns false where the piece is full. */
static inline bool split_append(split_piece *piece, const fxl_point *point)
{
    if (piece->count == FXL_POLYGON_CAPACITY) {
        return false;
    }
    piece->points[piece->count++] = *point;
    return true;
}

/* Appends a point to the part or parts that it belongs to. */
static inline bool split_append_point(const fxl_point *point, fxl_q18_46 distance,
                                      split_piece *front, split_piece *back)
{
    return (distance < 0 || split_append(front, point)) &&
           (distance > 0 || split_append(back, point));
}

/* Returns on which sides a piece has points off the plane: bit 1 in front, bit 2 behind. */
static inline unsigned split_sides(const split_piece *in, const fxl_plane *plane)
{
    unsigned seen = 0;
    for (uint32_t i = 0; i < in->count && seen != 3; i++) {
        fxl_q18_46 distance = fxl_plane_distance(plane, &in->points[i]);
        seen |= (distance > 0 ? 1u : 0u) | (distance < 0 ? 2u : 0u);
    }
    return seen;
}

/* Splits a piece by a plane. Points at distance >= 0 go into front, points at distance <= 0 into back.
 * An intersection is a point of both. */
static inline split_result split_by(const split_piece *in, const fxl_plane *plane,
                                    split_piece *front, split_piece *back)
{
    unsigned seen = split_sides(in, plane);
    if (seen != 3) {
        return seen == 2 ? SPLIT_BACK : SPLIT_FRONT;
    }
    front->count = 0;
    back->count = 0;
    const fxl_point *from = &in->points[in->count - 1];
    fxl_q18_46 before = fxl_plane_distance(plane, from);
    for (uint32_t i = 0; i < in->count; i++) {
        const fxl_point *to = &in->points[i];
        fxl_q18_46 distance = fxl_plane_distance(plane, to);
        if ((before > 0 && distance < 0) || (before < 0 && distance > 0)) {
            fxl_point crossing = before > 0 ? fxl_split_edge(from, to, before, distance)
                                            : fxl_split_edge(to, from, distance, before);
            if (!split_append_point(&crossing, 0, front, back)) {
                return SPLIT_CAPACITY;
            }
        }
        if (!split_append_point(to, distance, front, back)) {
            return SPLIT_CAPACITY;
        }
        from = to;
        before = distance;
    }
    return SPLIT_BOTH;
}

#endif
