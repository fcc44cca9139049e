/* SPDX-License-Identifier: MIT */
#include "reference/beam_light.h"

#include <math.h>

#define UNIT (1.0L / 65536)

/* Returns the side of a plane on which a point lies: -1 behind, 1 in front, 0 if it is at most 4
 * units of 1/65536 away. */
static int side_of(const ref_plane *plane, const ref_lattice_point *point)
{
    long double distance = ref_split_distance(plane, point);
    return fabsl(distance) <= 4 * UNIT ? 0 : distance < 0 ? -1 : 1;
}

bool ref_beam_light_reaches(const ref_scene *scene, const ref_lattice_point *centre, int32_t radius)
{
    const long double reach = ((long double)radius + 4) * UNIT;
    for (uint32_t b = 0; b < scene->beam_count; b++) {
        bool ruled_out = false;
        for (int i = 0; i < scene->beams[b].plane_count; i++) {
            ruled_out |= ref_split_distance(&scene->beams[b].planes[i], centre) < -reach;
        }
        if (!ruled_out) {
            return true;
        }
    }
    return false;
}

static bool shines_on(const ref_beam *beam, const ref_lattice_point *vertex, const int32_t *normal)
{
    long double sum = 0;
    const int32_t at[3] = {vertex->x, vertex->y, vertex->z};
    for (int i = 0; i < 3; i++) {
        long double way = beam->kind == REF_BEAM_DIRECTION ? -(long double)beam->from[i]
                                                           : (long double)beam->from[i] - at[i];
        sum += normal[i] * way; /* below 2^63: exact */
    }
    return sum > 0;
}

/* Inserts an intersection into every piece that has the edge between two points. */
static bool insert_into_all(ref_lit_pieces *to, const ref_lattice_point *a,
                            const ref_lattice_point *b, const ref_lattice_point *intersection)
{
    const ref_lattice_point ends[2] = {*a, *b};
    bool fits = true;
    for (int i = 0; i < to->count && fits; i++) {
        fits = ref_piece_insert(&to->pieces[i].shape, ends, intersection, REF_POLYGON_CAPACITY);
    }
    return fits;
}

static ref_lattice_point intersect(const ref_plane *plane, const ref_lattice_point *a,
                                   const ref_lattice_point *b)
{
    long double from = ref_split_distance(plane, a), to = ref_split_distance(plane, b);
    return from > 0 ? ref_split_edge(a, b, from, to) : ref_split_edge(b, a, to, from);
}

/* Inserts the intersection of every edge that a plane crosses, in all pieces that have the edge.
 * After that the outline meets the plane only in corners. */
static bool insert_intersections(ref_lit_pieces *to, int number, const ref_plane *plane)
{
    const ref_piece whole = to->pieces[number].shape;
    for (int i = 0; i < whole.count; i++) {
        const ref_lattice_point *a = &whole.points[i], *b = &whole.points[(i + 1) % whole.count];
        if (side_of(plane, a) * side_of(plane, b) < 0) {
            ref_lattice_point intersection = intersect(plane, a, b);
            if (!insert_into_all(to, a, b, &intersection)) {
                return false;
            }
        }
    }
    return true;
}

/* Returns the first side other than 0 that is met from a corner on, in one direction. */
static int next_side(const ref_plane *plane, const ref_piece *piece, int from, int step)
{
    for (int k = 0; k < piece->count; k++) {
        int side =
            side_of(plane, &piece->points[(from + step * k + piece->count * k) % piece->count]);
        if (side != 0) {
            return side;
        }
    }
    return 0;
}

/* Places a corner on the plane. It belongs to the front part if the outline is in front on both
 * sides of it. Where the outline changes sides, the corner next to the front belongs to both
 * parts, and the other corners on the plane to the part behind. */
static void place_on_plane(const ref_plane *plane, const ref_piece *piece, int i, bool *in_front,
                           bool *behind)
{
    int before = next_side(plane, piece, (i + piece->count - 1) % piece->count, -1);
    int after = next_side(plane, piece, (i + 1) % piece->count, 1);
    int left = side_of(plane, &piece->points[(i + piece->count - 1) % piece->count]);
    int right = side_of(plane, &piece->points[(i + 1) % piece->count]);
    if (before == after) {
        *in_front = before > 0;
        *behind = before < 0;
    } else {
        *in_front = left > 0 || right > 0;
        *behind = true;
    }
}

