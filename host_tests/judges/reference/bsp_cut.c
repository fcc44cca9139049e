/* SPDX-License-Identifier: MIT */
#include "reference/bsp_cut.h"

#include "reference/cull.h"
#include "reference/grow.h"

__extension__ typedef __int128 wide;

/* How far a point lies in front of a node's plane, in units of 2^-46; exact. */
static wide height(const ref_scene *scene, const ref_bsp_node *node, const ref_lattice_point *point)
{
    const ref_lattice_point *centre = &scene->instances[scene->bsp_instance].centre;
    return (wide)node->normal[0] * ((int64_t)point->x - centre->x) +
           (wide)node->normal[1] * ((int64_t)point->y - centre->y) +
           (wide)node->normal[2] * ((int64_t)point->z - centre->z) - node->distance;
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

/* Inserts an intersection into every piece that has the edge, except those at the node. Returns
 * false where a piece gets too many vertices. */
static bool insert_into_others(ref_bsp_pieces *all, size_t first, uint32_t node,
                               const ref_lattice_point ends[2],
                               const ref_lattice_point *intersection)
{
    for (size_t p = first; p < all->count; p++) {
        ref_piece *shape = &all->pieces[p].shape;
        if (!all->pieces[p].in_leaf && all->pieces[p].node == node) {
            continue;
        }
        for (int i = shape->count - 1; i >= 0; i--) {
            if (!is_edge(shape, i, ends)) {
                continue;
            }
            if (shape->count == REF_FACE_VERTICES_MAX) {
                return false;
            }
            for (int k = shape->count; k > i + 1; k--) {
                shape->points[k] = shape->points[k - 1];
            }
            shape->points[i + 1] = *intersection;
            shape->count++;
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

static bool keep(ref_piece *part, const ref_lattice_point *point)
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
        const wide here = height(scene, node, &ends[0]), there = height(scene, node, &ends[1]);
        fits = (here < 0 || keep(front, &ends[0])) && (here > 0 || keep(back, &ends[0]));
        if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
            const bool down = here > 0;
            const ref_lattice_point intersection =
                ref_split_edge(&ends[!down], &ends[down], (long double)(down ? here : there),
                               (long double)(down ? there : here));
            fits = fits && insert_into_others(all, first, piece->node, ends, &intersection) &&
                   keep(front, &intersection) && keep(back, &intersection);
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
        wide above = height(scene, &scene->bsp_nodes[piece->node], &piece->shape.points[i]);
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
