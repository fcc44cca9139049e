/* SPDX-License-Identifier: MIT */
/* Splitting polygons of the world by planes (docs/extras/clippers.md, section 9), in double. */
#ifndef REF_SPLIT_H
#define REF_SPLIT_H

#include "reference/record.h"

typedef struct {
    int count;
    ref_lattice_point points[REF_POLYGON_CAPACITY];
} ref_piece;

typedef enum {
    REF_SPLIT_FRONT,   /* nothing is behind the plane */
    REF_SPLIT_BACK,    /* nothing is in front, something is behind */
    REF_SPLIT_BOTH,    /* front and back hold the parts */
    REF_SPLIT_CAPACITY /* a part has more than REF_POLYGON_CAPACITY points: refused */
} ref_split_result;

/* Returns the point of the edge where the distance is 0, in units of 1/65536: rounded to the
 * nearest, halves away from the end in front. */
ref_lattice_point ref_split_edge(const ref_lattice_point *front, const ref_lattice_point *behind,
                                 long double front_distance, long double behind_distance);

/* Returns how far a point lies in front of a plane. Exact where the plane is the library's
 * integers. */
long double ref_split_distance(const ref_plane *plane, const ref_lattice_point *point);

ref_split_result ref_split_piece(const ref_piece *in, const ref_plane *plane, ref_piece *front,
                                 ref_piece *back);

#endif
