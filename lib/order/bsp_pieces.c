/* SPDX-License-Identifier: MIT */
#include "../math/arith.h"
#include "../scene/placement_code.h"
#include "../view/cull.h"
#include "../view/model_view.h"
#include "bsp_pieces.h"
#include "fixel/billboards.h"

#include "../scene/bsp_node.h"

uint32_t fxl_bsp_movers(const fxl_scene *scene)
{
    uint32_t count = 0;
    if (scene->instance_capacity > 0) {
        return scene->instance_capacity - 1; /* of a world: whichever they become */
    }
    if (scene->bsp_nodes != NULL) {
        const uint32_t layer = scene->instances[scene->bsp_instance].layer;
        for (uint32_t i = 0; i < scene->instance_count; i++) {
            count += scene->instances[i].layer == layer;
        }
        count -= 1; /* the BSP's own instance */
    }
    return count;
}

fxl_bsp_parts fxl_bsp_parts_of(const fxl_scene *scene, fxl_bsp_workspace *workspace)
{
    fxl_bsp_parts parts;
    parts.movers = fxl_bsp_movers(scene);
    parts.sides = (uint32_t *)(workspace + 1);
    parts.busy = parts.sides + (scene->bsp_node_count + 31) / 32;
    parts.leaves = (uint16_t *)(parts.busy + (scene->bsp_node_count + 31) / 32);
    parts.whole = (fxl_bsp_item *)(void *)(parts.leaves + 2 * scene->bsp_node_count);
    parts.items = (fxl_bsp_item *)workspace->pieces;
    parts.vertices = workspace->pieces == NULL
                         ? NULL
                         : (fxl_bsp_vertex *)(void *)((uint8_t *)workspace->pieces +
                                                      (workspace->pieces_size & ~3u));
    return parts;
}

static fxl_bsp_item *item_of(const fxl_bsp_parts *parts, uint32_t number)
{
    return number < parts->movers ? &parts->whole[number] : &parts->items[number - parts->movers];
}

/* Adds an item to its leaf, last in the order of drawing: at the end of the list, or at its
 * beginning where the list is drawn in reverse. */
/* bsp 3.5, 3.6 */
static void put_into_leaf(const fxl_scene *scene, const fxl_bsp_parts *parts, uint32_t number,
                          bool reverse)
{
    fxl_bsp_item *item = item_of(parts, number);
    uint32_t node = (item->where & ~FXL_IN_LEAF) / 2;
    while (node != FXL_BSP_NONE && (parts->busy[node / 32] >> (node & 31) & 1u) == 0) {
        parts->busy[node / 32] |= (uint32_t)1 << (node & 31);
        node = scene->bsp_nodes[node].parent;
    }
    uint16_t *link = &parts->leaves[item->where & ~FXL_IN_LEAF];
    while (!reverse && *link != FXL_ITEM_NONE) {
        link = &item_of(parts, *link)->next;
    }
    item->next = *link;
    *link = (uint16_t)number;
}

/* Clips a whole face that faces the eye. Returns its outcome. */
/* bsp 4.2 */
static fxl_outcome outcome_of(const fxl_model_view *model_view, const fxl_face *face,
                              const fxl_traversal *traversal)
{
    fxl_clip_result cut = fxl_first_polygon(model_view, face, traversal);
    fxl_outcome outcome = (fxl_outcome)1 << cut;
    while ((cut == FXL_CLIP_INSIDE || cut == FXL_CLIP_CUT) && traversal->clipper->next != NULL) {
        cut = fxl_next_polygon(model_view, traversal);
        outcome |= (fxl_outcome)1 << cut;
    }
    return outcome;
}

/* The outcome of a whole face of a turned instance, from its rounded points. */
static fxl_outcome outcome_of_turned(const fxl_placement_code *turned, const fxl_draw_entry *entry,
                                     const fxl_face *face, const fxl_traversal *traversal)
{
    fxl_point points[FXL_FACE_VERTICES_MAX];
    fxl_model_view model_view;
    fxl_face whole = *face;
    turned->place_face(traversal->renderer->scene, entry->index, face, points);
    fxl_model_view_of_polygon(&model_view, points, &traversal->renderer->frame.view,
                              &traversal->workspace->cache);
    model_view.planes = entry->instance.planes;
    fxl_set_face_of_points(&whole, face->count);
    return outcome_of(&model_view, &whole, traversal);
}

static void count_turned_faces(const fxl_placement_code *turned, const fxl_traversal *traversal,
                               const fxl_draw_entry *entry)
{
    const fxl_scene *scene = traversal->renderer->scene;
    const fxl_model *model = &scene->models[scene->instances[entry->index].model];
    const fxl_point *eye = &traversal->renderer->frame.view.camera.position;
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        traversal->counters->in += 1;
        if (turned->face_is_front(scene, entry->index, face, eye)) {
            (void)fxl_count_outcome(traversal, outcome_of_turned(turned, entry, face, traversal),
                                    traversal->display_list->used);
        } else {
            traversal->counters->backfacing += 1;
        }
    }
}

