/* SPDX-License-Identifier: MIT */
#include "../clip/volume.h"
#include "clip_once.h"

#include "../math/arith.h"
#include "clip_polygon.h"

/* --- which of two planes a line crosses first, exactly -----------------------------------------
 */

/* Where a plane cuts a line from one point to another, given as the distances of the two points
 * from the plane. Each is below 2^63, and one of the points counts as inside. */
typedef struct {
    int plane; /* FXL_PLANE_COUNT: none */
    fxl_q18_46 from, to;
} fxl_plane_intersection;

/* Tells whether intersection a comes before b on the line: compares |from| / (|from| + |to|) as
 * exact fractions. The sums are below 2^64. The products are taken as 128 bits; the lower 64 are
 * those of a product that wraps. */
static inline bool fxl_intersection_is_before(const fxl_plane_intersection *a,
                                              const fxl_plane_intersection *b)
{
    uint64_t a_part = fxl_magnitude(a->from), b_part = fxl_magnitude(b->from);
    uint64_t a_whole = a_part + fxl_magnitude(a->to), b_whole = b_part + fxl_magnitude(b->to);
    uint64_t a_high = fxl_multiply_high(a_part, b_whole);
    uint64_t b_high = fxl_multiply_high(b_part, a_whole);
    return a_high < b_high || (a_high == b_high && a_part * b_whole < b_part * a_whole);
}

/* Keeps the later (or the earlier) of two intersections in *best. *best may be none as yet. */
static inline void fxl_intersection_prefer(fxl_plane_intersection *best,
                                           const fxl_plane_intersection *one, bool later)
{
    if (best->plane == FXL_PLANE_COUNT ||
        (later ? fxl_intersection_is_before(best, one) : fxl_intersection_is_before(one, best))) {
        *best = *one;
    }
}

/* --- the pass --------------------------------------------------------------------------------- */

typedef struct {
    const fxl_varying_polygon *in;
    const fxl_normalised *frustum;
    fxl_clip_once_workspace *workspace;
    fxl_varying_polygon *out;
    uint32_t any;                        /* the planes that a vertex lies outside of */
    uint8_t codes[FXL_POLYGON_CAPACITY]; /* bit n: vertex lies outside plane n */
    uint32_t count;                      /* vertices of out so far */
    bool full;
    int exit_plane; /* the plane through which the polygon left the frustum last */
} pass;

static void append(pass *state, const fxl_varying_vertex *vertex)
{
    if (state->count == FXL_POLYGON_CAPACITY) {
        state->full = true;
        return;
    }
    fxl_copy_vertex(vertex, state->in->carried, &state->out->vertices[state->count++]);
}

/* Computes the vertex where a line meets a plane, from its inside end towards its outside end.
 * in and out are the distances of the ends. An end on the plane is the intersection itself. */
static void intersect(pass *state, const fxl_varying_vertex *inside,
                      const fxl_varying_vertex *outside, fxl_q18_46 in, fxl_q18_46 out,
                      fxl_varying_vertex *vertex)
{
    if (in == 0) {
        fxl_copy_vertex(inside, state->in->carried, vertex);
    } else if (out >= 0) { /* outside by the sliver rule alone */
        fxl_copy_vertex(outside, state->in->carried, vertex);
    } else {
        state->workspace->stats.intersections += 1;
        fxl_intersection_vertex(inside, outside, fxl_intersection_fraction(in, out),
                                state->in->carried, vertex);
    }
}

static uint32_t next_of(const pass *state, uint32_t vertex)
{
    return vertex + 1 == state->in->count ? 0 : vertex + 1;
}

static bool is_outside(const pass *state, int plane, uint32_t vertex)
{
    return ((uint32_t)state->codes[vertex] >> plane & 1u) != 0;
}

/* Returns the distance of a vertex of the input from a plane: at most 0 where the vertex counts
 * as outside. */
static fxl_q18_46 distance(const pass *state, int plane, uint32_t vertex)
{
    fxl_q18_46 exact =
        fxl_normalised_distance(state->frustum, plane, &state->in->vertices[vertex].position);
    return is_outside(state, plane, vertex) && exact > 0 ? 0 : exact;
}

/* Finds the last plane through which an edge enters, and the first through which it leaves.
 * Returns false for an invisible edge: one that lies outside one plane, or leaves before it
 * enters. */
