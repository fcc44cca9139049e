/* SPDX-License-Identifier: MIT */
#include "../clip/split.h"
#include "../scene/placement_code.h"
#include "../view/cull.h"
#include "bsp_pieces.h"

#include "../math/arith.h"
#include "../scene/bsp_node.h"

/* The split plane: that of a node. */
typedef struct {
    const fxl_bsp_node *node;
    fxl_point centre; /* of the BSP's instance */
    uint32_t number;
} split_plane;

/* A circular list of vertices that is being built. */
typedef struct {
    uint32_t first, last, count;
} vertex_ring;

/* How far a point of the world lies in front of the split plane. Both points are within
 * FXL_COORDINATE_MAX, so their difference is below 2^30, and the node's distance is at most
 * 2^61: the result is below 2^62. */
static fxl_q18_46 height(const split_plane *by, const fxl_point *point)
{
    return fxl_dot(&by->node->normal, point->x - by->centre.x, point->y - by->centre.y,
                   point->z - by->centre.z) -
           fxl_bsp_distance(by->node);
}

/* Tells whether so many more bytes fit. At most 2^16 items and 2^16 vertices are used. */
static bool has_room(const fxl_bsp_cutter *cutter, uint32_t more)
{
    return fxl_bsp_used(cutter) + more <= cutter->capacity;
}

/* Takes a new vertex of a piece of a face. Returns its number, or FXL_ITEM_NONE where memory is
 * short. */
static uint32_t new_vertex(fxl_bsp_cutter *cutter, const fxl_point *point, uint32_t face)
{
    if (!has_room(cutter, sizeof(fxl_bsp_vertex)) || cutter->vertex_count >= FXL_ITEM_NONE) {
        return FXL_ITEM_NONE;
    }
    fxl_bsp_vertex *vertex = fxl_bsp_vertex_of(cutter->parts, cutter->vertex_count);
    vertex->point = *point;
    vertex->face = (uint16_t)face;
    return cutter->vertex_count++;
}

static fxl_bsp_item *new_item(fxl_bsp_cutter *cutter)
{
    if (!has_room(cutter, sizeof(fxl_bsp_item)) ||
        cutter->parts->movers + cutter->item_count >= FXL_ITEM_NONE) {
        return NULL;
    }
    return &cutter->parts->items[cutter->item_count++];
}

/* Appends a vertex. Returns false where vertex is FXL_ITEM_NONE, or the piece would have too
 * many vertices. */
static bool append(const fxl_bsp_cutter *cutter, vertex_ring *to, uint32_t vertex)
{
    if (vertex == FXL_ITEM_NONE || to->count == FXL_FACE_VERTICES_MAX) {
        return false;
    }
    if (to->count == 0) {
        to->first = vertex;
    } else {
        fxl_bsp_vertex_of(cutter->parts, to->last)->next = (uint16_t)vertex;
    }
    fxl_bsp_vertex_of(cutter->parts, vertex)->next = (uint16_t)to->first;
    to->last = vertex;
    to->count += 1;
    return true;
}

/* The points of a face in the world. Within FXL_COORDINATE_MAX, because the scene is checked. */
/* bsp 3.2 */
static void place_face(const fxl_point *vertices, const uint16_t *indices, const fxl_face *face,
                       const fxl_instance *instance, fxl_point *points)
{
    for (uint32_t k = 0; k < face->count; k++) {
        const fxl_point *from = &vertices[indices[k]];
        points[k].x = from->x + instance->centre.x;
        points[k].y = from->y + instance->centre.y;
        points[k].z = from->z + instance->centre.z;
    }
}

