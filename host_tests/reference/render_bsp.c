/* SPDX-License-Identifier: MIT */
#include "reference/render_bsp.h"

#include <stdlib.h>

#include "reference/camera.h"
#include "reference/cull.h"
#include "reference/bsp.h"

typedef struct {
    ref_renderer *renderer;
    const ref_scene *scene;
    bool in_sight; /* the tree's object */
    ref_bsp_pieces pieces;
} visit;

static bool take_node_faces(const visit *at, const ref_bsp_node *node)
{
    const ref_scene *scene = at->scene;
    const ref_instance *instance = &scene->instances[scene->bsp_instance];
    const ref_model *model = &scene->models[instance->model];
    for (uint32_t i = node->first_face; at->in_sight && i < node->first_face + node->face_count;
         i++) {
        const ref_face *face = &scene->faces[model->first_face + i];
        at->renderer->counters.in++;
        if (!ref_face_is_front(scene, instance, face, &at->renderer->eye)) {
            at->renderer->counters.backfacing++;
        } else if (!ref_submit_face(at->renderer, scene->bsp_instance, i)) {
            return false;
        }
    }
    return true;
}

static bool take_leaf(const visit *at, uint32_t node, bool behind)
{
    ref_counters counted_already = {0};
    for (size_t i = 0; i < at->pieces.count; i++) {
        const ref_bsp_piece *piece = &at->pieces.pieces[i];
        if (piece->node != node || piece->behind != behind) {
            continue;
        }
        const ref_model *model = &at->scene->models[at->scene->instances[piece->instance].model];
        ref_polygon polygon = {.colour = at->scene->faces[model->first_face + piece->face].colour,
                               .count = piece->shape.count};
        for (int k = 0; k < polygon.count; k++) {
            polygon.vertices[k].position = ref_point_from_lattice(&piece->shape.points[k]);
        }
        if (!ref_submit_polygon(at->renderer, &polygon, piece->instance, piece->face,
                                &counted_already)) {
            return false;
        }
    }
    return true;
}

/* Far to near: what is on the side where the eye is not, the plane, the eye's side. */
static bool take_side(const visit *at, uint32_t number, bool behind);

static bool take_node(const visit *at, uint32_t number)
{
    const ref_bsp_node *node = &at->scene->nodes[number];
    bool eye_behind = !ref_bsp_is_front(at->scene, node, &at->renderer->eye);
    return take_side(at, number, !eye_behind) && take_node_faces(at, node) &&
           take_side(at, number, eye_behind);
}

static bool take_side(const visit *at, uint32_t number, bool behind)
{
    const ref_bsp_node *node = &at->scene->nodes[number];
    uint32_t below = behind ? node->back : node->front;
    return below == REF_NODE_NONE ? take_leaf(at, number, behind) : take_node(at, below);
}

/* Every face of an object that may move, once. */
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
        ref_face_to_polygon(renderer->scene, instance, face, &polygon);
        if (!ref_submit_polygon(renderer, &polygon, number, REF_NO_FACE, &renderer->counters)) {
            return false;
        }
    }
    return true;
}

/* An object that was not cut: its faces, whole, in the leaf of its centre. */
static bool put_whole(const ref_renderer *renderer, uint32_t number, ref_bsp_pieces *pieces)
{
    const ref_scene *scene = renderer->scene;
    const ref_instance *instance = &scene->instances[number];
    const size_t first = pieces->count;
    uint32_t node = 0, below = 0;
    bool behind = false;
    while (below != REF_NODE_NONE) {
        node = below;
        behind = !ref_bsp_is_front(scene, &scene->nodes[node], &instance->centre);
        below = behind ? scene->nodes[node].back : scene->nodes[node].front;
    }
    if (!ref_bsp_faces(scene, number, &renderer->eye, pieces)) {
        return false;
    }
    for (size_t i = first; i < pieces->count; i++) {
        pieces->pieces[i].node = node;
        pieces->pieces[i].in_leaf = true;
        pieces->pieces[i].behind = behind;
    }
    return true;
}

static bool cut_mover(visit *at, uint32_t number)
{
    if (!count_faces(at->renderer, number)) {
        return false;
    }
    switch (ref_bsp_cut(at->scene, number, &at->renderer->eye, &at->pieces)) {
    case REF_BSP_CUT:
        return true;
    case REF_BSP_WHOLE:
        at->renderer->unsplit++;
        return put_whole(at->renderer, number, &at->pieces);
    case REF_BSP_MEMORY:
        break;
    }
    return false;
}

/* The entries of the tree's layer. */
static bool take_layer(ref_renderer *renderer, const ref_order_entry *entries, uint32_t count)
{
    visit at = {.renderer = renderer, .scene = renderer->scene};
    bool sound = true;
    for (uint32_t i = 0; i < count && sound; i++) {
        if (entries[i].index == at.scene->bsp_instance) {
            at.in_sight = true;
        } else {
            sound = cut_mover(&at, entries[i].index);
        }
    }
    sound = sound && take_node(&at, 0);
    free(at.pieces.pieces);
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
            if (!take_layer(renderer, entries + i, end - i)) {
                return false;
            }
            i = end;
        } else if (!ref_submit_instance(renderer, entries[i++].index)) {
            return false;
        }
    }
    return true;
}
