/* SPDX-License-Identifier: MIT */
/* What a plane leaves of a polygon, given only on which side each vertex lies. */
#ifndef REF_CUT_H
#define REF_CUT_H

#include "reference/record.h"

typedef enum {
    REF_CLIP_INSIDE,     /* wholly inside: out is a copy */
    REF_CLIP_CUT,        /* out is what is left */
    REF_CLIP_OUTSIDE,    /* no vertex inside */
    REF_CLIP_DEGENERATE, /* fewer than three vertices left */
    REF_CLIP_CAPACITY    /* more than REF_POLYGON_CAPACITY: refused */
} ref_clip_result;

/* A vertex that is left: the polygon's vertex number inner, where outer is negative; else the
 * intersection of the edge from inner, which is inside, to outer. */
typedef struct {
    int inner, outer;
} ref_cut_vertex;

typedef struct {
    ref_cut_vertex vertices[REF_POLYGON_CAPACITY];
    int count;
} ref_cut;

/* sides: 1 inside, 0 in the plane, -1 outside. The cut is valid where REF_CLIP_CUT is returned. */
ref_clip_result ref_cut_by_sides(const int *sides, int count, ref_cut *cut);

#endif
