/* SPDX-License-Identifier: MIT */
#include "../view/cull.h"
#include "../view/outcode.h"
#include "bsp_pieces.h"
#include "fixel/billboards.h"

#include "../draw/renderer.h"
#include "../draw/scratch.h"
#include "../scene/bsp_node.h"

/* What is done at a node so far. */
enum {
    FIRST, /* nothing: the subtree that comes first is next */
    FACES,
    SECOND
};

/* The state of a traversal of the BSP. */
typedef struct {
    const fxl_traversal *traversal;
    const fxl_scene *scene;
    fxl_bsp_workspace *workspace;
    uint32_t *sides, *busy;
    fxl_model_view *model_view;  /* null: the instance of the BSP is not visible */
    fxl_point from;              /* the eye, relative to the instance of the BSP */
    const fxl_bsp_node *tested;  /* the node whose sphere was tested last */
    uint32_t test_result;        /* the result of that test */
    uint32_t planes;             /* the planes that the instance's sphere may cross */
    uint32_t inside, inside_end; /* nodes inside <= n < inside_end are inside the frustum */
    bool reverse;                /* near to far */
} bsp_traversal;

FXL_STATIC_ASSERT(sizeof(fxl_bsp_item) == 12 && sizeof(fxl_bsp_vertex) == 16, "docs/extras/bsp.md");

uint32_t fxl_bsp_workspace_size(const fxl_scene *scene)
{
    uint32_t movers = fxl_bsp_movers(scene);
    uint32_t size = (uint32_t)sizeof(fxl_bsp_workspace) +
                    (scene->bsp_node_count + 31) / 32 * (uint32_t)sizeof(uint32_t);
    if (movers > 0) {
        size += (scene->bsp_node_count + 31) / 32 * (uint32_t)sizeof(uint32_t) +
                2 * scene->bsp_node_count * (uint32_t)sizeof(uint16_t) +
                movers * (uint32_t)sizeof(fxl_bsp_item);
    }
    return scene->bsp_nodes == NULL ? 0 : size;
}

/* Finds the entries of the layer in the order, and the entry of the BSP's instance among them. */
/* bsp 2.1 */
static void find_layer(const fxl_traversal *traversal, fxl_bsp_workspace *workspace)
{
    const fxl_scene *scene = traversal->renderer->scene;
    const fxl_frame *frame = &traversal->renderer->frame;
    const uint32_t layer = scene->instances[scene->bsp_instance].layer;
    uint32_t first = 0, end;
    while (first < frame->visible_count && frame->draw_list[first].instance.layer != layer) {
        first++;
    }
    workspace->owner = FXL_ITEM_NONE;
    for (end = first; end < frame->visible_count && frame->draw_list[end].instance.layer == layer;
         end++) {
        if (frame->draw_list[end].index == scene->bsp_instance) {
            workspace->owner = (uint16_t)end;
        }
    }
    workspace->first = (uint16_t)first;
    workspace->end = (uint16_t)end;
    workspace->movers = (uint16_t)(end - first - (workspace->owner != FXL_ITEM_NONE));
}

/* Finds the side of a node's plane on which the eye is. The bit is valid while the traversal is
 * below the node. */
static void find_side(const bsp_traversal *walk, uint32_t number)
{
    const uint32_t bit = (uint32_t)1 << (number & 31);
    uint32_t *word = &walk->sides[number / 32];
    *word =
        fxl_bsp_is_front(&walk->scene->bsp_nodes[number], &walk->from) ? *word | bit : *word & ~bit;
}

/* Returns the number after the last node of this subtree: the node that follows it in the table. */
static uint32_t end_below(const fxl_bsp_node *nodes, uint32_t number, uint32_t count)
{
    for (uint32_t above; (above = nodes[number].parent) != FXL_BSP_NONE; number = above) {
        if (nodes[above].front == number && nodes[above].back != FXL_BSP_NONE) {
            return nodes[above].back;
        }
    }
    return count;
}

