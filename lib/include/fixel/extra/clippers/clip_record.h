/* SPDX-License-Identifier: MIT */
/* The records of the family of clippers (docs/extras/clippers.md): a polygon whose
 * vertices carry numbers of any meaning along. */
#ifndef FXL_CLIP_RECORD_H
#define FXL_CLIP_RECORD_H

#include "fixel/extra/clippers/clip_world.h"

/* How many numbers a vertex may carry: texture coordinates, colours, light. */
#define FXL_CARRIED_MAX 6

/* What rides along is within 16383 either way, and is cut by the same fraction
 * as the position. */
typedef struct {
    fxl_view_point position; /* each below 2^61 */
    fxl_q16_16 carried[FXL_CARRIED_MAX];
} fxl_varying_vertex;

typedef struct {
    uint8_t colour;
    uint8_t count;   /* 3..FXL_POLYGON_CAPACITY */
    uint8_t carried; /* of a vertex's numbers, those that are used: 0..FXL_CARRIED_MAX */
    fxl_varying_vertex vertices[FXL_POLYGON_CAPACITY];
} fxl_varying_polygon;

/* What a clipper needs beside its input. The caller owns it; of its contents
 * only the account means anything between calls. */
typedef struct {
    fxl_clip_stats stats;
    fxl_varying_polygon polygons[2];
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
} fxl_clip_workspace;

#endif
