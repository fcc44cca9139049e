/* SPDX-License-Identifier: MIT */
#include "walk_tree.h"

#include "face.h"
#include "tree_node.h"
#include "tree_pieces.h"

/* What is done of a node. */
enum {
    FIRST, /* nothing: what the walk comes to first is next */
    FACES,
    SECOND
};

/* A walk in the tree. */
typedef struct {
    const fxl_walk *on;
    const fxl_scene *scene;
    fxl_tree_room *room;
    uint32_t *sides, *busy;
    fxl_placed *placed; /* null: the tree's object is not in sight */
    fxl_face_taker take;
    fxl_point from;              /* the eye, as the tree's object sees it */
    const fxl_tree_node *asked;  /* whose sphere was asked last, */
    uint32_t answer;             /* and what it said */
    uint32_t planes;             /* those that the object's sphere may cross */
    uint32_t inside, inside_end; /* from one to the other all nodes are inside the frustum */
    bool reverse;                /* near to far */
} tree_walk;

_Static_assert(sizeof(fxl_tree_item) == 12 && sizeof(fxl_tree_vertex) == 16, "tree.h says so");

uint32_t fxl_tree_room_size(const fxl_scene *scene)
{
    uint32_t movers = fxl_tree_movers(scene);
    uint32_t size = (uint32_t)sizeof(fxl_tree_room) +
                    (scene->node_count + 31) / 32 * (uint32_t)sizeof(uint32_t);
    if (movers > 0) {
        size += (scene->node_count + 31) / 32 * (uint32_t)sizeof(uint32_t) +
                2 * scene->node_count * (uint32_t)sizeof(uint16_t) +
                movers * (uint32_t)sizeof(fxl_tree_item);
    }
    return scene->nodes == NULL ? 0 : size;
}

/* The layer's entries in the order, and which of them is the tree's. */
static void find_layer(const fxl_renderer *renderer, fxl_tree_room *room)
{
    const fxl_scene *scene = renderer->scene;
    const uint32_t layer = scene->objects[scene->tree_object].layer;
    uint32_t first = 0, end;
    while (first < renderer->in_sight && renderer->order[first].layer != layer) {
        first++;
    }
    room->owner = FXL_ITEM_NONE;
    for (end = first; end < renderer->in_sight && renderer->order[end].layer == layer; end++) {
        if (renderer->order[end].index == scene->tree_object) {
            room->owner = (uint16_t)end;
        }
    }
    room->first = (uint16_t)first;
    room->end = (uint16_t)end;
    room->movers = (uint16_t)(end - first - (room->owner != FXL_ITEM_NONE));
}

/* On which side of a node's plane the eye is, kept for as long as the walk is below it. */
static void find_side(const tree_walk *walk, uint32_t number)
{
    const uint32_t bit = (uint32_t)1 << (number & 31);
    uint32_t *word = &walk->sides[number / 32];
    *word =
        fxl_tree_is_front(&walk->scene->nodes[number], &walk->from) ? *word | bit : *word & ~bit;
}

/* The number behind the last node below this one: what comes next in the list of nodes. */
static uint32_t end_below(const fxl_tree_node *nodes, uint32_t number, uint32_t count)
{
    for (uint32_t above; (above = nodes[number].parent) != FXL_TREE_NONE; number = above) {
        if (nodes[above].front == number && nodes[above].back != FXL_TREE_NONE) {
            return nodes[above].back;
        }
    }
    return count;
}

static bool is_inside(const tree_walk *walk, uint32_t number)
{
    return number >= walk->inside && number < walk->inside_end;
}

static bool same_sphere(const fxl_tree_node *a, const fxl_tree_node *b)
{
    return a->radius == b->radius && a->centre.x == b->centre.x && a->centre.y == b->centre.y &&
           a->centre.z == b->centre.z;
}

/* Which planes a node's sphere may cross; a sphere is asked once in turn. Both coordinates are
 * within FXL_COORDINATE_MAX together: the loader has seen to it. */