/* clippers 3.1 */
static bool find_intersections(const pass *state, uint32_t from, uint32_t to,
                               fxl_plane_intersection *enter, fxl_plane_intersection *leave)
{
    uint32_t from_code = state->codes[from], to_code = state->codes[to];
    enter->plane = leave->plane = FXL_PLANE_COUNT;
    if ((from_code & to_code) != 0) {
        return false;
    }
    for (int plane = 0; (from_code | to_code) >> plane != 0; plane++) {
        if (((from_code | to_code) >> plane & 1u) == 0) {
            continue;
        }
        fxl_plane_intersection one = {plane, distance(state, plane, from),
                                      distance(state, plane, to)};
        if ((from_code >> plane & 1u) != 0) {
            fxl_intersection_prefer(enter, &one, true);
        } else {
            fxl_intersection_prefer(leave, &one, false);
        }
    }
    return enter->plane == FXL_PLANE_COUNT || leave->plane == FXL_PLANE_COUNT ||
           fxl_intersection_is_before(enter, leave);
}

/* Returns the intersection of the outline with a plane, on an edge of which exactly one vertex
 * is outside the plane. */
static const fxl_varying_vertex *cut_edge(pass *state, int plane, uint32_t from, uint32_t to)
{
    bool inward = is_outside(state, plane, from);
    fxl_varying_vertex *vertex = &state->workspace->cuts[plane][inward].vertex;
    if (state->workspace->cuts[plane][inward].edge != from) {
        uint32_t inside = inward ? to : from, outside = inward ? from : to;
        intersect(state, &state->in->vertices[inside], &state->in->vertices[outside],
                  distance(state, plane, inside), distance(state, plane, outside), vertex);
        state->workspace->cuts[plane][inward].edge = from;
    }
    return vertex;
}

/* Returns the point where the outline crosses a plane inward (or outward); null where it does
 * not. */
static const fxl_varying_vertex *cut_outline(pass *state, int plane, bool inward)
{
    for (uint32_t from = 0; from < state->in->count; from++) {
        uint32_t to = next_of(state, from);
        bool from_outside = is_outside(state, plane, from);
        bool to_outside = is_outside(state, plane, to);
        if (from_outside != to_outside && from_outside == inward) {
            return cut_edge(state, plane, from, to);
        }
    }
    return NULL;
}

/* Finds the corner between two planes. It lies on the line in which the plane with the lower
 * number cuts the polygon, where the other plane crosses that line. The order of the planes is
 * fixed, because a face is flat only to within a few units of 1/65536, and next to the eye that
 * is a pixel. Returns false where the second plane does not cross the line, by as little. */
static bool find_corner(pass *state, int plane, int other, fxl_varying_vertex *corner);

/* Finds an end of the line in which a plane cuts the polygon. Where the outline crosses the
 * plane in front of the near plane or beyond the far plane, those planes have cut the polygon
 * already; the end is then the corner with near or far. */
static bool find_end(pass *state, int plane, bool inward, fxl_varying_vertex *end)
{
    const fxl_varying_vertex *cut = cut_outline(state, plane, inward);
    if (cut == NULL) {
        return false;
    }
    fxl_copy_vertex(cut, state->in->carried, end);
    for (int depth = FXL_PLANE_NEAR; depth <= FXL_PLANE_FAR && plane > FXL_PLANE_FAR; depth++) {
        if (fxl_normalised_distance(state->frustum, depth, &end->position) < 0) {
            fxl_varying_vertex corner;
            if (find_corner(state, depth, plane, &corner)) {
                fxl_copy_vertex(&corner, state->in->carried, end);
            }
        }
    }
    return true;
}

/* clippers 3.1 */
static bool find_corner(pass *state, int plane, int other, fxl_varying_vertex *corner)
{
    int first = plane < other ? plane : other, second = plane ^ other ^ first;
    fxl_varying_vertex from, to;
    if (!find_end(state, first, false, &from) || !find_end(state, first, true, &to)) {
        return false;
    }
    fxl_q18_46 a = fxl_normalised_distance(state->frustum, second, &from.position);
    fxl_q18_46 b = fxl_normalised_distance(state->frustum, second, &to.position);
    if ((a < 0) == (b < 0)) {
        return false;
    }
    intersect(state, a < 0 ? &to : &from, a < 0 ? &from : &to, a < 0 ? b : a, a < 0 ? a : b,
              corner);
    return true;
}

/* An end of the line in which a plane cuts the polygon is outside of another plane, or on it;
 * its computed distance may still be positive. It is at most this: a coordinate is less than
 * 1.25 units off, and a distance adds two coordinates. */
#define HIDDEN 2

/* Finds where a line in a plane leaves the frustum, if its end is not visible: through a plane
 * that the end is outside of. Where rounding hides that plane, the line leaves at its end; there
 * the outline passes the corner exactly or to within rounding. */
