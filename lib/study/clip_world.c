/* SPDX-License-Identifier: MIT */
#include "../clip/clip_view.h"
#include "../math/plane.h"
#include "../view/outcode.h"

#include "../clip/cut_polygon.h"
#include "../math/arith.h"
#include "clip_world.h"

/* inside / (inside - outside), rounded downward; requires inside >= 0 > outside. The difference
 * of two distances from one plane is the plane's normal times the difference of two points, so
 * it is below 2^61. Both terms are cut to the 32 highest bits of the difference, which errs by
 * at most two units. */
/* clippers 7.4 */
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
    return fxl_divide_u64(part << 31, (uint32_t)whole, &rest);
}

/* from + (to - from) * fraction, rounded once. |to - from| is below 2^31, so
 * the product is below 2^62; the result lies between from and to. */
/* accuracy 1.2 */
static fxl_q16_16 interpolate(fxl_q16_16 from, fxl_q16_16 to, fxl_q1_31 fraction)
{
    int64_t extent = (int64_t)to - from;
    return (fxl_q16_16)(from + fxl_round_shift(fxl_multiply_s64(extent, fraction), 31));
}

static inline void copy(const fxl_cut *cut, uint32_t from, uint32_t to)
{
    const fxl_polygon *in = (const fxl_polygon *)cut->in;
    fxl_polygon *out = (fxl_polygon *)cut->out;
    out->vertices[to] = in->vertices[from];
}

/* clippers 7.4 */
static inline void cross(const fxl_cut *cut, uint32_t inside, uint32_t outside, uint32_t to)
{
    const fxl_polygon *in = (const fxl_polygon *)cut->in;
    const fxl_vertex *a = &in->vertices[inside], *b = &in->vertices[outside];
    fxl_vertex *vertex = &((fxl_polygon *)cut->out)->vertices[to];
    fxl_q1_31 fraction = intersection_fraction(cut->distances[inside], cut->distances[outside]);
    vertex->position.x = interpolate(a->position.x, b->position.x, fraction);
    vertex->position.y = interpolate(a->position.y, b->position.y, fraction);
    vertex->position.z = interpolate(a->position.z, b->position.z, fraction);
    vertex->u = in->textured ? interpolate(a->u, b->u, fraction) : 0;
    vertex->v = in->textured ? interpolate(a->v, b->v, fraction) : 0;
}

fxl_clip_result fxl_clip_world_to_plane(const fxl_polygon *in, const fxl_plane *plane,
                                        fxl_polygon *out, fxl_q18_46 *distances)
{
    FXL_ASSERT(in != out && in->count >= 3 && in->count <= FXL_POLYGON_CAPACITY);
    uint32_t bits = 0;
    for (uint32_t i = 0; i < in->count; i++) {
        distances[i] = fxl_plane_distance(plane, &in->vertices[i].position);
        bits |= fxl_cut_bit(distances[i], i);
    }
    fxl_cut cut = {in, out, distances, 0};
    fxl_clip_result result = fxl_cut_polygon(&cut, copy, cross, bits, in->count);
    if (result == FXL_CLIP_CUT) {
        out->colour = in->colour;
        out->textured = in->textured;
        out->count = (uint8_t)cut.count;
    }
    return result;
}

typedef struct {
    const fxl_frustum *frustum;
    fxl_clip_world_work *work;
    fxl_clip_stats *stats;
} clipping;

static inline fxl_clip_result by_plane(const void *with, int plane, const void *current, void *out)
{
    const clipping *to = (const clipping *)with;
    fxl_q18_46 *distances = to->work->distances;
    const fxl_polygon *in = (const fxl_polygon *)current;
    fxl_polygon *left = (fxl_polygon *)out;
    fxl_clip_result cut = fxl_clip_world_to_plane(in, &to->frustum->planes[plane], left, distances);
    fxl_clip_stats_add(to->stats, distances, in->count, cut == FXL_CLIP_CUT ? left->count : 0);
    return cut;
}

fxl_clip_result fxl_clip_world_by_planes(const fxl_polygon *in, const fxl_frustum *frustum,
                                         unsigned planes, unsigned then, fxl_clip_world_work *work,
                                         fxl_clip_stats *stats, const fxl_polygon **result)
{
    const clipping to = {frustum, work, stats};
    const void *left;
    fxl_clip_result cut = fxl_cut_by_planes(in, work->polygons, sizeof work->polygons[0], planes,
                                            then, by_plane, &to, &left);
    *result = (const fxl_polygon *)left;
    return cut;
}

fxl_clip_result fxl_clip_world_to_planes(const fxl_polygon *in, const fxl_frustum *frustum,
                                         fxl_planes planes, fxl_clip_world_work *work,
                                         const fxl_polygon **result)
{
    FXL_ASSERT((planes & ~(unsigned)FXL_PLANES_ALL) == 0);
    return fxl_clip_world_by_planes(in, frustum, planes, planes, work, NULL, result);
}
