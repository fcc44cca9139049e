/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "reference/clip.h"
#include "reference/frustum.h"
#include "stages/bridge.h"
#include "stages/measure.h"
#include "study/clip_world.h"

/* After six cuts a vertex may be outside of another plane by less than two units for each cut. */
#define NEEDED_SLACK 16

enum {
    FROM_EDGE,
    FROM_PLANE,
    TEXTURE /* in the world */
};

/* How many units of 2^-46 make 1/65536. */
#define UNITS 0x1p30

const stages_tally stages_clip_tally = {
    .stage = "clip",
    .unit = "1/65536 world unit",
    .measure =
        "clipping in the view: largest coordinate difference of a vertex that one plane "
        "made from the reference's, both given the same polygon and plane; max_from_edge and "
        "max_from_plane are its distances from the exact edge and plane, all in units "
        "of 1/65536 as well",
    .bound = "2^-30 a coordinate from the edge; 3 * 2^-30 from the plane",
    .extra_names = {"max_from_edge", "max_from_plane"},
};

static long double length_of(ref_wide x, ref_wide y, ref_wide z)
{
    return hypotl(hypotl((long double)x, (long double)y), (long double)z);
}

/* Products of 62 by 62 bits: the cross product errs by 2^-113 of itself. */
static long double distance_from_line(const ref_view_point *p, const ref_view_point *a,
                                      const ref_view_point *b)
{
    ref_wide dx = (ref_wide)b->x - a->x, dy = (ref_wide)b->y - a->y, dz = (ref_wide)b->z - a->z;
    ref_wide wx = (ref_wide)p->x - a->x, wy = (ref_wide)p->y - a->y, wz = (ref_wide)p->z - a->z;
    return length_of(wy * dz - wz * dy, wz * dx - wx * dz, wx * dy - wy * dx) /
           length_of(dx, dy, dz);
}

static double largest_difference(const ref_view_point *a, const ref_view_point *b)
{
    return (double)fmaxl(fabsl(a->x - b->x), fmaxl(fabsl(a->y - b->y), fabsl(a->z - b->z)));
}

static void compare_vertex(stages_tally *tally, const ref_view_plane *plane,
                           const ref_view_vertex *fixed, const ref_view_vertex *exact,
                           const ref_view_vertex *a, const ref_view_vertex *b)
{
    const ref_view_point *p = &fixed->position;
    double from_edge = REF_ONE * (double)distance_from_line(p, &a->position, &b->position);
    double from_plane = REF_ONE * fabs((double)ref_view_distance(plane, p));
    /* A unit a coordinate is sqrt(3) in space; 1e-6 covers the roundings of this check. */
    int within = from_edge * UNITS <= sqrt(3) + 1e-6 && from_plane * UNITS <= 3 + 1e-6;
    stages_count(tally, REF_ONE * largest_difference(p, &exact->position), within);
    stages_extra(tally, FROM_EDGE, from_edge);
    stages_extra(tally, FROM_PLANE, from_plane);
}

/* Follows the edges of the input as SPEC.md, section 4.7, does, to find which vertices of the
 * result are new and on which edge they lie. */
static void compare_cut(stages_tally *tally, const ref_view_plane *plane,
                        const ref_view_polygon *in, const ref_view_polygon *fixed,
                        const ref_view_polygon *exact)
{
    if (fixed->count != exact->count) {
        tally->mismatched++;
        return;
    }
    int at = 0;
    for (int i = 0; i < in->count; i++) {
        const ref_view_vertex *a = &in->vertices[i], *b = &in->vertices[(i + 1) % in->count];
        ref_wide da = ref_view_distance(plane, &a->position);
        ref_wide db = ref_view_distance(plane, &b->position);
        if (da >= 0) {
            tally->mismatched +=
                largest_difference(&fixed->vertices[at].position, &a->position) != 0;
            at++;
        }
        if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
            compare_vertex(tally, plane, &fixed->vertices[at], &exact->vertices[at], a, b);
            at++;
        }
    }
    tally->mismatched += at != fixed->count;
}

static int same_vertices(const fxl_view_polygon *a, const fxl_view_polygon *b)
{
    int same = a->count == b->count && a->colour == b->colour;
    for (int i = 0; same && i < a->count; i++) {
        const fxl_view_vertex *p = &a->vertices[i], *q = &b->vertices[i];
        same = p->position.x == q->position.x && p->position.y == q->position.y &&
               p->position.z == q->position.z;
    }
    return same;
}

