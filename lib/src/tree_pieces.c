/* SPDX-License-Identifier: MIT */
#include "tree_pieces.h"

#include "face.h"
#include "tree_cut.h"
#include "tree_node.h"

uint32_t fxl_tree_movers(const fxl_scene *scene)
{
    uint32_t count = 0;
    if (scene->nodes != NULL) {
        const uint32_t layer = scene->objects[scene->tree_object].layer;
        for (uint32_t i = 0; i < scene->object_count; i++) {
            count += scene->objects[i].layer == layer;
        }
        count -= 1; /* the tree's own */
    }
    return count;
}

fxl_tree_parts fxl_tree_parts_of(const fxl_scene *scene, fxl_tree_room *room)
{
    fxl_tree_parts parts;
    parts.movers = fxl_tree_movers(scene);
    parts.sides = (uint32_t *)(room + 1);
    parts.busy = parts.sides + (scene->node_count + 31) / 32;
    parts.leaves = (uint16_t *)(parts.busy + (scene->node_count + 31) / 32);
    parts.whole = (fxl_tree_item *)(void *)(parts.leaves + 2 * scene->node_count);
    parts.items = room->pieces;
    parts.vertices =
        room->pieces == NULL
            ? NULL
            : (fxl_tree_vertex *)(void *)((uint8_t *)room->pieces + (room->pieces_size & ~3u));
    return parts;
}

static fxl_tree_item *item_of(const fxl_tree_parts *parts, uint32_t number)
{
    return number < parts->movers ? &parts->whole[number] : &parts->items[number - parts->movers];
}

/* Behind what is in the leaf in the order of drawing: before it, where that is walked
 * backward. */
static void put_into_leaf(const fxl_scene *scene, const fxl_tree_parts *parts, uint32_t number,
                          bool reverse)
{
    fxl_tree_item *item = item_of(parts, number);
    uint32_t node = (item->where & ~FXL_IN_LEAF) / 2;
    while (node != FXL_TREE_NONE && (parts->busy[node / 32] >> (node & 31) & 1u) == 0) {
        parts->busy[node / 32] |= (uint32_t)1 << (node & 31);
        node = scene->nodes[node].parent;
    }
    uint16_t *link = &parts->leaves[item->where & ~FXL_IN_LEAF];
    while (!reverse && *link != FXL_ITEM_NONE) {
        link = &item_of(parts, *link)->next;
    }
    item->next = *link;
    *link = (uint16_t)number;
}

/* What a face that faces the eye comes to, whole. */
static fxl_fate fate_of(fxl_renderer *renderer, const fxl_placed *placed, const fxl_face *face)
{
    const fxl_clipper *clipper = renderer->clipper;
    fxl_clip_result cut = clipper->clip(placed, face, &renderer->work.clip, &renderer->screen);
    fxl_fate fate = (fxl_fate)1 << cut;
    while ((cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_CUT) && clipper->next != NULL) {
        cut = clipper->next(placed, &renderer->work.clip, &renderer->screen);
        fate |= (fxl_fate)1 << cut;
    }
    return fate;
}

/* Each face once, however many pieces it will be in. */
static void count_faces(const fxl_walk *on, const fxl_order_entry *entry)
{
    fxl_renderer *renderer = on->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_object *object = &scene->objects[entry->index];
    const fxl_model *model = &scene->models[object->model];
    fxl_placed placed;
    fxl_place_object(&placed, scene, object, entry->planes, &renderer->view, &renderer->cache);
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        on->counters->in += 1;
        if (fxl_placed_face_is_front(&placed, face)) {
            (void)fxl_walk_account(on, fate_of(renderer, &placed, face), renderer->list.used);
        } else {
            on->counters->backfacing += 1;
        }
    }
}

/* The leaf where a point of the world is. */
static uint32_t leaf_of(const fxl_scene *scene, const fxl_point *point)
{
    const fxl_point *centre = &scene->objects[scene->tree_object].centre;
    const fxl_point from = {point->x - centre->x, point->y - centre->y, point->z - centre->z};
    uint32_t node = 0;
    for (;;) {
        bool front = fxl_tree_is_front(&scene->nodes[node], &from);
        uint32_t below = front ? scene->nodes[node].front : scene->nodes[node].back;
        if (below == FXL_TREE_NONE) {
            return 2 * node + !front;
        }
        node = below;
    }
}

