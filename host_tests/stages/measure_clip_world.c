/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "reference/clip.h"
#include "reference/frustum.h"
#include "stages/bridge.h"
#include "stages/measure.h"
#include "study/clip_world.h"

enum {
    FROM_EDGE,
    FROM_PLANE,
    TEXTURE
};

/* The library's results have the order of the reference renderer's. */
_Static_assert((int)FXL_CLIP_INSIDE == (int)REF_CLIP_INSIDE &&
                   (int)FXL_CLIP_CUT == (int)REF_CLIP_CUT &&
                   (int)FXL_CLIP_OUTSIDE == (int)REF_CLIP_OUTSIDE &&
                   (int)FXL_CLIP_DEGENERATE == (int)REF_CLIP_DEGENERATE &&
                   (int)FXL_CLIP_CAPACITY == (int)REF_CLIP_CAPACITY,
               "outcomes of clipping");

stages_tally stages_clip_world_tally(const char *input)
{
    return (stages_tally){
        .stage = "clip_world",
        .input = input,
        .unit = "1/65536 world unit",
        .measure =
            "clipping in the world: largest coordinate difference of a vertex that one plane made "
            "from the reference's, "
            "both given the same polygon and plane; max_from_edge and max_from_plane are "
            "its distances from the exact edge and plane",
        .bound = "0.51 a coordinate from the edge; edge length / 2^29 + 0.9 from the plane",
        .extra_names = {"max_from_edge", "max_from_plane", "max_texture"},
    };
}

static double distance_from_line(const ref_point *p, const ref_point *a, const ref_point *b,
                                 double *edge_length)
{
    ref_point d = {b->x - a->x, b->y - a->y, b->z - a->z};
    ref_point w = {p->x - a->x, p->y - a->y, p->z - a->z};
    ref_point cross = {w.y * d.z - w.z * d.y, w.z * d.x - w.x * d.z, w.x * d.y - w.y * d.x};
    *edge_length = hypot(hypot(d.x, d.y), d.z);
    return hypot(hypot(cross.x, cross.y), cross.z) / *edge_length;
}

static void compare_vertex(stages_tally *tally, const ref_plane *plane, const ref_vertex *fixed,
                           const ref_vertex *exact, const ref_vertex *a, const ref_vertex *b)
{
    const ref_point *p = &fixed->position, *e = &exact->position;
    double difference =
        REF_ONE * fmax(fabs(p->x - e->x), fmax(fabs(p->y - e->y), fabs(p->z - e->z)));
    double length;
    double from_edge = REF_ONE * distance_from_line(p, &a->position, &b->position, &length);
    double from_plane = REF_ONE * fabs((double)ref_plane_distance(plane, p));
    /* 0.51 a coordinate is sqrt(3) times as much in space; 1e-6 covers the roundings of this
     * check in double. */
    int within =
        from_edge <= 0.51 * sqrt(3) + 1e-6 && from_plane <= REF_ONE * length * 0x1p-29 + 0.9 + 1e-6;
    stages_count(tally, difference, within);
    stages_extra(tally, FROM_EDGE, from_edge);
    stages_extra(tally, FROM_PLANE, from_plane);
    stages_extra(tally, TEXTURE,
                 REF_ONE * fmax(fabs(fixed->u - exact->u), fabs(fixed->v - exact->v)));
}

/* Follows the edges of the input as SPEC.md, section 4.7, does, to find which vertices of the
 * result are new and on which edge they lie. */
static void compare_cut(stages_tally *tally, const ref_plane *plane, const ref_polygon *in,
                        const ref_polygon *fixed, const ref_polygon *exact)
{
    if (fixed->count != exact->count) {
        tally->mismatched++;
        return;
    }
    int at = 0;
    for (int i = 0; i < in->count; i++) {
        const ref_vertex *a = &in->vertices[i], *b = &in->vertices[(i + 1) % in->count];
        long double da = ref_plane_distance(plane, &a->position);
        long double db = ref_plane_distance(plane, &b->position);
        if (da >= 0) {
            const ref_point *p = &fixed->vertices[at].position;
            tally->mismatched +=
                p->x != a->position.x || p->y != a->position.y || p->z != a->position.z;
            at++;
        }
        if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
            compare_vertex(tally, plane, &fixed->vertices[at], &exact->vertices[at], a, b);
            at++;
        }
    }
    tally->mismatched += at != fixed->count;
}

/* Compares two results of the library, as records of the reference renderer. */
static int same_vertices(const fxl_polygon *a, const fxl_polygon *b)
{
    int same = a->count == b->count && a->colour == b->colour;
    for (int i = 0; same && i < a->count; i++) {
        const fxl_vertex *p = &a->vertices[i], *q = &b->vertices[i];
        same = p->position.x == q->position.x && p->position.y == q->position.y &&
               p->position.z == q->position.z && (!a->textured || (p->u == q->u && p->v == q->v));
    }
    return same;
}

/* The library's clip to all six planes must equal its clips to each plane in turn. */
static void compare_whole(stages_tally *tally, const fxl_frustum *frustum, const fxl_polygon *in,
                          fxl_clip_result expected, const fxl_polygon *left)
{
    static fxl_clip_world_work work;
    const fxl_polygon *result;
    fxl_clip_result whole = fxl_clip_world_to_frustum(in, frustum, &work, &result);
    int same = whole == expected && (result != NULL) == (left != NULL) &&
               (!left || same_vertices(result, left));
    tally->mismatched += !same;
}

int stages_measure_clip_world(stages_tally *tally, const fxl_frustum *frustum, fxl_polygon *polygon)
{
    fxl_clip_result all = FXL_CLIP_INSIDE;
    fxl_polygon original = *polygon;
    for (int i = 0; i < FXL_PLANE_COUNT; i++) {
        const fxl_plane *plane = &frustum->planes[i];
        fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
        fxl_polygon cut;
        fxl_clip_result result = fxl_clip_world_to_plane(polygon, plane, &cut, distances);

        ref_polygon in = bridge_polygon(polygon), exact;
        ref_plane exact_plane = bridge_plane(plane);
        ref_clip_result exact_result = ref_clip_world_to_plane(&in, &exact_plane, &exact);
        tally->mismatched += (int)result != (int)exact_result;

        if (result == FXL_CLIP_CUT && exact_result == REF_CLIP_CUT) {
            ref_polygon fixed = bridge_polygon(&cut);
            compare_cut(tally, &exact_plane, &in, &fixed, &exact);
        }
        if (result == FXL_CLIP_CUT) {
            *polygon = cut;
            all = FXL_CLIP_CUT;
        } else if (result != FXL_CLIP_INSIDE) {
            compare_whole(tally, frustum, &original, result, NULL);
            return 0;
        }
    }
    compare_whole(tally, frustum, &original, all, polygon);
    return 1;
}
