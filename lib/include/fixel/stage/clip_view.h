/* SPDX-License-Identifier: MIT */
/* Clipping in the view, plane by plane, on exact sums: the precise way. */
#ifndef FXL_CLIP_VIEW_H
#define FXL_CLIP_VIEW_H

#include "fixel/stage/outcode.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What the clipper needs beside its input. The caller owns it; its contents
 * mean nothing between calls. */
typedef struct {
    fxl_view_polygon polygons[2];
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
} fxl_clip_view_work;

/* How far a point lies inside one of the frustum's planes (FXL_PLANE_...), in
 * units of 2^-46, rounded downward. Exact but for that rounding, so its sign
 * cannot err. Requires |x|, |y|, |z| < 2^61. */
fxl_q18_46 fxl_view_distance(const fxl_view_frustum *frustum, int plane,
                             const fxl_view_point *point);

/* Clips a polygon of the view to one plane; the rules, and what is written
 * when, are those of fxl_clip_world_to_plane.
 * Requires 3 <= in->count <= FXL_POLYGON_CAPACITY, |x|, |y|, |z| < 2^61.
 * Error of a new vertex: at most 1 unit of 2^-46 in each coordinate from a
 * point of the edge, 3 units from the plane; 2^-38 of its depth at the nearest
 * near plane, which no screen shows. */
fxl_clip_result fxl_clip_view_to_plane(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                       int plane, fxl_view_polygon *out, fxl_q18_46 *distances);

/* Clips a polygon of the view to some of the planes, in the order of their
 * numbers. *result points to the input itself where no plane cut it, else into
 * work; null where nothing is left. The input may be either polygon of work, and
 * is then lost where a plane cuts it. Where the input lies inside all other
 * planes, so does the result, to within 1 unit of 2^-46 a coordinate. */
fxl_clip_result fxl_clip_view_to_planes(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                        fxl_planes planes, fxl_clip_view_work *work,
                                        const fxl_view_polygon **result);

#ifdef __cplusplus
}
#endif

#endif
