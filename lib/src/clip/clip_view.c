/* SPDX-License-Identifier: MIT */
#include "fixel/stage/clip_view.h"

#include "../math/arith.h"
#include "clip_stats.h"
#include "../math/divide_wide.h"

/* The upper 32 bits. Compilers optimise the unsigned shift away. */
static inline int32_t upper(int64_t value)
{
    return (int32_t)((uint64_t)value >> 32);
}

/* floor((side * across + depth * along) / 2^30), exactly. Requires a unit vector
 * (side, depth), neither below 0, and |across|, |along| < 2^61. With
 * v = 2^32 high + low the sum is
 *   2^32 (side across_high + depth along_high) + (side across_low + depth along_low).
 * The first bracket is below 2^60, the second is below sqrt(2) 2^62 < 2^63, and 2^32 is
 * divisible by 2^30. */
static inline fxl_q18_46 project_onto(fxl_q2_30 side, fxl_q18_46 across, fxl_q2_30 depth,
                                      fxl_q18_46 along)
{
    int64_t high = fxl_multiply_s32(side, upper(across)) + fxl_multiply_s32(depth, upper(along));
    uint64_t low = fxl_multiply_u32((uint32_t)side, (uint32_t)across) +
                   fxl_multiply_u32((uint32_t)depth, (uint32_t)along);
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

/* floor(2^64 inside / (inside - outside)): the place of the intersection on the edge.
 * Requires inside >= 0 > outside, both below 2^62. */
static uint64_t intersection_fraction(fxl_q18_46 inside, fxl_q18_46 outside)
{
    FXL_ASSERT(inside >= 0 && outside < 0);
    return fxl_fraction((uint64_t)inside, (uint64_t)inside - (uint64_t)outside);
}

/* from + (to - from) fraction / 2^64, rounded towards from. Error: less than one unit.
 * |to - from| is below 2^62. */
static fxl_q18_46 interpolate(fxl_q18_46 from, fxl_q18_46 to, uint64_t fraction)
{
    uint64_t part = fxl_multiply_high(fxl_magnitude(to - from), fraction);
    return to < from ? from - (int64_t)part : from + (int64_t)part;
}

/* The intersection of the plane and the edge from an inside to an outside vertex. It is
 * always computed in this direction, so both polygons of an edge get the same bits. */
static void set_intersection(const fxl_view_point *inside, const fxl_view_point *outside,
                             uint64_t fraction, fxl_view_point *point)
{
    point->x = interpolate(inside->x, outside->x, fraction);
    point->y = interpolate(inside->y, outside->y, fraction);
    point->z = interpolate(inside->z, outside->z, fraction);
}

/* Computes every vertex's distance. Returns the number of vertices that are inside. */
static uint32_t measure(const fxl_view_polygon *polygon, const fxl_view_frustum *frustum, int plane,
                        fxl_q18_46 *distances)
{
    uint32_t inside_count = 0;
    for (uint32_t i = 0; i < polygon->count; i++) {
        distances[i] = fxl_view_distance(frustum, plane, &polygon->vertices[i].position);
        inside_count += distances[i] >= 0;
    }
    return inside_count;
}

/* Appends a vertex. Returns false if the polygon is full. */
static bool append(fxl_view_polygon *polygon, uint32_t *count, const fxl_view_point *point)
{
    if (*count == FXL_POLYGON_CAPACITY) {
        return false;
    }
    polygon->vertices[*count].position = *point;
    *count += 1;
    return true;
}

/* Appends an edge's part of the result: its first vertex if that is inside, then the
 * intersection if one end is inside and the other outside. If the inside end lies on the
 * plane, it is the intersection already. Returns false if the polygon is full. */
static bool append_edge(const fxl_view_polygon *in, const fxl_q18_46 *distances, uint32_t current,
                        uint32_t next, fxl_view_polygon *out, uint32_t *count)
{
    const bool current_inside = distances[current] >= 0;
    const uint32_t inside = current_inside ? current : next;
    const uint32_t outside = current_inside ? next : current;
    const fxl_view_point *from = &in->vertices[inside].position;
    if (current_inside && !append(out, count, from)) {
        return false;
    }
    if (distances[inside] <= 0 || distances[outside] >= 0) {
        return true;
    }
    fxl_view_point intersection;
    set_intersection(from, &in->vertices[outside].position,
                     intersection_fraction(distances[inside], distances[outside]), &intersection);
    return append(out, count, &intersection);
}

fxl_clip_result fxl_clip_view_to_plane(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                       int plane, fxl_view_polygon *out, fxl_q18_46 *distances)
{
    FXL_ASSERT(in != out && in->count >= 3 && in->count <= FXL_POLYGON_CAPACITY);
    uint32_t inside_count = measure(in, frustum, plane, distances);
    if (inside_count == in->count) {
        return FXL_CLIP_INSIDE;
    }
    if (inside_count == 0) {
        return FXL_CLIP_OUTSIDE;
    }
    uint32_t count = 0;
    for (uint32_t current = 0; current < in->count; current++) {
        uint32_t next = current + 1 == in->count ? 0 : current + 1;
        if (!append_edge(in, distances, current, next, out, &count)) {
            return FXL_CLIP_CAPACITY;
        }
    }
    if (count < 3) {
        return FXL_CLIP_DEGENERATE;
    }
    out->colour = in->colour;
    out->count = (uint8_t)count;
    return FXL_CLIP_CUT;
}

fxl_clip_result fxl_clip_view_by_planes(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                        fxl_planes planes, fxl_clip_view_work *work,
                                        fxl_clip_stats *stats, const fxl_view_polygon **result)
{
    const fxl_view_polygon *current = in;
    uint32_t spare = in == &work->polygons[0] ? 1 : 0;
    fxl_clip_result all = FXL_CLIP_INSIDE;
    unsigned left = planes;
    for (int plane = 0; left != 0; plane++, left >>= 1) {
        if ((left & 1) == 0) {
            continue;
        }
        fxl_view_polygon *out = &work->polygons[spare];
        fxl_clip_result cut = fxl_clip_view_to_plane(current, frustum, plane, out, work->distances);
        fxl_clip_stats_add(stats, work->distances, current->count,
                           cut == FXL_CLIP_CUT ? out->count : 0);
        if (cut == FXL_CLIP_CUT) {
            current = out;
            spare ^= 1u;
            all = FXL_CLIP_CUT;
        } else if (cut != FXL_CLIP_INSIDE) {
            *result = NULL;
            return cut;
        }
    }
    *result = current;
    return all; /* bug: cut-twice-whole */
}

fxl_clip_result fxl_clip_view_to_planes(const fxl_view_polygon *in, const fxl_view_frustum *frustum,
                                        fxl_planes planes, fxl_clip_view_work *work,
                                        const fxl_view_polygon **result)
{
    return fxl_clip_view_by_planes(in, frustum, planes, work, NULL, result);
}
