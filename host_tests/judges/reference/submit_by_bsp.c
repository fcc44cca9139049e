/* SPDX-License-Identifier: MIT */
#include "reference/submit_by_bsp.h"

#include <math.h>
#include <stdlib.h>

#include "reference/billboard.h"
#include "reference/camera.h"
#include "reference/placement.h"
#include "reference/cull.h"
#include "reference/split.h"

typedef struct {
    ref_renderer *renderer;
    const ref_scene *scene;
    bool is_visible; /* the BSP's instance is visible */
    ref_bsp_pieces pieces;
} bsp_traversal;

static bool submit_node_faces(const bsp_traversal *traversal, const ref_bsp_node *node)
{
    const ref_scene *scene = traversal->scene;
    const ref_instance *instance = &scene->instances[scene->bsp_instance];
    const ref_model *model = &scene->models[instance->model];
    for (uint32_t i = node->first_face;
         traversal->is_visible && i < node->first_face + node->face_count; i++) {
        const ref_face *face = &scene->faces[model->first_face + i];
        traversal->renderer->counters.in++;
        if (!ref_face_is_front(scene, instance, face, &traversal->renderer->eye)) {
            traversal->renderer->counters.backfacing++;
        } else if (!ref_submit_face(traversal->renderer, scene->bsp_instance, i)) {
            return false;
        }
    }
    return true;
}

static bool submit_leaf(const bsp_traversal *traversal, uint32_t node, bool behind)
{
    ref_counters counted_already = {0};
    for (size_t i = 0; i < traversal->pieces.count; i++) {
        const ref_bsp_piece *piece = &traversal->pieces.pieces[i];
        if (piece->node != node || piece->behind != behind) {
            continue;
        }
        const ref_instance *instance = &traversal->scene->instances[piece->instance];
        if (ref_billboard_of(traversal->scene, instance)) {
            if (!ref_submit_instance(traversal->renderer, piece->instance)) {
                return false;
            }
            continue;
        }
        if (!ref_submit_piece(traversal->renderer, &piece->shape, piece->instance, piece->face,
                              &counted_already)) {
            return false;
        }
    }
    return true;
}

/* Far to near: the side on which the eye is not, then the plane, then the side of the eye. */
static bool submit_side(const bsp_traversal *traversal, uint32_t number, bool behind);

static bool submit_node(const bsp_traversal *traversal, uint32_t number)
{
    const ref_bsp_node *node = &traversal->scene->bsp_nodes[number];
    bool eye_behind = !ref_bsp_is_front(traversal->scene, node, &traversal->renderer->eye);
    return submit_side(traversal, number, !eye_behind) && submit_node_faces(traversal, node) &&
           submit_side(traversal, number, eye_behind);
}

static bool submit_side(const bsp_traversal *traversal, uint32_t number, bool behind)
{
    const ref_bsp_node *node = &traversal->scene->bsp_nodes[number];
    uint32_t below = behind ? node->back : node->front;
    return below == REF_BSP_NONE ? submit_leaf(traversal, number, behind)
                                 : submit_node(traversal, below);
}

/* Counts every face of a moving instance once. */
static bool count_faces(ref_renderer *renderer, uint32_t number)
{
    const ref_instance *instance = &renderer->scene->instances[number];
    const ref_model *model = &renderer->scene->models[instance->model];
    for (uint32_t i = 0; i < model->face_count; i++) {
        const ref_face *face = &renderer->scene->faces[model->first_face + i];
        renderer->counters.in++;
        if (!ref_face_is_front(renderer->scene, instance, face, &renderer->eye)) {
            renderer->counters.backfacing++;
            continue;
        }
        ref_polygon polygon;
        ref_face_to_polygon(renderer->scene, instance, face, true, &polygon);
        if (!ref_submit_polygon(renderer, &polygon, number, REF_NO_FACE, &renderer->counters)) {
            return false;
        }
    }
    return true;
}

/* Puts a piece into the leaf of a point. */
static void put_into_leaf(const ref_scene *scene, const ref_lattice_point *point,
                          ref_bsp_piece *piece)
{
    uint32_t below = 0;
    while (below != REF_BSP_NONE) {
        const ref_bsp_node *node = &scene->bsp_nodes[below];
        piece->node = below;
        piece->behind = !ref_bsp_is_front(scene, node, point);
        below = piece->behind ? node->back : node->front;
    }
    piece->in_leaf = true;
}

/* The faces of an instance that was not cut, whole. */
static bool put_whole(const ref_renderer *renderer, uint32_t number, ref_bsp_pieces *pieces)
{
    const size_t first = pieces->count;
    if (!ref_bsp_faces(renderer->scene, number, &renderer->eye, pieces)) {
        return false;
    }
    for (size_t i = first; i < pieces->count; i++) {
        put_into_leaf(renderer->scene, &renderer->scene->instances[number].centre,
                      &pieces->pieces[i]);
    }
    return true;
}

/* A billboard, which is never cut, in the leaf of its middle (docs/extras/bsp.md, 3.8). */
static bool put_billboard(const ref_scene *scene, uint32_t number, ref_bsp_pieces *pieces)
{
    const ref_instance *instance = &scene->instances[number];
    const ref_billboard *board = ref_billboard_of(scene, instance);
    const ref_placement *placement = ref_placement_of(scene, instance);
    ref_bsp_piece piece = {.instance = number};
    ref_lattice_point middle = instance->centre;
    middle.y += (int32_t)floor((board->height / 2 - board->anchor_y) *
                               (placement ? placement->scale : REF_ONE));
    put_into_leaf(scene, &middle, &piece);
    return ref_bsp_append(pieces, &piece);
}

static bool cut_mover(bsp_traversal *traversal, uint32_t number)
{
    if (ref_billboard_of(traversal->scene, &traversal->scene->instances[number])) {
        return put_billboard(traversal->scene, number, &traversal->pieces);
    }
    if (!count_faces(traversal->renderer, number)) {
        return false;
    }
    switch (ref_bsp_cut(traversal->scene, number, &traversal->renderer->eye, &traversal->pieces)) {
    case REF_BSP_CUT:
        return true;
    case REF_BSP_WHOLE:
        traversal->renderer->unsplit++;
        return put_whole(traversal->renderer, number, &traversal->pieces);
    case REF_BSP_MEMORY:
        break;
    }
    return false;
}

/* Submits the entries of the BSP's layer. */
static bool submit_layer(ref_renderer *renderer, const ref_order_entry *entries, uint32_t count)
{
    bsp_traversal traversal = {.renderer = renderer, .scene = renderer->scene};
    bool sound = true;
    for (uint32_t i = 0; i < count && sound; i++) {
        if (entries[i].index == traversal.scene->bsp_instance) {
            traversal.is_visible = true;
        } else {
            sound = cut_mover(&traversal, entries[i].index);
        }
    }
    sound = sound && submit_node(&traversal, 0);
    free(traversal.pieces.pieces);
    return sound;
}

bool ref_submit_by_bsp(ref_renderer *renderer, const ref_order_entry *entries, uint32_t count)
{
    const uint32_t layer = renderer->scene->instances[renderer->scene->bsp_instance].layer;
    renderer->unsplit = 0;
    for (uint32_t i = 0; i < count;) {
        uint32_t end = i;
        while (end < count && entries[end].layer == layer) {
            end++;
        }
        if (end > i) {
            if (!submit_layer(renderer, entries + i, end - i)) {
                return false;
            }
            i = end;
        } else if (!ref_submit_instance(renderer, entries[i++].index)) {
            return false;
        }
    }
    return true;
}