/* Counts the faces of an instance, each once, however many pieces they are cut into. */
static void count_faces(const fxl_traversal *traversal, const fxl_draw_entry *entry)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_instance *instance = &scene->instances[entry->index];
    const fxl_model *model = &scene->models[instance->model];
    const fxl_placement_code *turned = fxl_placement_code_of(scene, entry->index);
    fxl_model_view model_view;
    if (turned != NULL) {
        count_turned_faces(turned, traversal, entry);
        return;
    }
    fxl_model_view_of_instance(&model_view, scene, instance, &traversal->renderer->frame.view,
                               &traversal->workspace->cache);
    model_view.planes = entry->instance.planes;
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        traversal->counters->in += 1;
        if (fxl_model_view_face_is_front(&model_view, face)) {
            (void)fxl_count_outcome(traversal, outcome_of(&model_view, face, traversal),
                                    traversal->display_list->used);
        } else {
            traversal->counters->backfacing += 1;
        }
    }
}

/* Returns the leaf that holds a point of the world. */
/* bsp 3.7 */
static uint32_t leaf_of(const fxl_scene *scene, const fxl_point *point)
{
    const fxl_point *centre = &scene->instances[scene->bsp_instance].centre;
    const fxl_point from = {point->x - centre->x, point->y - centre->y, point->z - centre->z};
    uint32_t node = 0;
    for (;;) {
        bool front = fxl_bsp_is_front(&scene->bsp_nodes[node], &from);
        uint32_t below = front ? scene->bsp_nodes[node].front : scene->bsp_nodes[node].back;
        if (below == FXL_BSP_NONE) {
            return 2 * node + !front;
        }
        node = below;
    }
}

/* bsp 3.8 */
bool fxl_bsp_shows_billboard(const fxl_renderer *renderer, const fxl_draw_entry *entry)
{
    const fxl_billboards *billboards = renderer->billboards;
    const uint32_t model = renderer->scene->instances[entry->index].model;
    return billboards != NULL && billboards->set->model_map[model] != 0;
}

/* The middle of an instance's billboard, were the camera upright: above the instance's centre by
 * half of the height less the anchor, by the instance's scale. A centre is often on the ground, and
 * so on no side of it. A height is below 2^29 and lies within the radius, which the scale leaves
 * within FXL_COORDINATE_MAX. */
/* bsp 3.8 */
static fxl_point middle_of(const fxl_renderer *renderer, const fxl_draw_entry *entry)
{
    const fxl_scene *scene = renderer->scene;
    const fxl_instance *instance = &scene->instances[entry->index];
    const fxl_billboard_set *set = renderer->billboards->set;
    const fxl_billboard *board = &set->billboards[set->model_map[instance->model] - 1];
    const fxl_q16_16 scale = fxl_placement_code_of(scene, entry->index) != NULL
                                 ? fxl_placement_of(scene, entry->index)->scale
                                 : 65536;
    fxl_point middle = instance->centre;
    middle.y += (int32_t)(fxl_multiply_s32(board->height - 2 * board->anchor_y, scale) >> 17);
    return middle;
}

/* An instance that is drawn whole, in the leaf of a point. number: of the instances that the
 * workspace has room for. */
/* bsp 3.7 */
static void put_whole(const fxl_scene *scene, const fxl_bsp_parts *parts, uint32_t number,
                      const fxl_point *point, uint32_t entry, bool reverse)
{
    const fxl_bsp_item whole = {
        FXL_IN_LEAF | leaf_of(scene, point), FXL_ITEM_NONE, (uint16_t)entry, FXL_ITEM_NONE, 0, 0};
    parts->whole[number] = whole;
    put_into_leaf(scene, parts, number, reverse);
}

/* bsp 3.1, 3.2 */
FXL_COLD void fxl_bsp_cut_movers(const fxl_traversal *traversal, fxl_bsp_workspace *workspace)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_scene *scene = renderer->scene;
    const bool reverse = renderer->near_first;
    fxl_bsp_parts parts = fxl_bsp_parts_of(scene, workspace);
    fxl_bsp_cutter cutter = {.scene = scene, .parts = &parts};
    workspace->unsplit = workspace->used = workspace->refused = 0;
    if (workspace->movers == 0) {
        return;
    }
    cutter.capacity = workspace->pieces == NULL ? 0 : workspace->pieces_size & ~3u;
    for (uint32_t leaf = 0; leaf < 2 * scene->bsp_node_count; leaf++) {
        parts.leaves[leaf] = FXL_ITEM_NONE;
    }
    for (uint32_t i = 0; i < (scene->bsp_node_count + 31) / 32; i++) {
        parts.busy[i] = 0;
    }
    uint32_t mover = 0;
    for (uint32_t at = workspace->first; at < workspace->end; at++) {
        if (at == workspace->owner) {
            continue;
        }
        const fxl_draw_entry *entry = &renderer->frame.draw_list[at];
        const fxl_instance *instance = &scene->instances[entry->index];
        if (fxl_bsp_shows_billboard(renderer, entry)) {
            const fxl_point middle = middle_of(renderer, entry);
            put_whole(scene, &parts, mover++, &middle, at, reverse);
            continue;
        }
        count_faces(traversal, entry);
        if (fxl_bsp_cut(&cutter, instance, &traversal->renderer->frame.view.camera.position, at)) {
            for (uint32_t i = cutter.first_item; i < cutter.item_count; i++) {
                put_into_leaf(scene, &parts, parts.movers + i, reverse);
            }
        } else {
            put_whole(scene, &parts, mover, &instance->centre, at, reverse);
            workspace->unsplit += 1;
        }
        mover += 1;
    }
    workspace->used = cutter.most;
}

