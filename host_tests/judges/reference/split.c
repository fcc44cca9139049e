/* SPDX-License-Identifier: MIT */
#include "reference/split.h"

#include <math.h>
#include <string.h>

#include "reference/frustum.h"
#include "reference/cull.h"

static int32_t between(int32_t front, int32_t behind, long double t)
{
    long double way = t * fabsl((long double)behind - front);
    int64_t whole = (int64_t)floorl(way + 0.5L + 0x1p-25L);
    return (int32_t)(behind < front ? front - whole : front + whole);
}

ref_lattice_point ref_split_edge(const ref_lattice_point *front, const ref_lattice_point *behind,
                                 long double front_distance, long double behind_distance)
{
    long double t = front_distance / (front_distance - behind_distance);
    return (ref_lattice_point){between(front->x, behind->x, t), between(front->y, behind->y, t),
                               between(front->z, behind->z, t)};
}

long double ref_split_distance(const ref_plane *plane, const ref_lattice_point *point)
{
    const ref_point p = {point->x / REF_ONE, point->y / REF_ONE, point->z / REF_ONE};
    return ref_plane_distance(plane, &p);
}

/* Writes the points of one side: those at sign * distance >= 0, and the intersections. Returns false
 * where they are too many. */
static bool part(const ref_piece *in, const long double *distances, int sign, ref_piece *out)
{
    ref_lattice_point points[2 * REF_POLYGON_CAPACITY];
    int count = 0;
    for (int i = 0; i < in->count; i++) {
        int next = (i + 1) % in->count;
        long double here = distances[i], there = distances[next];
        if (sign * here >= 0) {
            points[count++] = in->points[i];
        }
        if (here > 0 && there < 0) {
            points[count++] = ref_split_edge(&in->points[i], &in->points[next], here, there);
        } else if (here < 0 && there > 0) {
            points[count++] = ref_split_edge(&in->points[next], &in->points[i], there, here);
        }
    }
    if (count > REF_POLYGON_CAPACITY) {
        return false;
    }
    out->count = count;
    memcpy(out->points, points, (size_t)count * sizeof *points);
    return true;
}

ref_split_result ref_split_piece(const ref_piece *in, const ref_plane *plane, ref_piece *front,
                                 ref_piece *back)
{
    long double distances[REF_POLYGON_CAPACITY];
    bool before = false, behind = false;
    for (int i = 0; i < in->count; i++) {
        distances[i] = ref_split_distance(plane, &in->points[i]);
        before = before || distances[i] > 0;
        behind = behind || distances[i] < 0;
    }
    if (!behind) {
        return REF_SPLIT_FRONT;
    }
    if (!before) {
        return REF_SPLIT_BACK;
    }
    return part(in, distances, 1, front) && part(in, distances, -1, back) ? REF_SPLIT_BOTH
                                                                          : REF_SPLIT_CAPACITY;
}