static uint32_t planes_of(tree_walk *walk, uint32_t number)
{
    const fxl_view *view = walk->placed->view;
    const fxl_tree_node *node = &walk->scene->nodes[number];
    const fxl_point *origin = &walk->scene->objects[walk->scene->tree_object].centre;
    const fxl_point centre = {node->centre.x + origin->x, node->centre.y + origin->y,
                              node->centre.z + origin->z};
    if (is_inside(walk, number)) {
        return 0;
    }
    if (walk->asked == NULL || !same_sphere(walk->asked, node)) {
        walk->asked = node;
        walk->answer = fxl_sphere_planes(&view->camera, &view->view_frustum, &centre, node->radius);
        if (walk->answer != FXL_SPHERE_OUTSIDE) {
            walk->answer &= walk->planes; /* the object's own sphere may be the tighter */
        }
    }
    return walk->answer;
}

/* Whether nothing from the node down is in sight: then its faces are counted. Where all of it is
 * inside the frustum, nothing below is asked again. */
static bool leave_out(tree_walk *walk, uint32_t number)
{
    const fxl_scene *scene = walk->scene;
    const uint32_t above = scene->nodes[number].parent;
    if (walk->placed == NULL || is_inside(walk, number) ||
        (above != FXL_TREE_NONE && same_sphere(&scene->nodes[number], &scene->nodes[above]))) {
        return false;
    }
    uint32_t planes = planes_of(walk, number);
    if (planes != 0 && planes != FXL_SPHERE_OUTSIDE) {
        return false;
    }
    uint32_t end = end_below(scene->nodes, number, scene->node_count);
    if (planes == 0) {
        walk->inside = number;
        walk->inside_end = end;
        return false;
    }
    if (walk->room->movers > 0 && (walk->busy[number / 32] >> (number & 31) & 1u) != 0) {
        return false;
    }
    uint32_t faces = (end < scene->node_count
                          ? scene->nodes[end].first_face
                          : scene->models[scene->objects[scene->tree_object].model].face_count) -
                     scene->nodes[number].first_face;
    walk->on->counters->in += faces;
    walk->on->counters->outside += faces;
    return true;
}

/* The node's faces that face the eye, from place->index on; the others are counted. */
static bool walk_faces(tree_walk *walk, fxl_tree_place *place)
{
    const fxl_tree_node *node = &walk->scene->nodes[place->node];
    const fxl_model *model =
        &walk->scene->models[walk->scene->objects[walk->scene->tree_object].model];
    const fxl_face *faces = &walk->scene->faces[model->first_face + node->first_face];
    fxl_counters *counters = walk->on->counters;
    if (walk->placed == NULL || node->face_count == 0) {
        return true;
    }
    uint32_t planes = planes_of(walk, place->node);
    if (planes == FXL_SPHERE_OUTSIDE) {
        counters->in += node->face_count;
        counters->outside += node->face_count;
        return true;
    }
    walk->placed->planes = (fxl_planes)planes;
    for (; place->index < node->face_count; place->index++) {
        const fxl_face *face =
            &faces[walk->reverse ? node->face_count - 1 - place->index : place->index];
        if (!fxl_placed_face_is_front(walk->placed, face)) {
            counters->backfacing += 1;
        } else if (!walk->take(walk->on, walk->placed, face)) {
            return false;
        }
        counters->in += 1;
    }
    return true;
}

/* Whether the walk comes to what is in front of a node first: far to near, what is not
 * on the eye's side. */
static bool begins_in_front(const tree_walk *walk, uint32_t node)
{
    return (walk->sides[node / 32] >> (node & 31) & 1u) == walk->reverse; /* bug: tree-near-first */
}

static void step(fxl_tree_place *place, uint32_t node, uint32_t phase)
{
    place->node = (uint16_t)node;
    place->phase = (uint16_t)phase;
    place->index = 0;
    place->face = 0;
}

/* Up to the next node of which something is left to do; false where there is none. */
static bool go_up(const tree_walk *walk, fxl_tree_place *place)
{
    uint32_t node = place->node, from;
    do {
        from = node;
        node = walk->scene->nodes[from].parent;
        if (node == FXL_TREE_NONE) {
            return false;
        }
    } while ((walk->scene->nodes[node].front == from) != begins_in_front(walk, node));
    step(place, node, FACES);
    return true;
}

