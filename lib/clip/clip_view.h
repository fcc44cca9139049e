/* SPDX-License-Identifier: MIT */
/* Clipping in the view, plane by plane, on exact sums. Internal. */
#ifndef FXL_CLIP_VIEW_H
#define FXL_CLIP_VIEW_H

#include "../math/arith.h"
#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The distance of a point from one of the frustum's planes (FXL_PLANE_...), in units
 * of 2^-46 world unit, rounded downward; negative outside.
 * Requires |x|, |y|, |z| < 2^61 units.
 * Error: only that rounding, less than 1 unit, so the sign is exact. Source: A12. */
/* What fxl_view_frustum_from_lens makes, for contracts: of two numbers whose squares have the sum 1
 * the sum is below 3/2. */
#define FXL_SIDE(side, depth) \
    ((side) >= 0 && (side) <= FXL_Q2_30_ONE && (depth) >= 0 && (depth) <= FXL_Q2_30_ONE && \
     (int64_t)(side) + (depth) <= (int64_t)3 << 29)
#define FXL_FRUSTUM(f) \
    (FXL_SIDE((f)->x_side, (f)->x_depth) && FXL_SIDE((f)->y_side, (f)->y_depth) && \
     (f)->near_z >= 0 && (f)->near_z < (int64_t)1 << 61 && (f)->far_z >= 0 && \
     (f)->far_z < (int64_t)1 << 61 && (f)->inset >= 0 && (f)->inset <= (int64_t)1 << 46)
fxl_q18_46 fxl_view_distance(const fxl_view_frustum *frustum, int plane,
                             const fxl_view_point *point)
    FXL_REQUIRES(FXL_OBJECT(frustum) && FXL_OBJECT(point) && plane >= 0 && plane < FXL_PLANE_COUNT)
    FXL_REQUIRES(FXL_FRUSTUM(frustum) && FXL_POINT_BELOW(point, ((int64_t)1 << 61) - 1))
    FXL_ASSIGNS() FXL_ENSURES(FXL_BELOW(FXL_RESULT, ((int64_t)1 << 62) - 1));

/* Clips a polygon of the view to one plane. A vertex is inside if its distance is >= 0.
 * Each intersection is computed from the inside end of the edge towards the outside
 * end, so two polygons that share the edge get the same bits. A vertex exactly on the
 * plane is not repeated. distances becomes the distances of in's vertices.
 * *out is written only for FXL_CLIP_CUT and FXL_CLIP_DEGENERATE, and up to the capacity
 * for FXL_CLIP_CAPACITY. Its colour and count are set only for FXL_CLIP_CUT.
 * Requires 3 <= in->count <= FXL_POLYGON_CAPACITY, |x|, |y|, |z| < 2^61 units,
 * out != in, and FXL_POLYGON_CAPACITY elements at distances.
 * Error of a new vertex: at most 1 unit of 2^-46 in each coordinate from a point of
 * the edge, and 3 units from the plane. At the nearest near plane that is 2^-38 of its
 * depth, which no screen shows. Source: A2, A12, C8. */
fxl_clip_result fxl_clip_view_to_plane(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                       int plane, fxl_view_polygon *out, fxl_q18_46 *distances);

/* Clips a polygon of the view to some of the planes, in the order of their numbers.
 * *result points to the input itself if no plane cut it, else to a polygon of work. It
 * is null if nothing is left.
 * Requires what fxl_clip_view_to_plane requires of in. in may be a polygon of work; it
 * is then lost if a plane cuts it.
 * Error: that of fxl_clip_view_to_plane for each cut. If the input lies inside all
 * planes that are not given, so does the result, to within 1 unit of 2^-46 a
 * coordinate. The function counts its cuts in stats, which may be null. Source: A10, A12. */
fxl_clip_result fxl_clip_view_by_planes(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                        fxl_planes planes, fxl_clip_view_work *work,
                                        fxl_clip_stats *stats, const fxl_view_polygon **result);

/* Counts one plane. measured is the number of distances, result_count the number of vertices of
 * the result, 0 if the plane did not cut. The intersections are the vertices of the result that
 * are not inside vertices of the input. */
static inline void fxl_clip_stats_add(fxl_clip_stats *stats, const fxl_q18_46 *distances,
                                      uint32_t measured, uint32_t result_count)
{
    if (stats != NULL) {
        stats->distances += measured;
        for (uint32_t i = 0; result_count > 0 && i < measured; i++) {
            result_count -= distances[i] >= 0;
        }
        stats->intersections += result_count;
    }
}

/* Copies a point of the view by its members: for a whole record the compiler may call memcpy,
 * which takes four times the instructions on Armv6-M. */
static inline void fxl_copy_point(const fxl_view_point *from, fxl_view_point *to)
{
    if (FXL_IS_SMALL) {
        *to = *from;
        return;
    }
    to->x = from->x;
    to->y = from->y;
    to->z = from->z;
}

#ifdef __cplusplus
}
#endif

#endif
