/* SPDX-License-Identifier: MIT */
#include "tree_cut.h"

#include "arith.h"
#include "fixel/cull.h"
#include "fixel/split.h"
#include "tree_node.h"

/* A node's plane about to cut. */
typedef struct {
    const fxl_tree_node *node;
    fxl_point centre; /* of the tree's object */
    uint32_t number;
} knife;

/* A ring that is being made. */
typedef struct {
    uint32_t first, last, count;
} ring;

/* How far a point of the world lies in front. Both points are within FXL_COORDINATE_MAX, so
 * their difference is below 2^30, and the node's distance is at most 2^61: below 2^62. */
static fxl_q18_46 height(const knife *by, const fxl_point *point)
{
    return fxl_dot(&by->node->normal, point->x - by->centre.x, point->y - by->centre.y,
                   point->z - by->centre.z) -
           fxl_tree_distance(by->node);
}

/* Whether there is room for so much more. At most 2^16 of each are used. */
static bool has_room(const fxl_tree_cutter *cutter, uint32_t more)
{
    return fxl_tree_used(cutter) + more <= cutter->capacity;
}

/* A new vertex, or FXL_ITEM_NONE. */
static uint32_t new_vertex(fxl_tree_cutter *cutter, const fxl_point *point)
{
    if (!has_room(cutter, sizeof(fxl_tree_vertex)) || cutter->vertex_count >= FXL_ITEM_NONE) {
        return FXL_ITEM_NONE;
    }
    fxl_tree_vertex_of(cutter->parts, cutter->vertex_count)->point = *point;
    return cutter->vertex_count++;
}

static fxl_tree_item *new_item(fxl_tree_cutter *cutter)
{
    if (!has_room(cutter, sizeof(fxl_tree_item)) ||
        cutter->parts->movers + cutter->item_count >= FXL_ITEM_NONE) {
        return NULL;
    }
    return &cutter->parts->items[cutter->item_count++];
}

/* False where there is no such vertex, or too many. */
static bool append(const fxl_tree_cutter *cutter, ring *to, uint32_t vertex)
{
    if (vertex == FXL_ITEM_NONE || to->count == FXL_FACE_VERTICES_MAX) {
        return false;
    }
    if (to->count == 0) {
        to->first = vertex;
    } else {
        fxl_tree_vertex_of(cutter->parts, to->last)->next = (uint16_t)vertex;
    }
    fxl_tree_vertex_of(cutter->parts, vertex)->next = (uint16_t)to->first;
    to->last = vertex;
    to->count += 1;
    return true;
}

/* The faces that face the eye, as pieces at the root. */
static bool take_faces(fxl_tree_cutter *cutter, const fxl_object *object, const fxl_point *eye,
                       uint32_t entry)
{
    const fxl_scene *scene = cutter->scene;
    const fxl_model *model = &scene->models[object->model];
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        const uint16_t *corners = &scene->corners[face->first_corner];
        if (!fxl_face_is_front(scene, object, face, eye)) {
            continue;
        }
        fxl_tree_item *item = new_item(cutter);
        ring outline = {0, 0, 0};
        if (item == NULL) {
            return false;
        }
        for (uint32_t k = 0; k < face->count; k++) {
            const fxl_point *from = &vertices[corners[k]];
            /* Within FXL_COORDINATE_MAX: the scene is checked. */
            fxl_point point = {from->x + object->centre.x, from->y + object->centre.y,
                               from->z + object->centre.z};
            if (!append(cutter, &outline, new_vertex(cutter, &point))) {
                return false;
            }
        }
        item->where = 0;
        item->entry = (uint16_t)entry;
        item->first = (uint16_t)outline.first;
        item->count = face->count;
        item->colour = face->colour;
    }
    return true;
}

