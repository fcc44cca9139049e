/* SPDX-License-Identifier: MIT */
#include "clip/clip_view.c"
#include "products.h"

/* [[row]]
 * function = "project_onto"
 * property = "nothing overflows"
 * checks = 16
 * contract = true
 * equations = true
 */
void prove_project_onto(void)
{
    (void)project_onto(nondet_s32(), nondet_s64(), nondet_s32(), nondet_s64());
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_view_distance"
 * property = "nothing overflows, and each distance is below 2^62"
 * checks = 262
 * contract = true
 * uses = ["project_onto"]
 */
void prove_view_distance(void)
{
    fxl_view_frustum *frustum;
    fxl_view_point *point;
    (void)fxl_view_distance(frustum, (int)nondet_s32(), point);
    PROOF_ENDS();
}

/* --- one step of the loop over a polygon's edges, in any state ------------------------------------- */

static uint32_t written;

static void any_copy(const fxl_cut *cut, uint32_t from, uint32_t to)
{
    (void)cut;
    ASSERT("copied within", to < FXL_POLYGON_CAPACITY && from < FXL_POLYGON_CAPACITY);
    written++;
}

static void any_cross(const fxl_cut *cut, uint32_t inside, uint32_t outside, uint32_t to)
{
    ASSERT("crossed within", to < FXL_POLYGON_CAPACITY && inside != outside);
    ASSERT("from inside to outside", cut->distances[inside] > 0 && cut->distances[outside] < 0);
    written++;
}

/* [[row]]
 * function = "lib/clip/cut_polygon.h:fxl_cut_edge"
 * property = "one step in any state at capacity 32: never more vertices than the capacity, never out of bounds, each crossing from inside to outside"
 * checks = 424
 */
void prove_cut_edge(void)
{
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
    const uint32_t count = nondet_u32(), current = nondet_u32(), before = nondet_u32(), bits = nondet_u32();
    ASSUME(count >= 3 && count <= FXL_POLYGON_CAPACITY && current < count);
    ASSUME(before <= FXL_POLYGON_CAPACITY && before <= 2 * current);
    const uint32_t next = current + 1 == count ? 0 : current + 1;
    ASSUME((bits >> current & 1u) == (uint32_t)(distances[current] >= 0));
    ASSUME((bits >> next & 1u) == (uint32_t)(distances[next] >= 0));
    fxl_cut cut = {NULL, NULL, distances, before};
    written = 0;
    const bool whole = fxl_cut_edge(&cut, any_copy, any_cross, bits, current, count);
    ASSERT("it counts what it writes", cut.count == before + written && cut.count >= before);
    ASSERT("never more than the capacity", cut.count <= FXL_POLYGON_CAPACITY);
    ASSERT("at most two an edge", cut.count <= 2 * (current + 1));
    ASSERT("refused only where it is full", whole || cut.count == FXL_POLYGON_CAPACITY);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/clip/cut_polygon.h:fxl_cut_bit"
 * property = "the bit of each vertex, exactly"
 * checks = 3
 */
void prove_cut_bit(void)
{
    const int64_t distance = nondet_s64();
    const uint32_t vertex = nondet_u32();
    ASSUME(vertex < FXL_POLYGON_CAPACITY);
    ASSERT("its bit", fxl_cut_bit(distance, vertex) == (distance >= 0 ? (uint32_t)1 << vertex : 0));
    PROOF_ENDS();
}

/* --- a plane ----------------------------------------------------------------------------------------- */

static fxl_view_polygon polygon_in, polygon_out;
static fxl_q18_46 distances_of_in[FXL_POLYGON_CAPACITY];

static bool in_view(const fxl_view_point *point)
{
    return FXL_POINT_BELOW(point, ((int64_t)1 << 61) - 1);
}

/* For fxl_intersect_edge: what its contract says. */
void any_intersection(const fxl_view_point *from, const fxl_view_point *to, const fxl_q18_46 *inside, const fxl_q18_46 *outside,
                             fxl_view_point *point)
{
    ASSERT("from the inside to the outside", *inside > 0 && *inside < (int64_t)1 << 62 && *outside < 0 && *outside >= -((int64_t)1 << 62));
    ASSERT("ends in the view", in_view(from) && in_view(to) && point != from && point != to);
    ANY_CONTENT(point);
    ASSUME(FXL_POINT_BELOW(point, ((int64_t)1 << 61) - 1));
}

/* [[row]]
 * id = "copy of a view"
 * function = "copy"
 * property = "any two places of a polygon: nothing is out of bounds, and the point stays in the view"
 * checks = 97
 * stands_in = { fxl_intersect_edge = "any_intersection" }
 */
void prove_copy(void)
{
    const uint32_t from = nondet_u32(), to = nondet_u32();
    const fxl_cut cut = {&polygon_in, &polygon_out, distances_of_in, nondet_u32()};
    ANY_CONTENT(&polygon_in);
    ASSUME(from < FXL_POLYGON_CAPACITY && to < FXL_POLYGON_CAPACITY && in_view(&polygon_in.vertices[from].position));
    copy(&cut, from, to);
    ASSERT("in the view", in_view(&polygon_out.vertices[to].position));
    PROOF_ENDS();
}

/* [[row]]
 * id = "cross of a view"
 * function = "cross"
 * property = "any edge from the inside to the outside: what the intersection requires, and a point in the view"
 * checks = 135
 * stands_in = { fxl_intersect_edge = "any_intersection" }
 */
void prove_cross(void)
{
    const uint32_t inside = nondet_u32(), outside = nondet_u32(), to = nondet_u32();
    const fxl_cut cut = {&polygon_in, &polygon_out, distances_of_in, nondet_u32()};
    ANY_CONTENT(&polygon_in);
    ANY_CONTENT(distances_of_in);
    ASSUME(inside < FXL_POLYGON_CAPACITY && outside < FXL_POLYGON_CAPACITY && to < FXL_POLYGON_CAPACITY);
    ASSUME(in_view(&polygon_in.vertices[inside].position) && in_view(&polygon_in.vertices[outside].position));
    ASSUME(distances_of_in[inside] > 0 && distances_of_in[inside] < (int64_t)1 << 62);
    ASSUME(distances_of_in[outside] < 0 && distances_of_in[outside] >= -((int64_t)1 << 62));
    cross(&cut, inside, outside, to);
    ASSERT("in the view", in_view(&polygon_out.vertices[to].position));
    PROOF_ENDS();
}

/* For fxl_view_distance: what its contract says. */
fxl_q18_46 any_distance(const fxl_view_frustum *frustum, int plane, const fxl_view_point *point)
{
    const fxl_q18_46 distance = nondet_s64();
    (void)frustum;
    ASSERT("of a plane, and in the view", plane >= 0 && plane < FXL_PLANE_COUNT && in_view(point));
    ASSUME(WITHIN(distance, ((int64_t)1 << 62) - 1));
    return distance;
}

/* For fxl_cut_edge: what its own row assumes and asserts. */
bool any_cut_edge(fxl_cut *cut, fxl_cut_copy *copies, fxl_cut_cross *crosses, uint32_t bits, uint32_t current, uint32_t count)
{
    const uint32_t next = current + 1 == count ? 0 : current + 1, before = cut->count;
    ASSERT("a plane's own", copies == copy && crosses == cross && cut->in == &polygon_in && cut->out == &polygon_out);
    ASSERT("a state that a step takes", count >= 3 && count <= FXL_POLYGON_CAPACITY && current < count && before <= 2 * current);
    ASSERT("the bits of its distances", (bits >> current & 1u) == (uint32_t)(cut->distances[current] >= 0) &&
                                            (bits >> next & 1u) == (uint32_t)(cut->distances[next] >= 0));
    cut->count = nondet_u32();
    ASSUME(cut->count >= before && cut->count <= FXL_POLYGON_CAPACITY && cut->count <= 2 * (current + 1));
    return nondet_bool();
}

/* [[row]]
 * function = "fxl_clip_view_to_plane"
 * property = "any polygon of up to 32 vertices: each step is one that the row of fxl_cut_edge takes, and what is cut has 3 to 32 vertices"
 * checks = 197
 * unwind = 33
 * stands_in = { fxl_view_distance = "any_distance", fxl_cut_edge = "any_cut_edge" }
 */
void prove_clip_view_to_plane(void)
{
    fxl_view_frustum frustum;
    const int plane = (int)nondet_s32();
    ANY_CONTENT(&polygon_in);
    ASSUME(plane >= 0 && plane < FXL_PLANE_COUNT && polygon_in.count >= 3 && polygon_in.count <= FXL_POLYGON_CAPACITY);
    for (uint32_t i = 0; i < FXL_POLYGON_CAPACITY; i++) {
        ASSUME(in_view(&polygon_in.vertices[i].position));
    }
    const fxl_clip_result result = fxl_clip_view_to_plane(&polygon_in, &frustum, plane, &polygon_out, distances_of_in);
    ASSERT("cut, it is a polygon", result != FXL_CLIP_CUT || (polygon_out.count >= 3 && polygon_out.count <= FXL_POLYGON_CAPACITY));
    PROOF_ENDS();
}

/* --- the planes -------------------------------------------------------------------------------------- */

static fxl_clip_view_work work;

static bool is_polygon(const fxl_view_polygon *polygon)
{
    return (polygon == &polygon_in || polygon == &work.polygons[0] || polygon == &work.polygons[1]) && polygon->count >= 3 &&
           polygon->count <= FXL_POLYGON_CAPACITY;
}

/* For fxl_clip_stats_add, whose own row takes any of its counts. */
void any_stats(fxl_clip_stats *stats, const fxl_q18_46 *distances, uint32_t measured, uint32_t result_count)
{
    (void)stats;
    ASSERT("counts of polygons", distances == work.distances && measured <= FXL_POLYGON_CAPACITY && result_count <= FXL_POLYGON_CAPACITY);
}

/* For fxl_clip_view_to_plane: what its own row assumes and asserts. */
fxl_clip_result any_cut(const fxl_view_polygon *in, const fxl_view_frustum *frustum, int plane, fxl_view_polygon *out,
                               fxl_q18_46 *distances)
{
    const uint32_t result = nondet_u32();
    (void)frustum;
    ASSERT("a polygon, by a plane", is_polygon(in) && plane >= 0 && plane < FXL_PLANE_COUNT);
    ASSERT("into another one", out != in && (out == &work.polygons[0] || out == &work.polygons[1]) && distances == work.distances);
    if (result == FXL_CLIP_CUT) {
        out->count = nondet_u8();
        ASSUME(out->count >= 3 && out->count <= FXL_POLYGON_CAPACITY);
    }
    return (fxl_clip_result)result;
}

/* [[row]]
 * function = "by_plane"
 * property = "any polygon, any plane: the row of fxl_clip_view_to_plane takes it, and counts are those of polygons"
 * checks = 71
 * unwind = 8
 * stands_in = { fxl_clip_view_to_plane = "any_cut", fxl_clip_stats_add = "any_stats" }
 */
void prove_by_plane(void)
{
    fxl_view_frustum frustum;
    fxl_clip_stats stats;
    const int plane = (int)(nondet_u8() % FXL_PLANE_COUNT);
    ANY_CONTENT(&polygon_in);
    ANY_CONTENT(&work);
    const clipping to = {&frustum, &work, nondet_bool() ? &stats : NULL};
    const fxl_view_polygon *in = nondet_bool() ? &polygon_in : &work.polygons[0];
    ASSUME(is_polygon(in));
    const fxl_clip_result result = by_plane(&to, plane, in, &work.polygons[1]);
    ASSERT("a polygon where it is cut", result != FXL_CLIP_CUT || is_polygon(&work.polygons[1]));
    PROOF_ENDS();
}

/* [[row]]
 * function = "fxl_clip_view_by_planes"
 * property = "any polygon, any planes: each cut is one that the row of fxl_clip_view_to_plane takes, and the result is the input, a polygon of the workspace, or null"
 * checks = 109
 * unwind = 8
 * stands_in = { fxl_clip_view_to_plane = "any_cut", fxl_clip_stats_add = "any_stats" }
 */
void prove_clip_view_by_planes(void)
{
    fxl_view_frustum frustum;
    fxl_clip_stats stats;
    const fxl_view_polygon *in = nondet_bool() ? &polygon_in : &work.polygons[0], *left;
    ANY_CONTENT(&polygon_in);
    ANY_CONTENT(&work);
    ASSUME(is_polygon(in));
    const fxl_planes planes = nondet_u8() & FXL_PLANES_ALL;
    const fxl_clip_result result = fxl_clip_view_by_planes(in, &frustum, planes, &work, nondet_bool() ? &stats : NULL, &left);
    ASSERT("nothing, the input, or a polygon of the workspace", left == NULL || is_polygon(left));
    ASSERT("inside or cut, it has a result", left != NULL || (result != FXL_CLIP_INSIDE && result != FXL_CLIP_CUT));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/clip/clip_view.h:fxl_clip_stats_add"
 * property = "any distances of up to 32 vertices, or no counts: nothing is out of bounds"
 * checks = 26
 * unwind = 33
 */
void prove_clip_stats_add(void)
{
    fxl_clip_stats stats;
    const uint32_t measured = nondet_u32();
    ANY_CONTENT(distances_of_in);
    ASSUME(measured <= FXL_POLYGON_CAPACITY);
    fxl_clip_stats_add(nondet_bool() ? &stats : NULL, distances_of_in, measured, nondet_u32());
    PROOF_ENDS();
}

/* --- results, of products and quotients that may be any ------------------------------------------------- */


/* [[row]]
 * function = "project_onto"
 * id = "project_onto, its result"
 * property = "the floor of the two products of three words each, added, over 2^30"
 * checks = 20
 * stands_in = { fxl_multiply_u32 = "any_unsigned", fxl_multiply_s32 = "any_signed" }
 * stubs = { fxl_multiply_u32 = "C's product of two words" }
 */
void prove_project_onto_result(void)
{
    const int32_t side = nondet_s32(), depth = nondet_s32();
    const int64_t across = nondet_s64(), along = nondet_s64(), most = ((int64_t)1 << 61) - 1;
    ASSUME(FXL_SIDE(side, depth) && WITHIN(across, most) && WITHIN(along, most));
    const int64_t high_across = any_signed(side, (int32_t)(across >> 32)), high_along = any_signed(depth, (int32_t)(along >> 32));
    const uint64_t low_across = any_unsigned((uint32_t)side, fxl_low_32(fxl_bits_64(across))), low_along = any_unsigned((uint32_t)depth, fxl_low_32(fxl_bits_64(along)));
    ASSUME(WITHIN(high_across, (int64_t)1 << 59) && WITHIN(high_along, (int64_t)1 << 59));
    ASSUME(low_across < (uint64_t)1 << 62 && low_along < (uint64_t)1 << 62);
    const wide sum = ((wide)high_across + high_along) * ((wide)1 << 32) + low_across + low_along;
    ASSERT("the floor", project_onto(side, across, depth, along) == (int64_t)(sum >> 30));
    PROOF_ENDS();
}
