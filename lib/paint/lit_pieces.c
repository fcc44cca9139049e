/* SPDX-License-Identifier: MIT */
#include "../clip/split.h"
#include "../math/plane.h"
#include "../scene/scene_check.h"
#include "lit_pieces.h"

#include "../math/arith.h"

#define NONE UINT16_MAX

/* A point within this distance of a plane lies on it: 4/65536 unit. An intersection is within
 * 0.87/65536 of its plane. An intersection of an edge between two such points is within twice
 * that. So points that rounding moved off a plane are not cut there again, and an outline that
 * rounding made slightly concave is cut at most twice. */
#define ON_PLANE ((fxl_q18_46)4 << 30)

/* A cut of one piece by one plane makes two intersections. Each is a corner of both parts and of
 * a piece beyond the edge. CORNERS_ON_PLANES is for edges that lie in a plane. */
enum {
    CORNERS_A_CUT = 6,
    CORNERS_ON_PLANES = 16
};

uint32_t fxl_lit_pieces_needed(const fxl_beam *beams, uint32_t beam_count)
{
    uint32_t pieces = 1; /* at most 9^4 */
    for (uint32_t i = 0; i < beam_count; i++) {
        pieces *= beams[i].plane_count + 1u;
    }
    return pieces;
}

uint32_t fxl_lit_corners_needed(const fxl_beam *beams, uint32_t beam_count)
{
    uint32_t vertices = FXL_FACE_VERTICES_MAX;
    while (!fxl_beams_fit(beams, beam_count, vertices)) {
        vertices--;
    }
    return vertices + CORNERS_ON_PLANES +
           CORNERS_A_CUT * (fxl_lit_pieces_needed(beams, beam_count) - 1);
}