/* The library's clip to all six planes must equal its clips to each plane in turn. */
static void compare_whole(stages_tally *tally, const fxl_view_frustum *frustum,
                          const fxl_view_polygon *in, fxl_clip_result expected,
                          const fxl_view_polygon *left)
{
    static fxl_clip_view_work work;
    const fxl_view_polygon *result;
    fxl_clip_result whole = fxl_clip_view_by_planes(in, frustum, FXL_PLANES_ALL, &work, NULL, &result);
    int same = whole == expected && (result != NULL) == (left != NULL) &&
               (!left || same_vertices(result, left));
    tally->mismatched += !same;
}

/* The outcodes of a polygon's vertices must be those of the reference renderer. */
static fxl_planes check_outcodes(stages_tally *tally, const fxl_view_frustum *frustum,
                                 const ref_view_frustum *exact, const fxl_view_polygon *polygon)
{
    ref_view_polygon same = bridge_view_polygon(polygon);
    unsigned of_any = 0;
    for (int i = 0; i < polygon->count; i++) {
        fxl_planes outside = fxl_outcode(frustum, FXL_PLANES_ALL, &polygon->vertices[i].position);
        tally->mismatched += outside != ref_outcode(exact, &same.vertices[i].position);
        of_any |= outside;
    }
    return (fxl_planes)of_any;
}

/* Compares the clip by only the needed planes with the clip by all. The results are equal except
 * for the rounding of cuts by planes that had only rounding errors to cut: a few units of 2^-46
 * a plane. If such a plane has made two vertices of one, or has left nothing of a very thin
 * polygon, there is nothing to compare. */
static void compare_needed(stages_tally *tally, const fxl_view_frustum *frustum,
                           const fxl_view_polygon *in, fxl_planes needed,
                           const fxl_view_polygon *left)
{
    static fxl_clip_view_work work;
    const fxl_view_polygon *result;
    fxl_clip_result by_needed = fxl_clip_view_by_planes(in, frustum, needed, &work, NULL, &result);
    tally->mismatched += (by_needed == FXL_CLIP_INSIDE) != (needed == 0);
    for (int i = 0; result && i < result->count; i++) {
        for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
            tally->mismatched +=
                fxl_view_distance(frustum, plane, &result->vertices[i].position) < -NEEDED_SLACK;
        }
    }
    if (!left || !result || left->count != result->count) {
        return;
    }
    for (int i = 0; i < left->count; i++) {
        const fxl_view_point *a = &left->vertices[i].position, *b = &result->vertices[i].position;
        tally->mismatched += llabs(a->x - b->x) > NEEDED_SLACK ||
                             llabs(a->y - b->y) > NEEDED_SLACK || llabs(a->z - b->z) > NEEDED_SLACK;
    }
}

/* Tells whether a vertex lies inside by less than a unit of 2^-46. The library has it on the
 * plane and does not repeat it; the reference renderer makes an intersection right beside it. */
static int within_a_unit(const ref_view_plane *plane, const ref_view_polygon *polygon)
{
    int within = 0;
    for (int i = 0; i < polygon->count; i++) {
        ref_wide distance = ref_view_distance(plane, &polygon->vertices[i].position);
        within |= distance > 0 && distance < 0x1p-46;
    }
    return within;
}

int stages_measure_clip(stages_tally *tally, const fxl_view_frustum *frustum,
                        fxl_view_polygon *polygon)
{
    fxl_clip_result all = FXL_CLIP_INSIDE;
    fxl_view_polygon original = *polygon;
    ref_view_frustum planes = bridge_view_frustum(frustum);
    fxl_planes needed = check_outcodes(tally, frustum, &planes, polygon);
    for (int i = 0; i < FXL_PLANE_COUNT; i++) {
        fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
        fxl_view_polygon cut;
        fxl_clip_result result = fxl_clip_view_to_plane(polygon, frustum, i, &cut, distances);

        ref_view_polygon in = bridge_view_polygon(polygon), exact;
        ref_clip_result exact_result = ref_clip_view_to_plane(&in, &planes.planes[i], &exact);
        if (!within_a_unit(&planes.planes[i], &in)) {
            tally->mismatched += (int)result != (int)exact_result;
            if (result == FXL_CLIP_CUT && exact_result == REF_CLIP_CUT) {
                ref_view_polygon fixed = bridge_view_polygon(&cut);
                compare_cut(tally, &planes.planes[i], &in, &fixed, &exact);
            }
        }
        if (result == FXL_CLIP_CUT) {
            *polygon = cut;
            all = FXL_CLIP_CUT;
        } else if (result != FXL_CLIP_INSIDE) {
            compare_whole(tally, frustum, &original, result, NULL);
            compare_needed(tally, frustum, &original, needed, NULL);
            return 0;
        }
    }
    compare_whole(tally, frustum, &original, all, polygon);
    compare_needed(tally, frustum, &original, needed, polygon);
    return 1;
}

