/* SPDX-License-Identifier: MIT */
#include "../clip/cut_polygon.h"
#include "../clip/volume.h"
#include "../math/arith.h"
#include "clip_polygon.h"

/* By the sliver rule, whether a vertex is inside depends on the vertex before it, all the way
 * round. So the loop starts after a vertex that the rule cannot change: one that is outside, or
 * inside by at least the sliver. Where there is none, all vertices are barely inside and none
 * follows one that is outside. */
/* clippers 3.3 */
uint32_t fxl_inside_bits(const fxl_q18_46 *distances, uint32_t count, fxl_q18_46 sliver)
{
    uint32_t bits = 0, start = 0, at;
    for (uint32_t i = 0; i < count; i++) {
        bits |= (uint32_t)(distances[i] >= 0) << i;
    }
    if (sliver == 0) {
        return bits;
    }
    while (distances[start] >= 0 && distances[start] < sliver) {
        if (++start == count) {
            return bits;
        }
    }
    for (uint32_t before = start; (at = before + 1 == count ? 0 : before + 1) != start;
         before = at) {
        if (distances[at] < sliver && (bits >> before & 1u) == 0) {
            bits &= ~((uint32_t)1 << at);
        }
    }
    return bits;
}

/* A cut whose crossings are counted. */
typedef struct {
    fxl_cut cut;
    fxl_clip_stats *stats;
} counted_cut;

static inline void copy(const fxl_cut *cut, uint32_t from, uint32_t to)
{
    const fxl_varying_polygon *in = (const fxl_varying_polygon *)cut->in;
    fxl_varying_polygon *out = (fxl_varying_polygon *)cut->out;
    fxl_copy_vertex(&in->vertices[from], in->carried, &out->vertices[to]);
}

/* An end that counts as outside by the sliver rule alone stands for the intersection. */
static inline void cross(const fxl_cut *cut, uint32_t inside, uint32_t outside, uint32_t to)
{
    const fxl_varying_polygon *in = (const fxl_varying_polygon *)cut->in;
    fxl_varying_polygon *out = (fxl_varying_polygon *)cut->out;
    const fxl_q18_46 *distances = cut->distances;
    if (distances[outside] >= 0) {
        copy(cut, outside, to);
        return;
    }
    ((const counted_cut *)cut)->stats->intersections += 1;
    fxl_intersection_vertex(&in->vertices[inside], &in->vertices[outside],
                            fxl_intersection_fraction(distances[inside], distances[outside]),
                            in->carried, &out->vertices[to]);
}

fxl_clip_result fxl_clip_polygon(const fxl_varying_polygon *in, const fxl_q18_46 *distances,
                                 fxl_clip_stats *stats, fxl_varying_polygon *out)
{
    FXL_ASSERT(in != out && in->count >= 3 && in->count <= FXL_POLYGON_CAPACITY);
    uint32_t bits = fxl_inside_bits(distances, in->count, stats->sliver);
    counted_cut counted = {{in, out, distances, 0}, stats};
    fxl_clip_result result = fxl_cut_polygon(&counted.cut, copy, cross, bits, in->count);
    if (result == FXL_CLIP_CUT) {
        out->colour = in->colour;
        out->carried = in->carried;
        out->count = (uint8_t)counted.cut.count;
    }
    return result;
}

typedef struct {
    fxl_measure measure;
    const void *planes;
    fxl_clip_workspace *workspace;
} clipping;

static inline fxl_clip_result by_plane(const void *with, int plane, const void *in, void *out)
{
    const clipping *by = (const clipping *)with;
    fxl_clip_workspace *workspace = by->workspace;
    by->measure(by->planes, plane, (const fxl_varying_polygon *)in, &workspace->stats,
                workspace->distances);
    return fxl_clip_polygon((const fxl_varying_polygon *)in, workspace->distances,
                            &workspace->stats, (fxl_varying_polygon *)out);
}

fxl_clip_result fxl_clip_polygon_by_planes(const fxl_varying_polygon *in, uint32_t any,
                                           uint32_t all, fxl_measure measure, const void *planes,
                                           fxl_clip_workspace *workspace,
                                           const fxl_varying_polygon **result)
{
    *result = NULL;
    if (all != 0) {
        return FXL_CLIP_OUTSIDE;
    }
    const clipping by = {measure, planes, workspace};
    const void *left;
    fxl_clip_result cut = fxl_cut_by_planes(in, workspace->polygons, sizeof workspace->polygons[0],
                                            any, 0, by_plane, &by, &left);
    *result = (const fxl_varying_polygon *)left;
    return cut;
}