/* What is to do at a node and in its leaves; false where it was stopped. Else *place is at a
 * node below, or all is done here: then *more is false. */
static bool work_at(tree_walk *walk, fxl_tree_place *place, bool *more)
{
    const fxl_tree_node *node = &walk->scene->nodes[place->node];
    *more = true;
    if (place->phase == FIRST && place->index == 0 && place->face == 0) {
        find_side(walk, place->node);
        if (leave_out(walk, place->node)) {
            *more = false;
            return true;
        }
    }
    if (place->phase == FACES) {
        if (!walk_faces(walk, place)) {
            return false;
        }
        step(place, place->node, SECOND);
    }
    bool front = begins_in_front(walk, place->node) == (place->phase == FIRST);
    uint32_t below = front ? node->front : node->back;
    if (below != FXL_TREE_NONE) {
        step(place, below, FIRST);
        return true;
    }
    if (walk->room->movers > 0 &&
        !fxl_tree_walk_leaf(walk->on, walk->room, 2u * place->node + !front, place)) {
        return false;
    }
    *more = place->phase == FIRST;
    if (*more) {
        step(place, place->node, FACES);
    }
    return true;
}

/* From the place to the end of the tree, without a stack: a node knows its parent. False where
 * it was stopped. */
static bool walk_nodes(tree_walk *walk, fxl_tree_place *place)
{
    do {
        bool more = true;
        while (more) {
            if (!work_at(walk, place, &more)) {
                return false;
            }
        }
    } while (go_up(walk, place));
    return true;
}

/* The tree's layer. False where it was stopped: where the list was full, the room has the place. */
static bool walk_layer(const fxl_walk *on, fxl_tree_room *room, const fxl_tree_parts *parts)
{
    fxl_renderer *renderer = on->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_object *object = &scene->objects[scene->tree_object];
    const fxl_point *eye = &renderer->view.camera.position;
    fxl_placed placed;
    /* Eye and centre are within FXL_COORDINATE_MAX: below 2^30. */
    tree_walk walk = {
        .on = on,
        .scene = scene,
        .room = room,
        .sides = parts->sides,
        .busy = parts->busy,
        .take = on->take,
        .from = {eye->x - object->centre.x, eye->y - object->centre.y, eye->z - object->centre.z},
        .reverse = renderer->hidden->front_to_back};
    if (room->owner != FXL_ITEM_NONE) {
        fxl_place_object(&placed, scene, object, renderer->order[room->owner].planes,
                         &renderer->view, &renderer->cache);
        walk.placed = &placed;
        walk.planes = placed.planes;
        walk.inside_end = walk.planes == 0 ? scene->node_count : 0;
        walk.take = fxl_walk_taker_of(on, object, &scene->models[object->model]);
    }
    fxl_tree_place place = {0, 0, 0, FIRST};
    if (on->place->faces != 0) {
        place = room->rest;
    }
    bool done = walk_nodes(&walk, &place);
    if (!done && on->band == NULL) {
        room->rest = place;   /* bug: tree-rest */
        on->place->faces = 1; /* the rest is in the room */
    }
    return done;
}

bool fxl_walk_by_tree(const fxl_walk *on)
{
    fxl_renderer *renderer = on->renderer;
    const uint32_t count = renderer->in_sight;
    if (renderer->scene->nodes == NULL) {
        return fxl_walk_by_distance(on);
    }
    fxl_tree_room *room = renderer->walk_room;
    fxl_tree_parts parts = fxl_tree_parts_of(renderer->scene, room);
    if (on->band == NULL) {
        find_layer(renderer, room);
        fxl_tree_cut_movers(on, room);
    }
    while (on->place->objects < count) {
        const uint32_t number = on->place->objects;
        const uint32_t at = renderer->hidden->front_to_back ? count - 1 - number : number;
        const bool by_tree = at >= room->first && at < room->end;
        if (!(by_tree ? walk_layer(on, room, &parts) : fxl_walk_object(on, &renderer->order[at]))) {
            return false;
        }
        on->place->objects =
            (uint16_t)(number + (by_tree ? (uint32_t)(room->end - room->first) : 1u));
        on->place->faces = 0;
    }
    return true;
}