/* clippers 3.1 */
static fxl_plane_intersection find_leave(const pass *state, const fxl_varying_vertex *at,
                                         const fxl_varying_vertex *end, uint32_t met)
{
    fxl_plane_intersection leave = {FXL_PLANE_COUNT, 0, 0}, at_end = {FXL_PLANE_COUNT, 1, 0};
    fxl_q18_46 least = HIDDEN;
    for (int other = 0; state->any >> other != 0; other++) {
        if (((state->any & ~met) >> other & 1u) == 0) {
            continue;
        }
        fxl_plane_intersection one = {
            other, fxl_normalised_distance(state->frustum, other, &at->position),
            fxl_normalised_distance(state->frustum, other, &end->position)};
        one.from = one.from < 0 ? 0 : one.from;
        if (one.to < 0) {
            fxl_intersection_prefer(&leave, &one, false);
        } else if (one.to <= least) {
            least = one.to;
            at_end.plane = other;
        }
    }
    return leave.plane == FXL_PLANE_COUNT ? at_end : leave;
}

/* Appends the corners from a point on one plane to the point where the outline enters again
 * through another plane. The path follows the line in which the plane cuts the polygon until the
 * next plane cuts that line off. A point counts as inside every plane that it was found inside
 * of, whatever its rounded coordinates say. */
static void append_corners(pass *state, const fxl_varying_vertex *at, int plane, int last)
{
    fxl_varying_vertex corners[2];
    uint32_t spare = 0;
    uint32_t met = 0;
    while (plane != last && !state->full) {
        met |= (uint32_t)1 << plane;
        const fxl_varying_vertex *end = cut_outline(state, plane, true);
        if (end == NULL) {
            return;
        }
        fxl_plane_intersection first = find_leave(state, at, end, met);
        if (first.plane == FXL_PLANE_COUNT) { /* rounding has lost the corner */
            return;
        }
        fxl_varying_vertex *corner = &corners[spare];
        if (!find_corner(state, plane, first.plane, corner)) {
            intersect(state, at, end, first.from, first.to, corner);
        }
        append(state, corner);
        at = corner;
        spare ^= 1u;
        plane = first.plane;
    }
}

/* Appends what an edge contributes: its first vertex if that is inside; then the corners on the
 * way to the point where it enters, and that point; then the point where it leaves. */
static void append_edge(pass *state, uint32_t from)
{
    uint32_t to = next_of(state, from);
    fxl_plane_intersection enter, leave;
    if (state->codes[from] == 0) {
        append(state, &state->in->vertices[from]);
    }
    if ((state->codes[from] | state->codes[to]) == 0 ||
        !find_intersections(state, from, to, &enter, &leave)) {
        return;
    }
    if (enter.plane != FXL_PLANE_COUNT) {
        append_corners(state, cut_outline(state, state->exit_plane, false), state->exit_plane,
                       enter.plane);
        /* A vertex that is inside all planes is appended with the next edge. */
        if (enter.to > 0 || state->codes[to] != 0) {
            append(state, cut_edge(state, enter.plane, from, to));
        }
    }
    if (leave.plane != FXL_PLANE_COUNT) {
        state->exit_plane = leave.plane;
        if (leave.from > 0 || state->codes[from] != 0) {
            append(state, cut_edge(state, leave.plane, from, to));
        }
    }
}

/* Returns an edge on which the polygon leaves the frustum; the vertex count where there is none. */
static uint32_t find_exit(const pass *state)
{
    fxl_plane_intersection enter, leave;
    uint32_t from = 0;
    while (from < state->in->count &&
           (state->codes[next_of(state, from)] == 0 ||
            !find_intersections(state, from, next_of(state, from), &enter, &leave) ||
            leave.plane == FXL_PLANE_COUNT)) {
        from++;
    }
    return from;
}

/* Finds the visible part of the line in which a plane cuts the polygon, where neither end is
 * visible. Returns false where no part is visible. */
/* clippers 3.1 */
static bool find_visible_part(const pass *state, int plane, const fxl_varying_vertex *from,
                              const fxl_varying_vertex *to, fxl_plane_intersection *enter,
                              fxl_plane_intersection *leave)
{
    int enter_hidden = FXL_PLANE_COUNT;
    enter->plane = leave->plane = FXL_PLANE_COUNT;
    for (int other = 0; state->any >> other != 0; other++) {
        fxl_plane_intersection one = {
            other, fxl_normalised_distance(state->frustum, other, &from->position),
            fxl_normalised_distance(state->frustum, other, &to->position)};
        if (other == plane) {
            continue;
        }
        if (one.from < 0 && one.to < 0) {
            return false;
        }
        if (one.from < 0) {
            fxl_intersection_prefer(enter, &one, true);
        } else if (one.from <= HIDDEN && one.from < one.to) {
            enter_hidden = other;
        }
    }
    if (enter->plane == FXL_PLANE_COUNT) {
        const fxl_plane_intersection hidden = {enter_hidden, 0, 1};
        *enter = hidden;
    }
    uint32_t met = (uint32_t)1 << plane | (uint32_t)1 << enter->plane;
    *leave = find_leave(state, from, to, met);
    return enter->plane != FXL_PLANE_COUNT && leave->plane != FXL_PLANE_COUNT &&
           fxl_intersection_is_before(enter, leave);
}