static bool is_inside(const bsp_traversal *walk, uint32_t number)
{
    return number >= walk->inside && number < walk->inside_end;
}

static bool is_same_sphere(const fxl_bsp_node *a, const fxl_bsp_node *b)
{
    return a->radius == b->radius && a->centre.x == b->centre.x && a->centre.y == b->centre.y &&
           a->centre.z == b->centre.z;
}

/* Returns the planes that a node's sphere may cross. The last result is kept, so equal spheres
 * in a row are tested once. The loader has checked that both coordinates together are within
 * FXL_COORDINATE_MAX. */
/* bsp 4.1 */
static uint32_t planes_of(bsp_traversal *walk, uint32_t number)
{
    const fxl_view *view = walk->model_view->view;
    const fxl_bsp_node *node = &walk->scene->bsp_nodes[number];
    const fxl_point *origin = &walk->scene->instances[walk->scene->bsp_instance].centre;
    const fxl_point centre = {node->centre.x + origin->x, node->centre.y + origin->y,
                              node->centre.z + origin->z};
    if (is_inside(walk, number)) {
        return 0;
    }
    if (walk->tested == NULL || !is_same_sphere(walk->tested, node)) {
        walk->tested = node;
        walk->test_result =
            fxl_sphere_planes(&view->camera, &view->view_frustum, &centre, node->radius);
        if (walk->test_result != FXL_SPHERE_OUTSIDE) {
            walk->test_result &= walk->planes; /* the instance's sphere may be tighter */
        }
    }
    return walk->test_result;
}

/* Tells whether nothing in the subtree of a node is visible; then its faces are counted. If the
 * whole subtree is inside the frustum, no node of it is tested again. A node's sphere lies within
 * that of the node above, so it is the same sphere if its radius is the same. */
/* bsp 4.1 */
static bool is_invisible(bsp_traversal *walk, uint32_t number)
{
    const fxl_scene *scene = walk->scene;
    const uint32_t above = scene->bsp_nodes[number].parent;
    if (walk->model_view == NULL || is_inside(walk, number) ||
        (above != FXL_BSP_NONE &&
         scene->bsp_nodes[number].radius == scene->bsp_nodes[above].radius)) {
        return false;
    }
    uint32_t planes = planes_of(walk, number);
    if (planes != 0 && planes != FXL_SPHERE_OUTSIDE) {
        return false;
    }
    uint32_t end = end_below(scene->bsp_nodes, number, scene->bsp_node_count);
    if (planes == 0) {
        walk->inside = number;
        walk->inside_end = end;
        return false;
    }
    if (walk->workspace->movers > 0 && (walk->busy[number / 32] >> (number & 31) & 1u) != 0) {
        return false;
    }
    uint32_t faces = (end < scene->bsp_node_count
                          ? scene->bsp_nodes[end].first_face
                          : scene->models[scene->instances[scene->bsp_instance].model].face_count) -
                     scene->bsp_nodes[number].first_face;
    walk->traversal->counters->in += faces;
    walk->traversal->counters->outside += faces;
    return true;
}

/* Submits the faces of a node that face the eye, from place->index on, and counts the others. */
/* bsp 2.3 */
static bool submit_faces(bsp_traversal *walk, fxl_bsp_resume_point *place)
{
    const fxl_bsp_node *node = &walk->scene->bsp_nodes[place->node];
    const fxl_model *model =
        &walk->scene->models[walk->scene->instances[walk->scene->bsp_instance].model];
    const fxl_face *faces = &walk->scene->faces[model->first_face + node->first_face];
    fxl_counters *counters = walk->traversal->counters;
    if (walk->model_view == NULL || node->face_count == 0) {
        return true;
    }
    uint32_t planes = planes_of(walk, place->node);
    if (planes == FXL_SPHERE_OUTSIDE) {
        counters->in += node->face_count;
        counters->outside += node->face_count;
        return true;
    }
    walk->model_view->planes = (fxl_planes)planes;
    for (; place->index < node->face_count; place->index++) {
        const fxl_face *face =
            &faces[walk->reverse ? node->face_count - 1 - place->index : place->index];
        if (!fxl_model_view_face_is_front(walk->model_view, face)) {
            counters->backfacing += 1;
        } else if (!fxl_submit_face(walk->model_view, face, walk->traversal)) {
            return false;
        }
        counters->in += 1;
    }
    return true;
}