/* Submits the faces of an instance that was not cut into pieces, and so is convex, from *number
 * on, in the order of drawing. */
static bool submit_whole(const fxl_traversal *traversal, const fxl_draw_entry *entry,
                         uint16_t *number)
{
    fxl_resume_point resume = {.faces = *number};
    fxl_traversal faces = *traversal;
    faces.resume = &resume;
    const fxl_placement_code *turned =
        fxl_placement_code_of(traversal->renderer->scene, entry->index);
    bool done = turned != NULL ? turned->submit_instance(&faces, entry, &fxl_rounded_faces)
                               : fxl_submit_instance(&faces, entry);
    *number = done ? 0 : resume.faces;
    return done;
}

/* The normal of a face of an instance: it decides whether the face's pieces are turned to a light.
 */
static fxl_direction normal_of(const fxl_scene *scene, const fxl_instance *instance,
                               const fxl_face *face)
{
    const uint32_t of = fxl_instance_number(scene, instance);
    const fxl_placement_code *turned = fxl_placement_code_of(scene, of);
    return turned != NULL ? turned->normal(scene, of, face) : face->normal;
}

/* bsp 4.2 */
static bool submit_bsp_piece(const fxl_traversal *traversal, const fxl_bsp_parts *parts,
                             const fxl_bsp_item *item)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_draw_entry *entry = &traversal->renderer->frame.draw_list[item->entry];
    const fxl_instance *instance = &scene->instances[entry->index];
    fxl_point points[FXL_FACE_VERTICES_MAX];
    uint32_t vertex = item->first;
    for (uint32_t i = 0; i < item->count; i++) {
        const fxl_bsp_vertex *from = fxl_bsp_vertex_of(parts, vertex);
        points[i] = from->point;
        vertex = from->next;
    }
    fxl_pieces pieces;
    fxl_pieces_begin(&pieces, traversal);
    pieces.planes = entry->instance.planes;
    if (renderer->shader != NULL) {
        const fxl_face *face = &scene->faces[scene->models[instance->model].first_face +
                                             fxl_bsp_vertex_of(parts, item->first)->face];
        const fxl_direction normal = normal_of(scene, instance, face);
        fxl_submit_shaded_piece(&pieces, instance, face, &normal, points, item->count);
    } else {
        (void)fxl_submit_piece(&pieces, points, item->count, item->colour);
    }
    return fxl_pieces_end(&pieces);
}

/* An item of a leaf, of which *face faces are done. The faces were counted when the instance was
 * cut; a billboard was not. */
static bool submit_item(const fxl_traversal *traversal, fxl_bsp_workspace *workspace,
                        const fxl_bsp_parts *parts, const fxl_bsp_item *item, uint16_t *face)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_draw_entry *entry = &renderer->frame.draw_list[item->entry];
    const bool whole = item->first == FXL_ITEM_NONE;
    if (whole && fxl_bsp_shows_billboard(renderer, entry)) {
        return renderer->billboards->code->instance(traversal, entry);
    }
    fxl_counters counters = {0};
    fxl_traversal uncounted = *traversal;
    uncounted.counters = &counters;
    const bool fitted =
        whole ? submit_whole(&uncounted, entry, face) : submit_bsp_piece(&uncounted, parts, item);
    traversal->counters->spilled += counters.spilled;
    if (fitted && !whole && traversal->counters == &traversal->workspace->counters) {
        workspace->refused += counters.refused;
    }
    return fitted;
}

/* bsp 3.6 */
bool fxl_submit_bsp_leaf(const fxl_traversal *traversal, fxl_bsp_workspace *workspace,
                         uint32_t leaf, fxl_bsp_resume_point *place)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_bsp_parts parts = fxl_bsp_parts_of(renderer->scene, workspace);
    uint32_t number = parts.leaves[leaf];
    for (uint32_t done = 0; number != FXL_ITEM_NONE; done++) {
        const fxl_bsp_item *item = item_of(&parts, number);
        number = item->next;
        if (done < place->index) {
            continue;
        }
        if (!submit_item(traversal, workspace, &parts, item, &place->face)) {
            return false;
        }
        place->index += 1;
    }
    return true;
}