/* Handles a polygon without a visible edge. Either the polygon covers the frustum from side to
 * side and all vertices of the result are corners, or nothing is visible. In the first case the
 * line in which some plane cuts the polygon is visible in part. */
static void append_corners_alone(pass *state)
{
    for (int plane = 0; state->any >> plane != 0; plane++) {
        fxl_varying_vertex corner;
        fxl_plane_intersection enter, leave;
        if ((state->any >> plane & 1u) == 0) {
            continue;
        }
        const fxl_varying_vertex *from = cut_outline(state, plane, false);
        const fxl_varying_vertex *to = cut_outline(state, plane, true);
        if (from != NULL && to != NULL &&
            find_visible_part(state, plane, from, to, &enter, &leave)) {
            if (!find_corner(state, plane, enter.plane, &corner)) {
                intersect(state, to, from, enter.to, enter.from, &corner);
            }
            append(state, &corner);
            append_corners(state, &corner, plane, enter.plane);
            return;
        }
    }
}

/* Sets the bits of vertices that count as outside by the sliver rule. */
/* clippers 3.3 */
static void apply_sliver(pass *state)
{
    fxl_q18_46 distances[FXL_POLYGON_CAPACITY];
    for (int plane = 0; state->any >> plane != 0; plane++) {
        for (uint32_t i = 0; i < state->in->count; i++) {
            distances[i] =
                fxl_normalised_distance(state->frustum, plane, &state->in->vertices[i].position);
        }
        uint32_t inside =
            fxl_inside_bits(distances, state->in->count, state->workspace->stats.sliver);
        for (uint32_t i = 0; i < state->in->count; i++) {
            state->codes[i] |= (uint8_t)((~inside >> i & 1u) << plane);
        }
    }
}

/* Computes the outcodes of all vertices. Returns their AND. */
static uint32_t set_codes(pass *state)
{
    uint32_t all = UINT32_MAX;
    for (uint32_t i = 0; i < state->in->count; i++) {
        uint32_t code = fxl_normalised_code(state->frustum, &state->in->vertices[i].position);
        state->codes[i] = (uint8_t)code;
        state->any |= code;
    }
    if (state->workspace->stats.sliver > 0) {
        apply_sliver(state);
    }
    for (uint32_t i = 0; i < state->in->count; i++) {
        all &= state->codes[i];
    }
    return all;
}

static void start_pass(pass *state, fxl_clip_once_workspace *workspace)
{
    state->workspace = workspace;
    state->out = &workspace->polygon;
    for (int plane = 0; plane < FXL_PLANE_COUNT; plane++) {
        workspace->cuts[plane][0].edge = workspace->cuts[plane][1].edge = FXL_POLYGON_CAPACITY;
    }
}

/* clippers 3.1 */
fxl_clip_result fxl_clip_once(const fxl_varying_polygon *in, const fxl_normalised *frustum,
                              fxl_clip_once_workspace *workspace,
                              const fxl_varying_polygon **result)
{
    FXL_ASSERT(in != &workspace->polygon && in->count >= 3 && in->count <= FXL_POLYGON_CAPACITY);
    pass state = {.in = in, .frustum = frustum};
    start_pass(&state, workspace);
    *result = NULL;
    if (set_codes(&state) != 0) {
        return FXL_CLIP_OUTSIDE;
    }
    if (state.any == 0) {
        *result = in;
        return FXL_CLIP_INSIDE;
    }
    uint32_t start = find_exit(&state);
    if (start == in->count) {
        append_corners_alone(&state);
    } else {
        fxl_plane_intersection enter, leave;
        find_intersections(&state, start, next_of(&state, start), &enter, &leave);
        state.exit_plane = leave.plane;
        for (uint32_t left = in->count, at = start; left > 0; left--) {
            at = next_of(&state, at);
            append_edge(&state, at);
        }
    }
    if (state.full) {
        return FXL_CLIP_CAPACITY;
    }
    if (state.count < 3) {
        return state.count == 0 ? FXL_CLIP_OUTSIDE : FXL_CLIP_DEGENERATE;
    }
    state.out->colour = in->colour;
    state.out->carried = in->carried;
    state.out->count = (uint8_t)state.count;
    *result = state.out;
    return FXL_CLIP_CUT;
}
