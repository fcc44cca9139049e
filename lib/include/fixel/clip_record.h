/* SPDX-License-Identifier: MIT */
/* The records of the family of clippers (SPEC.md, chapter 6b): a polygon whose
 * vertices carry numbers of any meaning along. */
#ifndef FXL_CLIP_RECORD_H
#define FXL_CLIP_RECORD_H

#include "fixel/clip.h"

/* How many numbers a vertex may carry: texture coordinates, colours, light. */
#define FXL_CARRIED_MAX 6

/* What rides along is within 16383 either way, and is cut by the same fraction
 * as the position. */
typedef struct {
    fxl_view_point position; /* each below 2^61 */
    fxl_q16_16 carried[FXL_CARRIED_MAX];
} fxl_clip_vertex;

typedef struct {
    uint8_t colour;
    uint8_t count;   /* 3..FXL_POLYGON_CAPACITY */
    uint8_t carried; /* of a vertex's numbers, those that are used: 0..FXL_CARRIED_MAX */
    fxl_clip_vertex vertices[FXL_POLYGON_CAPACITY];
} fxl_clip_polygon;

/* How a clipper goes about it, and what it counts. */
typedef struct {
    /* The sliver rule: a vertex less than this far inside a plane counts as
     * outside where the vertex before it does; 0 leaves the rule out. In the
     * unit of the plane's distances, below 2^62. Neighbours that share an edge
     * may then part by as much. */
    fxl_q18_46 sliver;
    uint32_t intersections; /* crossings worked out since the caller set it to 0 */
    uint32_t distances;     /* distances worked out by products since then, codes' included */
} fxl_clip_account;

/* What a clipper needs beside its input. The caller owns it; of its contents
 * only the account means anything between calls. */
typedef struct {
    fxl_clip_account account;
    fxl_clip_polygon polygons[2];
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
} fxl_clip_room;

#endif
