/* SPDX-License-Identifier: MIT */
/* The records that the other clippers share (docs/extras/clippers.md): a polygon whose vertices
 * carry varyings. */
#ifndef FXL_CLIP_RECORD_H
#define FXL_CLIP_RECORD_H

#include "fixel/stage/clip_view.h"

/* How many varyings a vertex may carry: texture coordinates, colours, light. */
#define FXL_CARRIED_MAX 6

/* A vertex and its varyings. A varying is within 16383 either way. The clipper cuts it by the
 * same fraction as the position. */
typedef struct {
    fxl_view_point position; /* each below 2^61 */
    fxl_q16_16 carried[FXL_CARRIED_MAX];
} fxl_varying_vertex;

typedef struct {
    uint8_t colour;
    uint8_t count;   /* 3..FXL_POLYGON_CAPACITY */
    uint8_t carried; /* how many varyings of a vertex are used: 0..FXL_CARRIED_MAX */
    fxl_varying_vertex vertices[FXL_POLYGON_CAPACITY];
} fxl_varying_polygon;

/* The memory that a clipper needs beside its input. The caller owns it. Between calls only stats
 * has a meaning. */
typedef struct {
    fxl_clip_stats stats;
    fxl_varying_polygon polygons[2];
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
} fxl_clip_workspace;

#endif