void fxl_tree_cut_movers(const fxl_walk *on, fxl_tree_room *room)
{
    fxl_renderer *renderer = on->renderer;
    const fxl_scene *scene = renderer->scene;
    const bool reverse = renderer->hidden->front_to_back;
    fxl_tree_parts parts = fxl_tree_parts_of(scene, room);
    fxl_tree_cutter cutter = {.scene = scene, .parts = &parts};
    room->unsplit = room->used = room->refused = 0;
    if (room->movers == 0) {
        return;
    }
    cutter.capacity = room->pieces == NULL ? 0 : room->pieces_size & ~3u;
    for (uint32_t leaf = 0; leaf < 2 * scene->node_count; leaf++) {
        parts.leaves[leaf] = FXL_ITEM_NONE;
    }
    for (uint32_t i = 0; i < (scene->node_count + 31) / 32; i++) {
        parts.busy[i] = 0;
    }
    uint32_t mover = 0;
    for (uint32_t at = room->first; at < room->end; at++) {
        if (at == room->owner) {
            continue;
        }
        const fxl_object *object = &scene->objects[renderer->order[at].index];
        count_faces(on, &renderer->order[at]);
        if (fxl_tree_cut(&cutter, object, &renderer->view.camera.position, at)) {
            for (uint32_t i = cutter.first_item; i < cutter.item_count; i++) {
                put_into_leaf(scene, &parts, parts.movers + i, reverse);
            }
        } else {
            fxl_tree_item whole = {FXL_IN_LEAF | leaf_of(scene, &object->centre),
                                   FXL_ITEM_NONE,
                                   (uint16_t)at,
                                   FXL_ITEM_NONE,
                                   0,
                                   0};
            parts.whole[mover] = whole;
            put_into_leaf(scene, &parts, mover, reverse);
            room->unsplit += 1;
        }
        mover += 1;
    }
    room->used = cutter.most;
}

/* The faces of an object that is in no pieces, from *number on, in the order of the walk. */
static bool walk_whole(const fxl_walk *on, const fxl_order_entry *entry, uint16_t *number)
{
    fxl_renderer *renderer = on->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_object *object = &scene->objects[entry->index];
    const fxl_model *model = &scene->models[object->model];
    const fxl_face_taker take = fxl_walk_taker_of(on, object, model);
    fxl_placed placed;
    fxl_place_object(&placed, scene, object, entry->planes, &renderer->view, &renderer->cache);
    for (; *number < model->face_count; *number += 1) {
        uint32_t at = renderer->hidden->front_to_back ? model->face_count - 1u - *number : *number;
        const fxl_face *face = &scene->faces[model->first_face + at];
        if (fxl_placed_face_is_front(&placed, face) && !take(on, &placed, face)) {
            return false;
        }
    }
    *number = 0;
    return true;
}

static bool walk_piece(const fxl_walk *on, const fxl_tree_parts *parts, const fxl_tree_item *item)
{
    const fxl_renderer *renderer = on->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_order_entry *entry = &renderer->order[item->entry];
    const fxl_object *object = &scene->objects[entry->index];
    const fxl_light *light = renderer->light;
    fxl_point points[FXL_FACE_VERTICES_MAX];
    uint32_t vertex = item->first;
    for (uint32_t i = 0; i < item->count; i++) {
        const fxl_tree_vertex *from = fxl_tree_vertex_of(parts, vertex);
        points[i] = from->point;
        vertex = from->next;
    }
    fxl_pieces pieces;
    fxl_walk_pieces_begin(&pieces, on);
    pieces.planes = entry->planes;
    if (light != NULL &&
        light->reaches(light, &object->centre, scene->models[object->model].radius)) {
        const fxl_face face = {.count = item->count, .colour = item->colour};
        (void)light->split(light, &pieces, &face, points, item->count);
    } else {
        (void)fxl_walk_piece(&pieces, points, item->count, item->colour);
    }
    return fxl_walk_pieces_end(&pieces);
}

bool fxl_tree_walk_leaf(const fxl_walk *on, fxl_tree_room *room, uint32_t leaf,
                        fxl_tree_place *place)
{
    const fxl_renderer *renderer = on->renderer;
    const fxl_tree_parts parts = fxl_tree_parts_of(renderer->scene, room);
    uint32_t number = parts.leaves[leaf];
    for (uint32_t done = 0; number != FXL_ITEM_NONE; done++) {
        const fxl_tree_item *item = item_of(&parts, number);
        number = item->next;
        if (done < place->index) {
            continue;
        }
        fxl_counters counters = {0}; /* the faces are counted already */
        fxl_walk uncounted = *on;
        uncounted.counters = &counters;
        bool whole = item->first == FXL_ITEM_NONE;
        bool fitted = whole ? walk_whole(&uncounted, &renderer->order[item->entry], &place->face)
                            : walk_piece(&uncounted, &parts, item);
        on->counters->spilled += counters.spilled;
        if (!fitted) {
            return false;
        }
        if (!whole && on->counters == &renderer->counters) {
            room->refused += counters.refused;
        }
        place->index += 1;
    }
    return true;
}