/* Tells whether the traversal visits the front subtree of a node first. Far to near, it visits
 * first the side on which the eye is not. */
/* bsp 2.2, 2.3 */
static bool visits_front_first(const bsp_traversal *walk, uint32_t node)
{
    return (walk->sides[node / 32] >> (node & 31) & 1u) == walk->reverse;
}

/* bsp 2.2 */
static void step(fxl_bsp_resume_point *place, uint32_t node, uint32_t phase)
{
    place->node = (uint16_t)node;
    place->phase = (uint16_t)phase;
    place->index = 0;
    place->face = 0;
}

/* Goes up to the next node that is not finished. Returns false where there is none. */
/* bsp 2.2 */
static bool go_up(const bsp_traversal *walk, fxl_bsp_resume_point *place)
{
    uint32_t node = place->node, from;
    do {
        from = node;
        node = walk->scene->bsp_nodes[from].parent;
        if (node == FXL_BSP_NONE) {
            return false;
        }
    } while ((walk->scene->bsp_nodes[node].front == from) != visits_front_first(walk, node));
    step(place, node, FACES);
    return true;
}

/* Does the work at a node and in its leaves. Returns false where the traversal was stopped.
 * Otherwise *place is at a node below, or this subtree is finished and *more is false. */
static bool work_at(bsp_traversal *walk, fxl_bsp_resume_point *place, bool *more)
{
    const fxl_bsp_node *node = &walk->scene->bsp_nodes[place->node];
    *more = true;
    if (place->phase == FIRST && place->index == 0 && place->face == 0) {
        find_side(walk, place->node);
        if (is_invisible(walk, place->node)) {
            *more = false;
            return true;
        }
    }
    if (place->phase == FACES) {
        if (!submit_faces(walk, place)) {
            return false;
        }
        step(place, place->node, SECOND);
    }
    bool front = visits_front_first(walk, place->node) == (place->phase == FIRST);
    uint32_t below = front ? node->front : node->back;
    if (below != FXL_BSP_NONE) {
        step(place, below, FIRST);
        return true;
    }
    if (walk->workspace->movers > 0 &&
        !fxl_submit_bsp_leaf(walk->traversal, walk->workspace, 2u * place->node + !front, place)) {
        return false;
    }
    *more = place->phase == FIRST;
    if (*more) {
        step(place, place->node, FACES);
    }
    return true;
}

/* Traverses from *place to the end of the BSP without a stack: each node stores its parent.
 * Returns false where the traversal was stopped. */
/* bsp 2.2 */
static bool submit_nodes(bsp_traversal *walk, fxl_bsp_resume_point *place)
{
    do {
        bool more;
        do {
            if (!work_at(walk, place, &more)) {
                return false;
            }
        } while (more);
    } while (go_up(walk, place));
    return true;
}

/* Submits the layer of the BSP. Returns false where the traversal was stopped. If the display
 * list was full, the workspace holds the place to resume. */
