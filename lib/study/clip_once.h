/* SPDX-License-Identifier: MIT */
/* Clips a polygon to all planes of the normalised frustum in one pass, without polygons in
 * between. Source: chapter 65 (A11 in docs/seeds.md). */
#ifndef FXL_CLIP_ONCE_H
#define FXL_CLIP_ONCE_H

#include "../clip/volume.h"
#include "normalised.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The memory that the clipper needs beside its input. The caller owns it. Between calls only
 * stats has a meaning. */
typedef struct {
    fxl_clip_stats stats;
    fxl_varying_polygon polygon;
    struct {
        fxl_varying_vertex vertex;
        uint32_t edge; /* number of its first vertex; FXL_POLYGON_CAPACITY: not computed yet */
    } cuts[FXL_PLANE_COUNT][2]; /* where the outline leaves through a plane [0], and enters [1] */
} fxl_clip_once_workspace;

/* Clips a flat, convex polygon of normalised points, edge by edge. Comparisons of fractions
 * decide where an edge enters and leaves the frustum, exactly and without a division. Only there
 * a vertex is computed, and only once. A corner of the frustum that the polygon encloses is
 * found along the lines in which the planes cut the polygon. It costs at most three
 * intersections, or five where near or far cuts that line shorter. Where no corner is enclosed,
 * the clipper computes exactly one intersection for each new vertex.
 * *result is the input itself where nothing was cut, workspace->polygon where something was,
 * null where nothing is left. The input must not be workspace->polygon. The sliver rule uses,
 * for each plane, the vertices of the input.
 * Error of a new vertex on an edge of the input: 1 unit of 2^-46 a coordinate from the edge and
 * 3 from the plane, whatever other planes cut. Error of a corner: twice that. If the polygon is
 * not quite flat, corners differ by as much from those of the clippers that work plane by plane.
 * If it is not convex, the result is some polygon within the frustum; this interface does not
 * define which. */
fxl_clip_result fxl_clip_once(const fxl_varying_polygon *in, const fxl_normalised *frustum,
                              fxl_clip_once_workspace *workspace,
                              const fxl_varying_polygon **result);

#ifdef __cplusplus
}
#endif

#endif