static bool same(const fxl_point *a, const fxl_point *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

static uint16_t new_corner(fxl_lit_pieces *of, const fxl_point *at)
{
    if (of->corner_count == of->corner_capacity) {
        return NONE;
    }
    of->points[of->corner_count] = *at;
    return (uint16_t)of->corner_count++;
}

/* Appends a corner to a piece. */
static void append(fxl_lit_pieces *of, fxl_lit_piece *piece, uint16_t corner)
{
    if (piece->count == 0) {
        of->next[corner] = corner;
    } else {
        of->next[corner] = of->next[piece->last];
        of->next[piece->last] = corner;
    }
    piece->last = corner;
    piece->count++;
}

static bool append_new(fxl_lit_pieces *of, fxl_lit_piece *piece, const fxl_point *at)
{
    uint16_t corner = new_corner(of, at);
    if (corner == NONE) {
        return false;
    }
    append(of, piece, corner);
    return true;
}

/* Takes a new piece, which has no corners yet. */
static fxl_lit_piece *new_piece(fxl_lit_pieces *of, bool is_lit)
{
    if (of->piece_count == of->piece_capacity) {
        return NULL;
    }
    fxl_lit_piece *piece = &of->pieces[of->piece_count++];
    piece->count = 0;
    piece->is_lit = is_lit;
    return piece;
}

/* Returns the distance of a point: 0 where it lies on the plane. */
/* beams 1.2, 3.1 */
static fxl_q18_46 distance_of(const fxl_plane *plane, const fxl_point *point)
{
    fxl_q18_46 distance = fxl_plane_distance(plane, point);
    return fxl_within(distance, ON_PLANE) ? 0 : distance;
}

/* beams 3.2 */
static bool are_on_opposite_sides(fxl_q18_46 a, fxl_q18_46 b)
{
    return (a > 0 && b < 0) || (a < 0 && b > 0);
}

static fxl_point intersect(const fxl_point *a, const fxl_point *b, fxl_q18_46 a_distance,
                           fxl_q18_46 b_distance)
{
    return a_distance > 0 ? fxl_split_edge(a, b, a_distance, b_distance)
                          : fxl_split_edge(b, a, b_distance, a_distance);
}

/* Inserts an intersection into every piece that has the edge between a and b, in either
 * direction. */
/* beams 3.4 */
static bool insert_between(fxl_lit_pieces *of, const fxl_point *a, const fxl_point *b,
                           const fxl_point *crossing)
{
    for (uint32_t i = 0; i < of->piece_count; i++) {
        fxl_lit_piece *piece = &of->pieces[i];
        uint16_t corner = piece->last;
        for (uint32_t left = piece->count; left > 0; left--) {
            const uint16_t next = of->next[corner];
            const fxl_point *here = &of->points[corner], *there = &of->points[next];
            if ((same(here, a) && same(there, b)) || (same(here, b) && same(there, a))) {
                const uint16_t between = new_corner(of, crossing);
                if (between == NONE) {
                    return false;
                }
                of->next[between] = next;
                of->next[corner] = between;
                piece->count++;
                if (corner == piece->last) {
                    piece->last = between; /* the first corner stays the first */
                }
            }
            corner = next;
        }
    }
    return true;
}

/* Cuts an edge that lies in a plane by the later planes of the beam. A neighbour that shares the
 * edge and lies in front of the plane is cut in the same places. */
/* beams 3.4, 3.6 */
static bool follow_edge(fxl_lit_pieces *of, fxl_point a, fxl_point b, const fxl_beam *beam,
                        uint32_t next_plane)
{
    for (uint32_t i = next_plane; i < beam->plane_count; i++) {
        const fxl_plane plane = fxl_beam_plane_at(beam, i);
        const fxl_q18_46 from = distance_of(&plane, &a), to = distance_of(&plane, &b);
        if (are_on_opposite_sides(from, to)) {
            const fxl_point crossing = intersect(&a, &b, from, to);
            if (!insert_between(of, &a, &b, &crossing)) {
                return false;
            }
            *(from < 0 ? &a : &b) = crossing;
        } else if (from < 0 || to < 0) {
            return true; /* no part of the edge is in front of the plane */
        }
    }
    return true;
}

/* Calls follow_edge for every edge, lying in the plane, of a piece behind the plane. */
static bool follow_edges(fxl_lit_pieces *of, const fxl_lit_piece *piece, const fxl_plane *plane,
                         const fxl_beam *beam, uint32_t next_plane)
{
    uint16_t corner = piece->last;
    for (uint32_t left = piece->count; left > 0; left--) {
        const uint16_t next = of->next[corner];
        const fxl_point a = of->points[corner], b = of->points[next];
        if (distance_of(plane, &a) == 0 && distance_of(plane, &b) == 0 &&
            !follow_edge(of, a, b, beam, next_plane)) {
            return false;
        }
        corner = next;
    }
    return true;
}

/* Appends a row of consecutive points on the plane to the parts that they belong to. A row
 * between two corners of one side goes to that side. A row between two sides goes to the part
 * behind; its point next to the front goes to both parts. */
static bool append_row(fxl_lit_pieces *of, uint16_t corner, uint32_t count, bool from_front,
                       bool to_front, fxl_lit_piece *front, fxl_lit_piece *back)
{
    for (uint32_t i = 0; i < count; i++) {
        const uint16_t next = of->next[corner];
        const bool is_crossing = from_front ? !to_front && i == 0 : to_front && i + 1 == count;
        if (is_crossing && !append_new(of, back, &of->points[corner])) {
            return false;
        }
        append(of, is_crossing || (from_front && to_front) ? front : back, corner);
        corner = next;
    }
    return true;
}

/* Divides a piece that has corners on both sides. The piece begins with a corner in front, so
 * the loop ends with that corner. */
/* beams 3.3 */
static bool part_corners(fxl_lit_pieces *of, const fxl_lit_piece *piece, const fxl_plane *plane,
                         fxl_lit_piece *front, fxl_lit_piece *back)
{
    uint16_t corner = of->next[piece->last], row = NONE;
    uint32_t row_count = 0;
    fxl_point from = of->points[piece->last];
    fxl_q18_46 side = distance_of(plane, &from); /* of the last corner not on the plane */
    for (uint32_t left = piece->count; left > 0; left--) {
        const uint16_t next = of->next[corner];
        const fxl_point to = of->points[corner];
        const fxl_q18_46 distance = distance_of(plane, &to);
        if (distance == 0) {
            row = row_count == 0 ? corner : row;
            row_count++;
        } else {
            if (row_count > 0) {
                if (!append_row(of, row, row_count, side > 0, distance > 0, front, back)) {
                    return false;
                }
            } else if (are_on_opposite_sides(side, distance)) {
                const fxl_point crossing = intersect(&from, &to, side, distance);
                if (!append_new(of, front, &crossing) || !append_new(of, back, &crossing) ||
                    !insert_between(of, &from, &to, &crossing)) {
                    return false;
                }
            }
            append(of, distance > 0 ? front : back, corner);
            row_count = 0;
            side = distance;
        }
        from = to;
        corner = next;
    }
    return true;
}

typedef enum {
    WHOLE,   /* all of the piece is in front of the plane */
    NOTHING, /* all of the piece is behind it */
    PARTED,  /* the piece is now the part in front, a new piece the part behind */
    NO_ROOM
} outcome;

/* The part in front replaces the piece. Both parts enter the table only when they are complete,
 * so insert_between does not take the piece's own edge for that of a neighbour. */
static outcome part(fxl_lit_pieces *of, fxl_lit_piece *piece, const fxl_plane *plane,
                    fxl_lit_piece **behind)
{
    *behind = new_piece(of, piece->is_lit);
    if (*behind == NULL) {
        return NO_ROOM;
    }
    while (distance_of(plane, &of->points[piece->last]) <= 0) {
        piece->last = of->next[piece->last];
    }
    const fxl_lit_piece whole = *piece;
    fxl_lit_piece front = **behind, back = **behind;
    piece->count = 0;
    if (!part_corners(of, &whole, plane, &front, &back)) {
        return NO_ROOM;
    }
    *piece = front;
    **behind = back;
    return PARTED;
}

/* Cuts a piece by one plane of a beam. */
/* beams 3.2, 3.5 */
static outcome cut(fxl_lit_pieces *of, fxl_lit_piece *piece, const fxl_beam *beam, uint32_t number)
{
    const fxl_plane plane = fxl_beam_plane_at(beam, number);
    bool in_front = false, is_behind = false, edge = false;
    uint16_t corner = piece->last;
    fxl_q18_46 before = distance_of(&plane, &of->points[corner]);
    for (uint32_t left = piece->count; left > 0; left--) {
        corner = of->next[corner];
        fxl_q18_46 distance = distance_of(&plane, &of->points[corner]);
        in_front |= distance > 0;
        is_behind |= distance < 0;
        edge |= distance == 0 && before == 0;
        before = distance;
    }
    if (!is_behind) {
        return WHOLE;
    }
    fxl_lit_piece *behind = piece;
    outcome made = in_front ? part(of, piece, &plane, &behind) : NOTHING;
    if (made == NO_ROOM || (edge && !follow_edges(of, behind, &plane, beam, number + 1))) {
        return NO_ROOM;
    }
    return made;
}

/* Cuts a piece by all planes of a beam, keeping the part inside. */
/* beams 2.3 */
static outcome cut_by_beam(fxl_lit_pieces *of, fxl_lit_piece *piece, const fxl_beam *beam)
{
    for (uint32_t i = 0; i < beam->plane_count; i++) {
        outcome one = cut(of, piece, beam, i);
        if (one == NOTHING || one == NO_ROOM) {
            return one;
        }
    }
    return WHOLE;
}

/* beams 2.1 */
bool fxl_lit_split(fxl_lit_pieces *to, const fxl_beam *beams, uint32_t beam_count,
                   const fxl_direction *normal, const fxl_point *points, uint32_t count)
{
    to->corner_count = 0;
    to->piece_count = 0;
    fxl_lit_piece *face = new_piece(to, false);
    for (uint32_t i = 0; i < count; i++) {
        if (face == NULL || !append_new(to, face, &points[i])) {
            return false;
        }
    }
    for (uint32_t b = 0; b < beam_count; b++) {
        const bool shines = fxl_beam_shines_on(&beams[b], &points[0], normal);
        const uint32_t before = to->piece_count;
        for (uint32_t i = 0; i < before; i++) {
            outcome inside = cut_by_beam(to, &to->pieces[i], &beams[b]);
            if (inside == NO_ROOM) {
                return false;
            }
            to->pieces[i].is_lit |= shines && inside == WHOLE;
        }
    }
    return true;
}

bool fxl_lit_outline(const fxl_lit_pieces *of, const fxl_lit_piece *piece, fxl_point *points)
{
    uint16_t corner = piece->last;
    if (piece->count > FXL_POLYGON_CAPACITY) {
        return false;
    }
    for (uint32_t i = 0; i < piece->count; i++) {
        corner = of->next[corner];
        points[i] = of->points[corner];
    }
    return true;
}