static bool submit_layer(const fxl_traversal *traversal, fxl_bsp_workspace *workspace,
                         const fxl_bsp_parts *parts)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_instance *instance = &scene->instances[scene->bsp_instance];
    const fxl_point *eye = &traversal->renderer->frame.view.camera.position;
    fxl_model_view model_view;
    /* Eye and centre are within FXL_COORDINATE_MAX, so a difference is below 2^30. */
    bsp_traversal walk = {.traversal = traversal,
                          .scene = scene,
                          .workspace = workspace,
                          .sides = parts->sides,
                          .busy = parts->busy,
                          .from = {eye->x - instance->centre.x, eye->y - instance->centre.y,
                                   eye->z - instance->centre.z},
                          .reverse = renderer->near_first};
    if (workspace->owner != FXL_ITEM_NONE) {
        (void)fxl_view_instance(traversal, &traversal->renderer->frame.draw_list[workspace->owner],
                                &model_view);
        walk.model_view = &model_view;
        walk.planes = model_view.planes;
        walk.inside_end = walk.planes == 0 ? scene->bsp_node_count : 0;
    }
    fxl_bsp_resume_point place = {0, 0, 0, FIRST};
    if (traversal->resume->faces != 0) {
        place = workspace->rest;
        for (uint32_t node = place.node; node != FXL_BSP_NONE;
             node = scene->bsp_nodes[node].parent) {
            find_side(&walk, node); /* another workspace has not come down to the node */
        }
    }
    bool done = submit_nodes(&walk, &place);
    if (!done && traversal->band == NULL) {
        workspace->rest = place;
        traversal->resume->faces = 1; /* the workspace has the place to resume */
    }
    return done;
}

/* An instance of another layer. */
static bool submit_other(const fxl_traversal *traversal, const fxl_draw_entry *entry)
{
    const fxl_billboards *billboards = traversal->renderer->billboards;
    return billboards != NULL ? billboards->code->instance(traversal, entry)
                              : fxl_submit_any_instance(traversal, entry);
}

/* bsp 2.1 */
bool fxl_submit_by_bsp(const fxl_traversal *traversal)
{
    const fxl_renderer *renderer = traversal->renderer;
    const uint32_t count = traversal->renderer->frame.visible_count;
    if (renderer->scene->bsp_nodes == NULL) {
        return renderer->billboards != NULL ? renderer->billboards->code->all(traversal)
                                            : fxl_submit_by_distance(traversal);
    }
    fxl_bsp_workspace *workspace = (fxl_bsp_workspace *)renderer->order_memory;
    fxl_bsp_parts parts = fxl_bsp_parts_of(renderer->scene, workspace);
    if (!fxl_is_own_workspace(traversal)) {
        parts.sides = (uint32_t *)fxl_tree_scratch(traversal);
    }
    if (traversal->display_list != NULL) {
        find_layer(traversal, workspace);
        if (renderer->scene->placements != NULL) {
            traversal->counters->rounded = (uint16_t)renderer->scene->placement_code->count_rounded(
                traversal, workspace->first, workspace->end);
        }
        fxl_bsp_cut_movers(traversal, workspace);
    }
    while (traversal->resume->instances < count) {
        const uint32_t number = traversal->resume->instances;
        const uint32_t at = renderer->near_first ? count - 1 - number : number;
        const bool by_bsp = at >= workspace->first && at < workspace->end;
        if (!(by_bsp ? submit_layer(traversal, workspace, &parts)
                     : submit_other(traversal, &traversal->renderer->frame.draw_list[at]))) {
            return false;
        }
        traversal->resume->instances =
            (uint16_t)(number + (by_bsp ? (uint32_t)(workspace->end - workspace->first) : 1u));
        traversal->resume->faces = 0;
    }
    return true;
}

/* What the memory has beyond the least is for pieces of instances that move. */
static fxl_status choose(fxl_renderer *renderer, const fxl_config *config)
{
    const uint32_t least = (uint32_t)fxl_aligned(fxl_bsp_workspace_size(renderer->scene));
    const fxl_status status = fxl_choose_with_memory(renderer, config);
    if (status == FXL_OK) {
        renderer->check = fxl_check_combination;
    }
    if (status == FXL_OK && least > 0) {
        fxl_bsp_workspace *workspace = (fxl_bsp_workspace *)config->tree;
        workspace->pieces = (uint8_t *)config->tree + least;
        workspace->pieces_size = config->tree_size > least ? config->tree_size - least : 0;
    }
    return status;
}

const fxl_order fxl_by_tree = {
    .submit = fxl_submit_by_bsp, .memory_size = fxl_bsp_workspace_size, .choose = choose};
