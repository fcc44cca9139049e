/* SPDX-License-Identifier: MIT */

#include "../math/arith.h"
#include "clip_view.h"
#include "cut_polygon.h"
#include "intersection.h"

/* The upper 32 bits. Compilers optimise the unsigned shift away. */
static inline int32_t upper(int64_t value)
{
    return (int32_t)(value >> 32);
}

/* floor((side * across + depth * along) / 2^30), exactly. Requires a unit vector
 * (side, depth), neither below 0, and |across|, |along| < 2^61. With
 * v = 2^32 high + low the sum is
 *   2^32 (side across_high + depth along_high) + (side across_low + depth along_low).
 * The first bracket is below 2^60, the second is below sqrt(2) 2^62 < 2^63, and 2^32 is
 * divisible by 2^30. */
static inline fxl_q18_46 project_onto(fxl_q2_30 side, fxl_q18_46 across, fxl_q2_30 depth,
                                      fxl_q18_46 along)
    FXL_REQUIRES(FXL_SIDE(side, depth) && FXL_BELOW(across, ((int64_t)1 << 61) - 1))
    FXL_REQUIRES(FXL_BELOW(along, ((int64_t)1 << 61) - 1)) FXL_ASSIGNS()
    FXL_EQUATES(FXL_BELOW(FXL_RESULT, ((int64_t)3 << 60)))
{
    int64_t high = fxl_multiply_s32(side, upper(across)) + fxl_multiply_s32(depth, upper(along));
    uint64_t low = fxl_multiply_u32((uint32_t)side, fxl_low_32(fxl_bits_64(across))) +
                   fxl_multiply_u32((uint32_t)depth, fxl_low_32(fxl_bits_64(along)));
    return high * 4 + (int64_t)(low >> 30);
}

/* Distances from near and far are below 2^62, those from a side plane below 2^61 before the inset.
 * For the second plane of a pair, right or top, across is negated. */
fxl_q18_46 fxl_view_distance(const fxl_view_frustum *frustum, int plane,
                             const fxl_view_point *point)
{
    if (plane == FXL_PLANE_NEAR) {
        return point->z - frustum->near_z;
    }
    if (plane == FXL_PLANE_FAR) {
        return frustum->far_z - point->z;
    }
    const bool upright = plane >= FXL_PLANE_BOTTOM;
    const fxl_q18_46 across = upright ? point->y : point->x;
    const bool second = plane == FXL_PLANE_RIGHT || plane == FXL_PLANE_TOP;
    return project_onto(upright ? frustum->y_side : frustum->x_side, second ? -across : across,
                        upright ? frustum->y_depth : frustum->x_depth, point->z) -
           frustum->inset;
}

static inline void copy(const fxl_cut *cut, uint32_t from, uint32_t to)
{
    const fxl_view_polygon *in = (const fxl_view_polygon *)cut->in;
    fxl_view_polygon *out = (fxl_view_polygon *)cut->out;
    fxl_copy_point(&in->vertices[from].position, &out->vertices[to].position);
}

static inline void cross(const fxl_cut *cut, uint32_t inside, uint32_t outside, uint32_t to)
{
    const fxl_view_polygon *in = (const fxl_view_polygon *)cut->in;
    fxl_view_polygon *out = (fxl_view_polygon *)cut->out;
    const fxl_view_point *from = &in->vertices[inside].position;
    const fxl_view_point *end = &in->vertices[outside].position;
    fxl_intersect_edge(from, end, &cut->distances[inside], &cut->distances[outside],
                       &out->vertices[to].position);
}

fxl_clip_result fxl_clip_view_to_plane(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                       int plane, fxl_view_polygon *out, fxl_q18_46 *distances)
{
    FXL_ASSERT(in != out && in->count >= 3 && in->count <= FXL_POLYGON_CAPACITY);
    uint32_t bits = 0;
    for (uint32_t i = 0; i < in->count; i++) {
        distances[i] = fxl_view_distance(frustum, plane, &in->vertices[i].position);
        bits |= fxl_cut_bit(distances[i], i);
    }
    fxl_cut cut = {in, out, distances, 0};
    fxl_clip_result result = fxl_cut_polygon(&cut, copy, cross, bits, in->count);
    if (result == FXL_CLIP_CUT) {
        out->colour = in->colour;
        out->count = (uint8_t)cut.count;
    }
    return result;
}

typedef struct {
    const fxl_view_frustum *frustum;
    fxl_clip_view_work *work;
    fxl_clip_stats *stats;
} clipping;

static inline fxl_clip_result by_plane(const void *with, int plane, const void *current, void *out)
{
    const clipping *to = (const clipping *)with;
    const fxl_view_polygon *in = (const fxl_view_polygon *)current;
    fxl_view_polygon *left = (fxl_view_polygon *)out;
    fxl_clip_result cut = fxl_clip_view_to_plane(in, to->frustum, plane, left, to->work->distances);
    fxl_clip_stats_add(to->stats, to->work->distances, in->count,
                       cut == FXL_CLIP_CUT ? left->count : 0);
    return cut;
}

fxl_clip_result fxl_clip_view_by_planes(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                        fxl_planes planes, fxl_clip_view_work *work,
                                        fxl_clip_stats *stats, const fxl_view_polygon **result)
{
    const clipping to = {frustum, work, stats};
    const void *left;
    fxl_clip_result cut = fxl_cut_by_planes(in, work->polygons, sizeof work->polygons[0], planes, 0,
                                            by_plane, &to, &left);
    *result = (const fxl_view_polygon *)left;
    return cut;
}