/* Makes the faces that face the eye into pieces at the root. */
/* bsp 3.2 */
static bool take_faces(fxl_bsp_cutter *cutter, const fxl_instance *instance, const fxl_point *eye,
                       uint32_t entry)
{
    const fxl_scene *scene = cutter->scene;
    const fxl_model *model = &scene->models[instance->model];
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    const uint32_t number = fxl_instance_number(scene, instance);
    const fxl_placement_code *turned = fxl_placement_code_of(scene, number);
    fxl_point points[FXL_FACE_VERTICES_MAX];
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        const bool is_front = turned != NULL ? turned->face_is_front(scene, number, face, eye)
                                             : fxl_face_is_front(scene, instance, face, eye);
        if (!is_front) {
            continue;
        }
        fxl_bsp_item *item = new_item(cutter);
        vertex_ring outline = {.count = 0};
        if (item == NULL) {
            return false;
        }
        if (turned != NULL) {
            turned->place_face(scene, number, face, points);
        } else {
            place_face(vertices, fxl_face_indices(scene->indices, face), face, instance, points);
        }
        for (uint32_t k = 0; k < face->count; k++) {
            if (!append(cutter, &outline, new_vertex(cutter, &points[k], i))) {
                return false;
            }
        }
        item->where = 0;
        item->entry = (uint16_t)entry;
        item->first = (uint16_t)outline.first;
        item->count = face->count;
        item->colour = face->material;
    }
    return true;
}