static bool same(const ref_lattice_point *a, const ref_lattice_point *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

/* Tells whether two points are the ends of an edge, in either direction. */
static bool is_edge(const ref_piece *shape, int i, const ref_lattice_point ends[2])
{
    const ref_lattice_point *here = &shape->points[i];
    const ref_lattice_point *next = &shape->points[(i + 1) % shape->count];
    return (same(here, &ends[0]) && same(next, &ends[1])) ||
           (same(here, &ends[1]) && same(next, &ends[0]));
}

bool ref_piece_insert(ref_piece *piece, const ref_lattice_point ends[2],
                      const ref_lattice_point *point, int most)
{
    for (int i = piece->count - 1; i >= 0; i--) {
        if (!is_edge(piece, i, ends)) {
            continue;
        }
        if (piece->count == most) {
            return false;
        }
        for (int k = piece->count++; k > i + 1; k--) {
            piece->points[k] = piece->points[k - 1];
        }
        piece->points[i + 1] = *point;
    }
    return true;
}

/* How far a point lies in front of a node's plane, in units of 2^-46; exact. */
static ref_exact height(const ref_scene *scene, const ref_bsp_node *node,
                        const ref_lattice_point *point)
{
    const ref_lattice_point *centre = &scene->instances[scene->bsp_instance].centre;
    return (ref_exact)node->normal[0] * ((int64_t)point->x - centre->x) +
           (ref_exact)node->normal[1] * ((int64_t)point->y - centre->y) +
           (ref_exact)node->normal[2] * ((int64_t)point->z - centre->z) - node->distance;
}

bool ref_bsp_is_front(const ref_scene *scene, const ref_bsp_node *node,
                      const ref_lattice_point *point)
{
    return height(scene, node, point) > 0;
}

bool ref_bsp_append(ref_bsp_pieces *to, const ref_bsp_piece *piece)
{
    ref_bsp_piece *pieces = ref_grown(to->pieces, to->count, &to->capacity, 64, sizeof *pieces);
    if (!pieces) {
        return false;
    }
    to->pieces = pieces;
    to->pieces[to->count++] = *piece;
    return true;
}

/* Inserts an intersection into every piece that has the edge, except those at the node. Returns
 * false where a piece gets too many vertices. */
static bool insert_into_others(ref_bsp_pieces *all, size_t first, uint32_t node,
                               const ref_lattice_point ends[2],
                               const ref_lattice_point *intersection)
{
    for (size_t p = first; p < all->count; p++) {
        if ((all->pieces[p].in_leaf || all->pieces[p].node != node) &&
            !ref_piece_insert(&all->pieces[p].shape, ends, intersection, REF_FACE_VERTICES_MAX)) {
            return false;
        }
    }
    return true;
}

static void move_down(const ref_scene *scene, ref_bsp_piece *piece, bool behind)
{
    const ref_bsp_node *node = &scene->bsp_nodes[piece->node];
    uint32_t below = behind ? node->back : node->front;
    piece->behind = behind;
    piece->in_leaf = below == REF_BSP_NONE;
    piece->node = piece->in_leaf ? piece->node : below;
}

static bool append_corner(ref_piece *part, const ref_lattice_point *point)
{
    if (part->count == REF_FACE_VERTICES_MAX) {
        return false;
    }
    part->points[part->count++] = *point;
    return true;
}

/* Divides a piece into both parts, and inserts each intersection into the other pieces. Returns
 * false where one gets too many vertices. */
static bool divide(const ref_scene *scene, ref_bsp_pieces *all, size_t first,
                   const ref_bsp_piece *piece, ref_piece *front, ref_piece *back)
{
    const ref_bsp_node *node = &scene->bsp_nodes[piece->node];
    const ref_piece *shape = &piece->shape;
    bool fits = true;
    front->count = back->count = 0;
    for (int i = 0; i < shape->count && fits; i++) {
        const ref_lattice_point ends[2] = {shape->points[i], shape->points[(i + 1) % shape->count]};
        const ref_exact here = height(scene, node, &ends[0]), there = height(scene, node, &ends[1]);
        fits = (here < 0 || append_corner(front, &ends[0])) &&
               (here > 0 || append_corner(back, &ends[0]));
        if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
            const bool down = here > 0;
            const ref_lattice_point intersection =
                ref_split_edge(&ends[!down], &ends[down], (long double)(down ? here : there),
                               (long double)(down ? there : here));
            fits = fits && insert_into_others(all, first, piece->node, ends, &intersection) &&
                   append_corner(front, &intersection) && append_corner(back, &intersection);
        }
    }
    return fits;
}

static ref_bsp_result cut_piece(const ref_scene *scene, ref_bsp_pieces *all, size_t first,
                                size_t number)
{
    ref_bsp_piece *piece = &all->pieces[number];
    bool ahead = false, behind = false;
    for (int i = 0; i < piece->shape.count; i++) {
        ref_exact above = height(scene, &scene->bsp_nodes[piece->node], &piece->shape.points[i]);
        ahead = ahead || above > 0;
        behind = behind || above < 0;
    }
    if (!ahead || !behind) {
        move_down(scene, piece, behind);
        return REF_BSP_CUT;
    }
    const ref_bsp_piece whole = *piece;
    ref_bsp_piece front = whole, back = whole;
    if (!divide(scene, all, first, &whole, &front.shape, &back.shape)) {
        return REF_BSP_WHOLE;
    }
    move_down(scene, &front, false);
    move_down(scene, &back, true);
    all->pieces[number] = front;
    return ref_bsp_append(all, &back) ? REF_BSP_CUT : REF_BSP_MEMORY;
}

bool ref_bsp_faces(const ref_scene *scene, uint32_t number, const ref_lattice_point *eye,
                   ref_bsp_pieces *pieces)
{
    const ref_instance *instance = &scene->instances[number];
    const ref_model *model = &scene->models[instance->model];
    for (uint32_t i = 0; i < model->face_count; i++) {
        const ref_face *face = &scene->faces[model->first_face + i];
        ref_bsp_piece piece = {.instance = number, .face = i, .shape = {.count = face->count}};
        for (int k = 0; k < face->count; k++) {
            piece.shape.points[k] = ref_face_vertex(scene, instance, face, k);
        }
        if (ref_face_is_front(scene, instance, face, eye) && !ref_bsp_append(pieces, &piece)) {
            return false;
        }
    }
    return true;
}

ref_bsp_result ref_bsp_cut(const ref_scene *scene, uint32_t instance, const ref_lattice_point *eye,
                           ref_bsp_pieces *pieces)
{
    const size_t first = pieces->count;
    if (!ref_bsp_faces(scene, instance, eye, pieces)) {
        return REF_BSP_MEMORY;
    }
    ref_bsp_result result = REF_BSP_CUT;
    for (uint32_t node = 0; node < scene->bsp_node_count; node++) {
        const size_t count = pieces->count;
        for (size_t i = first; i < count && result == REF_BSP_CUT; i++) {
            if (!pieces->pieces[i].in_leaf && pieces->pieces[i].node == node) {
                result = cut_piece(scene, pieces, first, i);
            }
        }
    }
    if (result != REF_BSP_CUT) {
        pieces->count = first;
    }
    return result;
}
