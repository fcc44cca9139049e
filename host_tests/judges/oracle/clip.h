/* SPDX-License-Identifier: MIT */
/* Clipping and projection in exact rational arithmetic (SPEC.md, sections 4.7 and 4.8):
 * Sutherland-Hodgman in the view on homogeneous big integers, with the planes that the integers
 * of the space define. Nothing is rounded until the result is written at 2^-48 pixel. */
#ifndef ORACLE_CLIP_H
#define ORACLE_CLIP_H

#include "oracle/cover.h"
#include "oracle/space.h"

enum {
    ORACLE_OUTLINE_MAX = 64,
    ORACLE_SPOT_BITS = 32 /* below 1/65536 pixel */
};

typedef struct {
    int count;                             /* 0 where fewer than three vertices are left */
    oracle_spot spots[ORACLE_OUTLINE_MAX]; /* in units of 2^-48 pixel, rounded down */
    int origins[ORACLE_OUTLINE_MAX]; /* the edge from each spot: the number of the polygon's edge,
                                        or -1 - plane for one that a plane made */
} oracle_outline;

void oracle_clip(const oracle_space *space, const fxl_polygon *polygon, oracle_outline *outline);

#endif
