/* SPDX-License-Identifier: MIT */
/* What the tests of clipping to one plane share, in the view and in the world: cases worked out by
 * hand, and the vertex that neighbours share. */
#ifndef PLANE_CASES_H
#define PLANE_CASES_H

#include "unit.h"

enum {
    PLANE_CASES = 12
};

/* A polygon as whole numbers: how far each vertex is inside the plane, and how far along it. */
typedef struct {
    uint8_t count;
    int numbers[14];
} plane_polygon;

typedef struct {
    const char *name;
    fxl_clip_result result;
    plane_polygon polygon;
    plane_polygon left; /* of FXL_CLIP_CUT */
} plane_case;

extern const plane_case plane_cases[PLANE_CASES];

/* Whether one of the vertices, of so many bytes each, is this one, bit for bit. */
bool plane_has_vertex(const void *vertices, int count, size_t size, const void *vertex);

/* Two polygons that share the edge a-b are cut. The new vertex on that edge must be one and the
 * same. outs: their vertices. */
void expect_shared_crossing(const void *const outs[2], const int counts[2], size_t size,
                            const void *a, const void *b, bool a_is_inside);

/* The same of polygons, two of them, and vertices of any type. */
#define EXPECT_SHARED_CROSSING(outs, a, b, a_is_inside) \
    expect_shared_crossing((const void *const[]){(outs)[0].vertices, (outs)[1].vertices}, \
                           (const int[]){(outs)[0].count, (outs)[1].count}, sizeof(a), &(a), &(b), \
                           (a_is_inside))

/* A cut that leaves so many vertices is refused beyond the capacity; else the polygon has them. */
void expect_capacity(fxl_clip_result result, int left, int count);

#endif
