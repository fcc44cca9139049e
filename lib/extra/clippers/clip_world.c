/* SPDX-License-Identifier: MIT */
#include "fixel/extra/clippers/clip_world.h"

#include "../../src/math/arith.h"
#include "clip_world_by_planes.h"
#include "fixel/stage/plane.h"

/* inside / (inside - outside), rounded downward; requires inside >= 0 > outside. The difference
 * of two distances from one plane is the plane's normal times the difference of two points, so
 * it is below 2^61. Both terms are cut to the 32 highest bits of the difference, which errs by
 * at most two units. */
static fxl_q1_31 intersection_fraction(fxl_q18_46 inside, fxl_q18_46 outside)
{
    FXL_ASSERT(inside >= 0 && outside < 0);
    uint64_t part = (uint64_t)inside;
    uint64_t whole = part + fxl_magnitude(outside);
    unsigned bits = fxl_bit_length(whole);
    if (bits > 32) {
        part >>= bits - 32;
        whole >>= bits - 32;
    }
    uint32_t rest;
    return fxl_divide_u64(part << 31, (uint32_t)whole, &rest); /* bug: fraction-27 */
}

/* from + (to - from) * fraction, rounded once. |to - from| is below 2^31, so
 * the product is below 2^62; the result lies between from and to. */
static fxl_q16_16 interpolate(fxl_q16_16 from, fxl_q16_16 to, fxl_q1_31 fraction)
{
    int64_t extent = (int64_t)to - from;
    return (fxl_q16_16)(from + fxl_round_shift(fxl_multiply_s64(extent, fraction), 31));
}

/* Computes the vertex where the edge from an inside to an outside vertex crosses the plane. The
 * direction is always this one, so both polygons that share the edge get the same bits. */
static fxl_vertex intersection_vertex(const fxl_vertex *inside, const fxl_vertex *outside,
                                      fxl_q1_31 fraction, bool textured)
{
    fxl_vertex vertex;
    const fxl_point *from = &inside->position;
    const fxl_point *to = &outside->position;
    vertex.position.x = interpolate(from->x, to->x, fraction);
    vertex.position.y = interpolate(from->y, to->y, fraction);
    vertex.position.z = interpolate(from->z, to->z, fraction);
    vertex.u = textured ? interpolate(inside->u, outside->u, fraction) : 0;
    vertex.v = textured ? interpolate(inside->v, outside->v, fraction) : 0;
    return vertex;
}

/* Computes the distance of every vertex. Returns how many are inside. */
static uint32_t measure(const fxl_polygon *polygon, const fxl_plane *plane, fxl_q18_46 *distances)
{
    uint32_t inside_count = 0;
    for (uint32_t i = 0; i < polygon->count; i++) {
        distances[i] = fxl_plane_distance(plane, &polygon->vertices[i].position);
        inside_count += distances[i] >= 0;
    }
    return inside_count;
}

/* Appends a vertex. Returns false when the polygon is full. */
static bool append(fxl_polygon *polygon, uint32_t *count, const fxl_vertex *vertex)
{
    if (*count == FXL_POLYGON_CAPACITY) {
        return false;
    }
    polygon->vertices[*count] = *vertex;
    *count += 1;
    return true;
}

/* Appends the intersection of an edge of which exactly one vertex is inside. An inside vertex
 * that lies on the plane is already that intersection. */
static bool append_intersection(const fxl_polygon *in, const fxl_q18_46 *distances,
                                uint32_t current, uint32_t next, fxl_polygon *out, uint32_t *count)
{
    uint32_t inside = distances[current] >= 0 ? current : next;
    uint32_t outside = inside == current ? next : current;
    if (distances[inside] == 0) {
        return true;
    }
    fxl_q1_31 fraction = intersection_fraction(distances[inside], distances[outside]);
    fxl_vertex vertex =
        intersection_vertex(&in->vertices[inside], &in->vertices[outside], fraction, in->textured);
    return append(out, count, &vertex);
}

fxl_clip_result fxl_clip_world_to_plane(const fxl_polygon *in, const fxl_plane *plane,
                                        fxl_polygon *out, fxl_q18_46 *distances)
{
    FXL_ASSERT(in != out && in->count >= 3 && in->count <= FXL_POLYGON_CAPACITY);
    uint32_t inside_count = measure(in, plane, distances);
    if (inside_count == in->count) {
        return FXL_CLIP_INSIDE;
    }
    if (inside_count == 0) {
        return FXL_CLIP_OUTSIDE;
    }
    uint32_t count = 0;
    for (uint32_t current = 0; current < in->count; current++) {
        uint32_t next = current + 1 == in->count ? 0 : current + 1;
        bool current_inside = distances[current] >= 0;
        bool next_inside = distances[next] >= 0;
        if (current_inside && !append(out, &count, &in->vertices[current])) {
            return FXL_CLIP_CAPACITY;
        }
        if (current_inside != next_inside &&
            !append_intersection(in, distances, current, next, out, &count)) {
            return FXL_CLIP_CAPACITY;
        }
    }
    if (count < 3) {
        return FXL_CLIP_DEGENERATE;
    }
    out->colour = in->colour;
    out->textured = in->textured;
    out->count = (uint8_t)count;
    return FXL_CLIP_CUT;
}

fxl_clip_result fxl_clip_world_by_planes(const fxl_polygon *in, const fxl_frustum *frustum,
                                         unsigned planes, fxl_clip_world_work *work,
                                         fxl_clip_stats *stats, const fxl_polygon **result)
{
    const fxl_polygon *current = in;
    uint32_t spare = in == &work->polygons[0] ? 1 : 0;
    fxl_clip_result all = FXL_CLIP_INSIDE;
    for (uint32_t i = 0; planes >> i != 0; i++) {
        if ((planes >> i & 1u) == 0) {
            continue;
        }
        fxl_polygon *out = &work->polygons[spare];
        fxl_clip_result cut =
            fxl_clip_world_to_plane(current, &frustum->planes[i], out, work->distances);
        fxl_clip_stats_add(stats, work->distances, current->count,
                           cut == FXL_CLIP_CUT ? out->count : 0);
        if (cut == FXL_CLIP_CUT) {
            current = out;
            spare ^= 1u;
            all = FXL_CLIP_CUT;
            planes = FXL_PLANES_ALL; /* rounding may have put a new vertex outside of any */
        } else if (cut != FXL_CLIP_INSIDE) {
            *result = NULL;
            return cut;
        }
    }
    *result = current;
    return all;
}

fxl_clip_result fxl_clip_world_to_frustum(const fxl_polygon *in, const fxl_frustum *frustum,
                                          fxl_clip_world_work *work, const fxl_polygon **result)
{
    return fxl_clip_world_by_planes(in, frustum, FXL_PLANES_ALL, work, NULL, result);
}