static bool same(const fxl_point *a, const fxl_point *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

/* Inserts an intersection into a piece that has the edge a b. */
/* bsp 3.4 */
static bool share_with(fxl_bsp_cutter *cutter, fxl_bsp_item *item, const fxl_point *a,
                       const fxl_point *b, const fxl_point *crossing)
{
    uint32_t count = item->count, at = item->first;
    for (uint32_t i = 0; i < count; i++) {
        fxl_bsp_vertex *here = fxl_bsp_vertex_of(cutter->parts, at);
        const uint32_t next = here->next;
        const fxl_point *there = &fxl_bsp_vertex_of(cutter->parts, next)->point;
        if ((same(&here->point, a) && same(there, b)) ||
            (same(&here->point, b) && same(there, a))) {
            uint32_t vertex = new_vertex(cutter, crossing, here->face);
            if (vertex == FXL_ITEM_NONE || item->count == FXL_FACE_VERTICES_MAX) {
                return false;
            }
            fxl_bsp_vertex_of(cutter->parts, vertex)->next = (uint16_t)next;
            here->next = (uint16_t)vertex;
            item->count += 1;
        }
        at = next;
    }
    return true;
}

/* Inserts an intersection into every piece of the instance that has the edge and is not at the
 * node. The node cuts its own pieces itself. */
/* bsp 3.4 */
static bool share(fxl_bsp_cutter *cutter, uint32_t node, const fxl_point *a, const fxl_point *b,
                  const fxl_point *crossing)
{
    for (uint32_t i = cutter->first_item; i < cutter->item_count; i++) {
        fxl_bsp_item *item = &cutter->parts->items[i];
        if (item->where != node && !share_with(cutter, item, a, b, crossing)) {
            return false;
        }
    }
    return true;
}

/* Appends the intersection of an edge to both parts. */
static bool append_intersection(fxl_bsp_cutter *cutter, const split_plane *by, uint32_t face,
                                vertex_ring parts[2], const fxl_point *ahead,
                                const fxl_point *behind)
{
    fxl_point crossing = fxl_split_edge(ahead, behind, height(by, ahead), height(by, behind));
    return share(cutter, by->number, ahead, behind, &crossing) &&
           append(cutter, &parts[0], new_vertex(cutter, &crossing, face)) &&
           append(cutter, &parts[1], new_vertex(cutter, &crossing, face));
}

/* Divides the outline of an item into its part in front and its part behind. Vertices move to
 * the part that they belong to; vertices on the plane are duplicated. */
/* bsp 3.3 */
static bool divide(fxl_bsp_cutter *cutter, const split_plane *by, const fxl_bsp_item *item,
                   vertex_ring parts[2])
{
    const fxl_point first = fxl_bsp_vertex_of(cutter->parts, item->first)->point;
    const uint32_t face = fxl_bsp_vertex_of(cutter->parts, item->first)->face;
    uint32_t at = item->first;
    for (uint32_t i = 0; i < item->count; i++) {
        const fxl_bsp_vertex *vertex = fxl_bsp_vertex_of(cutter->parts, at);
        const uint32_t next = vertex->next;
        const fxl_point here = vertex->point;
        const fxl_point there =
            i + 1u == item->count ? first : fxl_bsp_vertex_of(cutter->parts, next)->point;
        const fxl_q18_46 here_height = height(by, &here), there_height = height(by, &there);
        if (!append(cutter, &parts[here_height < 0], at) ||
            (here_height == 0 && !append(cutter, &parts[1], new_vertex(cutter, &here, face)))) {
            return false;
        }
        if ((here_height > 0 && there_height < 0 &&
             !append_intersection(cutter, by, face, parts, &here, &there)) ||
            (here_height < 0 && there_height > 0 &&
             !append_intersection(cutter, by, face, parts, &there, &here))) {
            return false;
        }
        at = next;
    }
    return true;
}

/* Returns where a piece on one side of a node goes next: a node or a leaf. */
/* bsp 3.5 */
static uint32_t next_place(const split_plane *by, bool behind)
{
    uint32_t below = behind ? by->node->back : by->node->front;
    return below != FXL_BSP_NONE ? below : (FXL_IN_LEAF | (2 * by->number + behind));
}

/* Sends a piece at the node to one side, or cuts it and sends a part to each side. */
/* bsp 3.3 */
static bool cut_piece(fxl_bsp_cutter *cutter, const split_plane *by, fxl_bsp_item *item)
{
    bool ahead = false, behind = false;
    uint32_t at = item->first;
    for (uint32_t i = 0; i < item->count && !(ahead && behind); i++) {
        const fxl_bsp_vertex *vertex = fxl_bsp_vertex_of(cutter->parts, at);
        fxl_q18_46 above = height(by, &vertex->point);
        ahead = ahead || above > 0;
        behind = behind || above < 0;
        at = vertex->next;
    }
    if (!(ahead && behind)) {
        item->where = next_place(by, behind);
        return true;
    }
    vertex_ring parts[2] = {{.count = 0}, {.count = 0}};
    fxl_bsp_item *remaining = new_item(cutter);
    if (remaining == NULL) {
        return false;
    }
    *remaining = *item; /* stays at the node while it is cut: nothing is inserted into it */
    if (!divide(cutter, by, item, parts)) {
        return false;
    }
    item->first = (uint16_t)parts[0].first;
    item->count = (uint8_t)parts[0].count;
    item->where = next_place(by, false);
    remaining->first = (uint16_t)parts[1].first;
    remaining->count = (uint8_t)parts[1].count;
    remaining->where = next_place(by, true);
    return true;
}

/* Returns the lowest number of a node that has pieces; FXL_IN_LEAF where no node has any. */
/* bsp 3.5 */
static uint32_t next_node(const fxl_bsp_cutter *cutter)
{
    uint32_t lowest = FXL_IN_LEAF;
    for (uint32_t i = cutter->first_item; i < cutter->item_count; i++) {
        uint32_t where = cutter->parts->items[i].where;
        lowest = where < lowest ? where : lowest;
    }
    return lowest;
}

/* bsp 3.3 */
static bool cut_all(fxl_bsp_cutter *cutter)
{
    const fxl_scene *scene = cutter->scene;
    split_plane by = {.centre = scene->instances[scene->bsp_instance].centre};
    while ((by.number = next_node(cutter)) != FXL_IN_LEAF) {
        by.node = &scene->bsp_nodes[by.number];
        const uint32_t end = cutter->item_count;
        for (uint32_t i = cutter->first_item; i < end; i++) {
            fxl_bsp_item *item = &cutter->parts->items[i];
            if (item->where == by.number && !cut_piece(cutter, &by, item)) {
                return false;
            }
        }
    }
    return true;
}

FXL_COLD bool fxl_bsp_cut(fxl_bsp_cutter *cutter, const fxl_instance *instance,
                          const fxl_point *eye, uint32_t entry)
{
    const uint32_t items = cutter->item_count, vertices = cutter->vertex_count;
    cutter->first_item = items;
    bool done = take_faces(cutter, instance, eye, entry) && cut_all(cutter);
    uint32_t used = fxl_bsp_used(cutter);
    cutter->most = used > cutter->most ? used : cutter->most;
    if (!done) {
        cutter->item_count = items;
        cutter->vertex_count = vertices;
    }
    return done;
}
