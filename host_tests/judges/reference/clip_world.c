/* SPDX-License-Identifier: MIT */
#include "reference/clip_world.h"

#include "reference/plane.h"

static double between(double inside, double outside, double t)
{
    return inside + t * (outside - inside);
}

/* Computes the intersection from the inside end to the outside end, whatever the direction of
 * the edge: neighbours get the same vertex. */
static ref_vertex intersection(const ref_vertex *inside, const ref_vertex *outside, double t)
{
    return (ref_vertex){
        .position = {between(inside->position.x, outside->position.x, t),
                     between(inside->position.y, outside->position.y, t),
                     between(inside->position.z, outside->position.z, t)},
        .u = between(inside->u, outside->u, t),
        .v = between(inside->v, outside->v, t),
    };
}

/* How far along the edge from the inside end the plane is. */
static double fraction(long double inside, long double outside)
{
    return (double)(inside / (inside - outside));
}

ref_clip_result ref_clip_world_to_plane(const ref_polygon *in, const ref_plane *plane,
                                        ref_polygon *out)
{
    long double distances[REF_POLYGON_CAPACITY];
    int sides[REF_POLYGON_CAPACITY];
    ref_cut cut;
    for (int i = 0; i < in->count; i++) {
        distances[i] = ref_plane_distance(plane, &in->vertices[i].position);
        sides[i] = (distances[i] > 0) - (distances[i] < 0);
    }
    ref_clip_result result = ref_cut_by_sides(sides, in->count, &cut);
    if (result == REF_CLIP_INSIDE) {
        *out = *in;
    }
    if (result != REF_CLIP_CUT) {
        return result;
    }
    out->colour = in->colour;
    out->count = cut.count;
    for (int i = 0; i < cut.count; i++) {
        const ref_cut_vertex *vertex = &cut.vertices[i];
        out->vertices[i] = in->vertices[vertex->inner];
        if (vertex->outer >= 0) {
            out->vertices[i] =
                intersection(&in->vertices[vertex->inner], &in->vertices[vertex->outer],
                             fraction(distances[vertex->inner], distances[vertex->outer]));
        }
    }
    return REF_CLIP_CUT;
}

ref_clip_result ref_clip_world_to_planes(const ref_polygon *in, const ref_frustum *frustum,
                                         unsigned planes, ref_polygon *out)
{
    ref_clip_result result = REF_CLIP_INSIDE;
    ref_polygon before = *in;
    *out = before;
    for (int i = 0; i < REF_PLANE_COUNT; i++) {
        if ((planes >> i & 1) == 0) {
            continue;
        }
        ref_clip_result one = ref_clip_world_to_plane(&before, &frustum->planes[i], out);
        if (one != REF_CLIP_INSIDE && one != REF_CLIP_CUT) {
            return one;
        }
        if (one == REF_CLIP_CUT) {
            result = REF_CLIP_CUT;
        }
        before = *out;
    }
    return result;
}

ref_clip_result ref_clip_world_to_frustum(const ref_polygon *in, const ref_frustum *frustum,
                                          ref_polygon *out)
{
    return ref_clip_world_to_planes(in, frustum, (1u << REF_PLANE_COUNT) - 1, out);
}
