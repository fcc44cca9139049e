/* SPDX-License-Identifier: MIT */
#include "../../src/math/arith.h"
#include "intersection.h"

FXL_STATIC_ASSERT(FXL_POLYGON_CAPACITY <= 32, "a bit a vertex");

/* By the sliver rule whether a vertex is inside depends
 * on the vertex before, all the way round: the walk begins after a vertex that
 * is outside, or inside by more than the rule minds; where there is none, all
 * are barely inside, and none of them after one that is out. */
uint32_t fxl_inside_bits(const fxl_q18_46 *distances, uint32_t count, fxl_q18_46 sliver)
{
    uint32_t bits = 0, start = 0;
    for (uint32_t i = 0; i < count; i++) {
        bits |= (uint32_t)(distances[i] >= 0) << i;
    }
    while (start < count && distances[start] >= 0 && distances[start] < sliver) {
        start++;
    }
    if (sliver == 0 || start == count) {
        return bits;
    }
    uint32_t before = start;
    for (uint32_t left = count - 1; left > 0; left--) {
        uint32_t at = before + 1 == count ? 0 : before + 1;
        if (distances[at] < sliver && (bits >> before & 1u) == 0) { /* bug: sliver-alone */
            bits &= ~((uint32_t)1 << at);
        }
        before = at;
    }
    return bits;
}

typedef struct {
    const fxl_varying_polygon *in;
    const fxl_q18_46 *distances;
    fxl_varying_polygon *out;
    uint32_t count; /* of out, so far */
} cutting;

/* Room for one more vertex; null when the polygon is full. */
static fxl_varying_vertex *append(cutting *cut)
{
    if (cut->count == FXL_POLYGON_CAPACITY) {
        return NULL;
    }
    return &cut->out->vertices[cut->count++];
}

static bool append_copy(cutting *cut, uint32_t which)
{
    fxl_varying_vertex *vertex = append(cut);
    if (vertex == NULL) {
        return false;
    }
    fxl_copy_vertex(&cut->in->vertices[which], cut->in->carried, vertex);
    return true;
}

/* Emits the crossing between a vertex that counts as inside and one that does
 * not. An inside end on the plane is that crossing already; one that only counts
 * as outside stands for it. */
static bool append_crossing(cutting *cut, uint32_t inside, uint32_t outside, fxl_clip_stats *stats)
{
    const fxl_q18_46 *distances = cut->distances;
    if (distances[inside] == 0) {
        return true;
    }
    if (distances[outside] >= 0) {
        return append_copy(cut, outside);
    }
    fxl_varying_vertex *vertex = append(cut);
    if (vertex == NULL) {
        return false;
    }
    stats->intersections += 1;
    fxl_intersection_vertex(&cut->in->vertices[inside], &cut->in->vertices[outside],
                            fxl_intersection_fraction(distances[inside], distances[outside]),
                            cut->in->carried, vertex);
    return true;
}

fxl_clip_result fxl_clip_polygon(const fxl_varying_polygon *in, const fxl_q18_46 *distances,
                                 fxl_clip_stats *stats, fxl_varying_polygon *out)
{
    FXL_ASSERT(in != out && in->count >= 3 && in->count <= FXL_POLYGON_CAPACITY);
    uint32_t bits = fxl_inside_bits(distances, in->count, stats->sliver);
    if (bits == UINT32_MAX >> (32u - in->count)) {
        return FXL_CLIP_INSIDE;
    }
    if (bits == 0) {
        return FXL_CLIP_OUTSIDE;
    }
    cutting cut = {in, distances, out, 0};
    for (uint32_t current = 0; current < in->count; current++) {
        uint32_t next = current + 1 == in->count ? 0 : current + 1;
        bool from = (bits >> current & 1u) != 0, to = (bits >> next & 1u) != 0;
        if ((from && !append_copy(&cut, current)) ||
            (from && !to && !append_crossing(&cut, current, next, stats)) ||
            (!from && to && !append_crossing(&cut, next, current, stats))) {
            return FXL_CLIP_CAPACITY;
        }
    }
    if (cut.count < 3) {
        return FXL_CLIP_DEGENERATE;
    }
    out->colour = in->colour;
    out->carried = in->carried;
    out->count = (uint8_t)cut.count;
    return FXL_CLIP_CUT;
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
    const fxl_varying_polygon *current = in;
    uint32_t spare = in == &workspace->polygons[0] ? 1 : 0;
    fxl_clip_result so_far = FXL_CLIP_INSIDE;
    for (int plane = 0; any >> plane != 0; plane++) {
        if ((any >> plane & 1u) == 0) {
            continue;
        }
        fxl_varying_polygon *out = &workspace->polygons[spare];
        measure(planes, plane, current, &workspace->stats, workspace->distances);
        fxl_clip_result cut =
            fxl_clip_polygon(current, workspace->distances, &workspace->stats, out);
        if (cut == FXL_CLIP_CUT) {
            current = out;
            spare ^= 1u;
            so_far = FXL_CLIP_CUT;
        } else if (cut != FXL_CLIP_INSIDE) {
            return cut;
        }
    }
    *result = current;
    return so_far;
}