/* Cuts an edge on a plane by the later planes of the beam. The edge counts as in front of the
 * plane, whichever polygon it belongs to. */
static bool follow(ref_lit_pieces *to, ref_lattice_point a, ref_lattice_point b,
                   const ref_beam *beam, int next)
{
    for (int i = next; i < beam->plane_count; i++) {
        const ref_plane *plane = &beam->planes[i];
        int from = side_of(plane, &a), there = side_of(plane, &b);
        if (from * there < 0) {
            ref_lattice_point intersection = intersect(plane, &a, &b);
            if (!insert_into_all(to, &a, &b, &intersection)) {
                return false;
            }
            if (from < 0) {
                a = intersection;
            } else {
                b = intersection;
            }
        } else if (from < 0 || there < 0) {
            return true;
        }
    }
    return true;
}

static bool follow_all(ref_lit_pieces *to, int number, const ref_beam *beam, int plane)
{
    const ref_piece piece = to->pieces[number].shape;
    for (int i = 0; i < piece.count; i++) {
        const ref_lattice_point *a = &piece.points[i], *b = &piece.points[(i + 1) % piece.count];
        if (side_of(&beam->planes[plane], a) == 0 && side_of(&beam->planes[plane], b) == 0 &&
            !follow(to, *a, *b, beam, plane + 1)) {
            return false;
        }
    }
    return true;
}

typedef enum {
    IN,
    OUT,
    FULL
} outcome;

/* Cuts a piece by a plane: the piece keeps the part in front, and the rest becomes a new piece. */
static outcome cut(ref_lit_pieces *to, int number, const ref_beam *beam, int which)
{
    const ref_plane *plane = &beam->planes[which];
    bool any_front = false, any_behind = false, edge = false;
    const ref_piece before = to->pieces[number].shape;
    for (int i = 0; i < before.count; i++) {
        int side = side_of(plane, &before.points[i]);
        any_front |= side > 0;
        any_behind |= side < 0;
        edge |= side == 0 && side_of(plane, &before.points[(i + 1) % before.count]) == 0;
    }
    if (!any_behind) {
        return IN;
    }
    if (!any_front) {
        return !edge || follow_all(to, number, beam, which) ? OUT : FULL;
    }
    if (!insert_intersections(to, number, plane) || to->count == REF_LIT_PIECES_MAX) {
        return FULL;
    }
    const ref_piece whole = to->pieces[number].shape;
    ref_lit_piece *front = &to->pieces[number], *back = &to->pieces[to->count];
    back->lit = front->lit;
    back->shape.count = front->shape.count = 0;
    for (int i = 0; i < whole.count; i++) {
        int side = side_of(plane, &whole.points[i]);
        bool in_front = side > 0, behind = side < 0;
        if (side == 0) {
            place_on_plane(plane, &whole, i, &in_front, &behind);
        }
        if (in_front) {
            front->shape.points[front->shape.count++] = whole.points[i];
        }
        if (behind) {
            back->shape.points[back->shape.count++] = whole.points[i];
        }
    }
    to->count++;
    return !edge || follow_all(to, to->count - 1, beam, which) ? IN : FULL;
}

bool ref_beam_light_split(const ref_scene *scene, const ref_piece *polygon, const int32_t *normal,
                          ref_lit_pieces *to)
{
    to->count = 1;
    to->pieces[0] = (ref_lit_piece){*polygon, false};
    for (uint32_t b = 0; b < scene->beam_count; b++) {
        const ref_beam *beam = &scene->beams[b];
        const bool shines = shines_on(beam, &polygon->points[0], normal);
        for (int i = 0, pieces = to->count; i < pieces; i++) {
            outcome is = IN;
            for (int plane = 0; plane < beam->plane_count && is == IN; plane++) {
                is = cut(to, i, beam, plane);
            }
            if (is == FULL) {
                return false;
            }
            to->pieces[i].lit |= shines && is == IN;
        }
    }
    return true;
}
