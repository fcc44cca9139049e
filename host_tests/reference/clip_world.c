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

ref_clip_result ref_clip_world_to_plane(const ref_polygon *in, const ref_plane *plane,
                                        ref_polygon *out)
{
    long double distances[REF_POLYGON_CAPACITY];
    int inside_count = 0;
    for (int i = 0; i < in->count; i++) {
        distances[i] = ref_plane_distance(plane, &in->vertices[i].position);
        inside_count += distances[i] >= 0;
    }
    if (inside_count == 0) {
        return REF_CLIP_OUTSIDE;
    }
    if (inside_count == in->count) {
        *out = *in;
        return REF_CLIP_INSIDE;
    }
    ref_vertex kept[2 * REF_POLYGON_CAPACITY];
    int count = 0;
    for (int i = 0; i < in->count; i++) {
        int next = (i + 1) % in->count;
        bool from_inside = distances[i] >= 0, to_inside = distances[next] >= 0;
        if (from_inside) {
            kept[count++] = in->vertices[i];
        }
        if (from_inside != to_inside) {
            int inner = from_inside ? i : next, outer = from_inside ? next : i;
            long double d0 = distances[inner], d1 = distances[outer];
            if (d0 > 0) { /* at 0 the inside end is the intersection */
                kept[count++] = intersection(&in->vertices[inner], &in->vertices[outer],
                                             (double)(d0 / (d0 - d1)));
            }
        }
    }
    if (count < 3) {
        return REF_CLIP_DEGENERATE;
    }
    if (count > REF_POLYGON_CAPACITY) {
        return REF_CLIP_CAPACITY;
    }
    out->colour = in->colour;
    out->count = count;
    for (int i = 0; i < count; i++) {
        out->vertices[i] = kept[i];
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