static bool same(const fxl_point *a, const fxl_point *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

/* Gives a crossing to a piece that has its edge. */
static bool share_with(fxl_tree_cutter *cutter, fxl_tree_item *item, const fxl_point *a,
                       const fxl_point *b, const fxl_point *crossing)
{
    uint32_t count = item->count, at = item->first;
    for (uint32_t i = 0; i < count; i++) {
        fxl_tree_vertex *here = fxl_tree_vertex_of(cutter->parts, at);
        const uint32_t next = here->next;
        const fxl_point *there = &fxl_tree_vertex_of(cutter->parts, next)->point;
        if ((same(&here->point, a) && same(there, b)) ||
            (same(&here->point, b) && same(there, a))) {
            uint32_t vertex = new_vertex(cutter, crossing);
            if (vertex == FXL_ITEM_NONE || item->count == FXL_FACE_VERTICES_MAX) {
                return false;
            }
            fxl_tree_vertex_of(cutter->parts, vertex)->next = (uint16_t)next;
            here->next = (uint16_t)vertex;
            item->count += 1;
        }
        at = next;
    }
    return true;
}

/* To every piece of the object that is not at the node: the others are cut by it too. */
static bool share(fxl_tree_cutter *cutter, uint32_t node, const fxl_point *a, const fxl_point *b,
                  const fxl_point *crossing)
{
    for (uint32_t i = cutter->first_item; i < cutter->item_count; i++) {
        fxl_tree_item *item = &cutter->parts->items[i];
        /* bug: leaf-unshared */
        if (item->where != node && !share_with(cutter, item, a, b, crossing)) {
            return false;
        }
    }
    return true;
}

/* The crossing of an edge into both parts. */
static bool cross(fxl_tree_cutter *cutter, const knife *by, ring parts[2], const fxl_point *ahead,
                  const fxl_point *behind)
{
    fxl_point crossing = fxl_split_edge(ahead, behind, height(by, ahead), height(by, behind));
    return share(cutter, by->number, ahead, behind, &crossing) &&
           append(cutter, &parts[0], new_vertex(cutter, &crossing)) &&
           append(cutter, &parts[1], new_vertex(cutter, &crossing));
}

/* The outline from item->first on, into its part in front and its part behind; vertices go
 * where they belong, those on the plane are doubled. */
static bool divide(fxl_tree_cutter *cutter, const knife *by, const fxl_tree_item *item,
                   ring parts[2])
{
    const fxl_point first = fxl_tree_vertex_of(cutter->parts, item->first)->point;
    uint32_t at = item->first;
    for (uint32_t i = 0; i < item->count; i++) {
        const fxl_tree_vertex *vertex = fxl_tree_vertex_of(cutter->parts, at);
        const uint32_t next = vertex->next;
        const fxl_point here = vertex->point;
        const fxl_point there =
            i + 1u == item->count ? first : fxl_tree_vertex_of(cutter->parts, next)->point;
        const fxl_q18_46 here_height = height(by, &here), there_height = height(by, &there);
        if (!append(cutter, &parts[here_height < 0], at) ||
            /* bug: plane-in-front */
            (here_height == 0 && !append(cutter, &parts[1], new_vertex(cutter, &here)))) {
            return false;
        }
        if ((here_height > 0 && there_height < 0 && !cross(cutter, by, parts, &here, &there)) ||
            (here_height < 0 && there_height > 0 && !cross(cutter, by, parts, &there, &here))) {
            return false;
        }
        at = next;
    }
    return true;
}

/* Where what is on a side of a node is next. */
static uint32_t beyond(const knife *by, bool behind)
{
    uint32_t below = behind ? by->node->back : by->node->front;
    return below != FXL_TREE_NONE ? below : (FXL_IN_LEAF | (2 * by->number + behind));
}

/* A piece at the node goes on to one side, or both. */
static bool cut_piece(fxl_tree_cutter *cutter, const knife *by, fxl_tree_item *item)
{
    bool ahead = false, behind = false;
    uint32_t at = item->first;
    for (uint32_t i = 0; i < item->count && !(ahead && behind); i++) {
        const fxl_tree_vertex *vertex = fxl_tree_vertex_of(cutter->parts, at);
        fxl_q18_46 above = height(by, &vertex->point);
        ahead = ahead || above > 0;
        behind = behind || above < 0;
        at = vertex->next;
    }
    if (!(ahead && behind)) {
        item->where = beyond(by, behind);
        return true;
    }
    ring parts[2] = {{0, 0, 0}, {0, 0, 0}};
    fxl_tree_item *rest = new_item(cutter);
    if (rest == NULL) {
        return false;
    }
    *rest = *item; /* at the node, as long as it is cut: nothing is shared with it */
    rest->count = 0;
    if (!divide(cutter, by, item, parts)) {
        return false;
    }
    item->first = (uint16_t)parts[0].first;
    item->count = (uint8_t)parts[0].count;
    item->where = beyond(by, false);
    rest->first = (uint16_t)parts[1].first;
    rest->count = (uint8_t)parts[1].count;
    rest->where = beyond(by, true);
    return true;
}

/* The lowest number of a node where pieces are; or FXL_IN_LEAF: none is at a node. */
static uint32_t next_node(const fxl_tree_cutter *cutter)
{
    uint32_t lowest = FXL_IN_LEAF;
    for (uint32_t i = cutter->first_item; i < cutter->item_count; i++) {
        uint32_t where = cutter->parts->items[i].where;
        lowest = where < lowest ? where : lowest;
    }
    return lowest;
}

static bool cut_all(fxl_tree_cutter *cutter)
{
    const fxl_scene *scene = cutter->scene;
    knife by = {NULL, scene->objects[scene->tree_object].centre, 0};
    while ((by.number = next_node(cutter)) != FXL_IN_LEAF) {
        by.node = &scene->nodes[by.number];
        const uint32_t end = cutter->item_count;
        for (uint32_t i = cutter->first_item; i < end; i++) {
            fxl_tree_item *item = &cutter->parts->items[i];
            if (item->where == by.number && !cut_piece(cutter, &by, item)) {
                return false;
            }
        }
    }
    return true;
}

bool fxl_tree_cut(fxl_tree_cutter *cutter, const fxl_object *object, const fxl_point *eye,
                  uint32_t entry)
{
    const uint32_t items = cutter->item_count, vertices = cutter->vertex_count;
    cutter->first_item = items;
    bool done = take_faces(cutter, object, eye, entry) && cut_all(cutter);
    uint32_t used = fxl_tree_used(cutter);
    cutter->most = used > cutter->most ? used : cutter->most;
    if (!done) {
        cutter->item_count = items;
        cutter->vertex_count = vertices;
    }
    return done;
}