void stages_check_view_frustum(stages_tally *clip, const fxl_lens *lens,
                               const fxl_view_frustum *frustum)
{
    ref_lens exact_lens = bridge_lens(lens);
    ref_view_frustum exact = ref_view_frustum_from_lens(&exact_lens);
    ref_view_frustum fixed = bridge_view_frustum(frustum);
    for (int i = 0; i < REF_PLANE_COUNT; i++) {
        const ref_view_plane *a = &fixed.planes[i], *b = &exact.planes[i];
        clip->mismatched += fabs(a->across - b->across) > 0x1.8p-30 ||
                            fabs(a->along - b->along) > 0x1.8p-30 || a->distance != b->distance;
    }
}

/* --- in the world -------------------------------------------------------------------------------- */

/* The library's results have the order of the reference renderer's. */
_Static_assert((int)FXL_CLIP_INSIDE == (int)REF_CLIP_INSIDE &&
                   (int)FXL_CLIP_CUT == (int)REF_CLIP_CUT &&
                   (int)FXL_CLIP_OUTSIDE == (int)REF_CLIP_OUTSIDE &&
                   (int)FXL_CLIP_DEGENERATE == (int)REF_CLIP_DEGENERATE &&
                   (int)FXL_CLIP_CAPACITY == (int)REF_CLIP_CAPACITY,
               "outcomes of clipping");

const stages_tally stages_clip_world_tally = {
    .stage = "clip_world",
    .unit = "1/65536 world unit",
    .measure =
        "clipping in the world: largest coordinate difference of a vertex that one plane made "
        "from the reference's, "
        "both given the same polygon and plane; max_from_edge and max_from_plane are "
        "its distances from the exact edge and plane",
    .bound = "0.51 a coordinate from the edge; edge length / 2^29 + 0.9 from the plane",
    .extra_names = {"max_from_edge", "max_from_plane", "max_texture"},
};

static double distance_from_line_in_world(const ref_point *p, const ref_point *a, const ref_point *b,
                                 double *edge_length)
{
    ref_point d = {b->x - a->x, b->y - a->y, b->z - a->z};
    ref_point w = {p->x - a->x, p->y - a->y, p->z - a->z};
    ref_point cross = {w.y * d.z - w.z * d.y, w.z * d.x - w.x * d.z, w.x * d.y - w.y * d.x};
    *edge_length = hypot(hypot(d.x, d.y), d.z);
    return hypot(hypot(cross.x, cross.y), cross.z) / *edge_length;
}

static void compare_vertex_in_world(stages_tally *tally, const ref_plane *plane, const ref_vertex *fixed,
                           const ref_vertex *exact, const ref_vertex *a, const ref_vertex *b)
{
    const ref_point *p = &fixed->position, *e = &exact->position;
    double difference =
        REF_ONE * fmax(fabs(p->x - e->x), fmax(fabs(p->y - e->y), fabs(p->z - e->z)));
    double length;
    double from_edge = REF_ONE * distance_from_line_in_world(p, &a->position, &b->position, &length);
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
static void compare_cut_in_world(stages_tally *tally, const ref_plane *plane, const ref_polygon *in,
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
            compare_vertex_in_world(tally, plane, &fixed->vertices[at], &exact->vertices[at], a, b);
            at++;
        }
    }
    tally->mismatched += at != fixed->count;
}

/* Compares two results of the library, as records of the reference renderer. */
static int same_vertices_in_world(const fxl_polygon *a, const fxl_polygon *b)
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
static void compare_whole_in_world(stages_tally *tally, const fxl_frustum *frustum, const fxl_polygon *in,
                          fxl_clip_result expected, const fxl_polygon *left)
{
    static fxl_clip_world_work work;
    const fxl_polygon *result;
    fxl_clip_result whole = fxl_clip_world_to_planes(in, frustum, FXL_PLANES_ALL, &work, &result);
    int same = whole == expected && (result != NULL) == (left != NULL) &&
               (!left || same_vertices_in_world(result, left));
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
            compare_cut_in_world(tally, &exact_plane, &in, &fixed, &exact);
        }
        if (result == FXL_CLIP_CUT) {
            *polygon = cut;
            all = FXL_CLIP_CUT;
        } else if (result != FXL_CLIP_INSIDE) {
            compare_whole_in_world(tally, frustum, &original, result, NULL);
            return 0;
        }
    }
    compare_whole_in_world(tally, frustum, &original, all, polygon);
    return 1;
}
