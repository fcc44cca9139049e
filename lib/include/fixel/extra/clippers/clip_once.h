/* SPDX-License-Identifier: MIT */
/* Clipping to all planes of the normalised frustum at once, without polygons in
 * between. Source: chapter 65 (A11 in docs/seeds.md). */
#ifndef FXL_CLIP_ONCE_H
#define FXL_CLIP_ONCE_H

#include "fixel/extra/clippers/normalised.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What the clipper needs beside its input. The caller owns it; of its contents only
 * the account means anything between calls. */
typedef struct {
    fxl_clip_stats stats;
    fxl_varying_polygon polygon;
    struct {
        fxl_varying_vertex vertex;
        uint32_t edge;          /* by its first vertex; FXL_POLYGON_CAPACITY: not worked out yet */
    } cuts[FXL_PLANE_COUNT][2]; /* where the outline goes out through a plane, and in */
} fxl_clip_once_workspace;

/* Clips a flat, convex polygon of normalised points, edge by edge: where an edge
 * enters and leaves the frustum is decided by comparing fractions, exactly and
 * without a division; only there a vertex is worked out, and only once. Corners of
 * the frustum that the polygon encloses are found along its cuts by the planes, at
 * three intersections a corner or less, but five where near or far hides the cut. So
 * where no corner is enclosed, there are as many intersections as new vertices.
 * *result is the input itself where nothing was cut, else room->polygon, which the
 * input must not be; null where nothing is left. The sliver rule holds for each
 * plane by the vertices of the input.
 * Error of a new vertex: on an edge of the input, 1 unit of 2^-46 a coordinate from
 * it and 3 from the plane, whatever other planes cut; a corner, as much again. Where
 * the polygon is not quite flat, corners are as far from those of the clippers that
 * go plane by plane. Of a polygon that is not convex it gives a polygon within the
 * frustum, but which is not said. */
fxl_clip_result fxl_clip_once(const fxl_varying_polygon *in, const fxl_normalised *frustum,
                              fxl_clip_once_workspace *workspace,
                              const fxl_varying_polygon **result);

#ifdef __cplusplus
}
#endif

#endif
