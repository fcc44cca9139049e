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
    const fxl_traversal *on;
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
static void find_layer(const fxl_traversal *on, fxl_bsp_workspace *workspace)
{
    const fxl_scene *scene = on->renderer->scene;
    const fxl_frame *frame = &on->renderer->frame;
    const uint32_t layer = scene->instances[scene->bsp_instance].layer;
    uint32_t first = 0, end;
    while (first < frame->visible_count && frame->order[first].instance.layer != layer) {
        first++;
    }
    workspace->owner = FXL_ITEM_NONE;
    for (end = first; end < frame->visible_count && frame->order[end].instance.layer == layer;
         end++) {
        if (frame->order[end].index == scene->bsp_instance) {
            workspace->owner = (uint16_t)end;
        }
    }
    workspace->first = (uint16_t)first;
    workspace->end = (uint16_t)end;
    workspace->movers = (uint16_t)(end - first - (workspace->owner != FXL_ITEM_NONE));
}

/* Finds the side of a node's plane on which the eye is. The bit is valid while the traversal is
 * below the node. */
static void find_side(const bsp_traversal *traversal, uint32_t number)
{
    const uint32_t bit = (uint32_t)1 << (number & 31);
    uint32_t *word = &traversal->sides[number / 32];
    *word = fxl_bsp_is_front(&traversal->scene->bsp_nodes[number], &traversal->from) ? *word | bit
                                                                                     : *word & ~bit;
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

static bool is_inside(const bsp_traversal *traversal, uint32_t number)
{
    return number >= traversal->inside && number < traversal->inside_end;
}

static bool is_same_sphere(const fxl_bsp_node *a, const fxl_bsp_node *b)
{
    return a->radius == b->radius && a->centre.x == b->centre.x && a->centre.y == b->centre.y &&
           a->centre.z == b->centre.z;
}

/* Returns the planes that a node's sphere may cross. The last result is kept, so equal spheres
 * in a row are tested once. The loader has checked that both coordinates together are within
 * FXL_COORDINATE_MAX. */
static uint32_t planes_of(bsp_traversal *traversal, uint32_t number)
{
    const fxl_view *view = traversal->model_view->view;
    const fxl_bsp_node *node = &traversal->scene->bsp_nodes[number];
    const fxl_point *origin = &traversal->scene->instances[traversal->scene->bsp_instance].centre;
    const fxl_point centre = {node->centre.x + origin->x, node->centre.y + origin->y,
                              node->centre.z + origin->z};
    if (is_inside(traversal, number)) {
        return 0;
    }
    if (traversal->tested == NULL || !is_same_sphere(traversal->tested, node)) {
        traversal->tested = node;
        traversal->test_result =
            fxl_sphere_planes(&view->camera, &view->view_frustum, &centre, node->radius);
        if (traversal->test_result != FXL_SPHERE_OUTSIDE) {
            traversal->test_result &= traversal->planes; /* the instance's sphere may be tighter */
        }
    }
    return traversal->test_result;
}

/* Tells whether nothing in the subtree of a node is visible; then its faces are counted. If the
 * whole subtree is inside the frustum, no node of it is tested again. A node's sphere lies within
 * that of the node above, so it is the same sphere if its radius is the same. */
static bool is_invisible(bsp_traversal *traversal, uint32_t number)
{
    const fxl_scene *scene = traversal->scene;
    const uint32_t above = scene->bsp_nodes[number].parent;
    if (traversal->model_view == NULL || is_inside(traversal, number) ||
        (above != FXL_BSP_NONE &&
         scene->bsp_nodes[number].radius == scene->bsp_nodes[above].radius)) {
        return false;
    }
    uint32_t planes = planes_of(traversal, number);
    if (planes != 0 && planes != FXL_SPHERE_OUTSIDE) {
        return false;
    }
    uint32_t end = end_below(scene->bsp_nodes, number, scene->bsp_node_count);
    if (planes == 0) {
        traversal->inside = number;
        traversal->inside_end = end;
        return false;
    }
    if (traversal->workspace->movers > 0 &&
        (traversal->busy[number / 32] >> (number & 31) & 1u) != 0) {
        return false;
    }
    uint32_t faces = (end < scene->bsp_node_count
                          ? scene->bsp_nodes[end].first_face
                          : scene->models[scene->instances[scene->bsp_instance].model].face_count) -
                     scene->bsp_nodes[number].first_face;
    traversal->on->counters->in += faces;
    traversal->on->counters->outside += faces;
    return true;
}

/* Submits the faces of a node that face the eye, from place->index on, and counts the others. */
static bool submit_faces(bsp_traversal *traversal, fxl_bsp_resume_point *place)
{
    const fxl_bsp_node *node = &traversal->scene->bsp_nodes[place->node];
    const fxl_model *model =
        &traversal->scene
             ->models[traversal->scene->instances[traversal->scene->bsp_instance].model];
    const fxl_face *faces = &traversal->scene->faces[model->first_face + node->first_face];
    fxl_counters *counters = traversal->on->counters;
    if (traversal->model_view == NULL || node->face_count == 0) {
        return true;
    }
    uint32_t planes = planes_of(traversal, place->node);
    if (planes == FXL_SPHERE_OUTSIDE) {
        counters->in += node->face_count;
        counters->outside += node->face_count;
        return true;
    }
    traversal->model_view->planes = (fxl_planes)planes;
    for (; place->index < node->face_count; place->index++) {
        const fxl_face *face =
            &faces[traversal->reverse ? node->face_count - 1 - place->index : place->index];
        if (!fxl_model_view_face_is_front(traversal->model_view, face)) {
            counters->backfacing += 1;
        } else if (!fxl_submit_face(traversal->model_view, face, traversal->on)) {
            return false;
        }
        counters->in += 1;
    }
    return true;
}

/* Tells whether the traversal visits the front subtree of a node first. Far to near, it visits
 * first the side on which the eye is not. */
static bool visits_front_first(const bsp_traversal *traversal, uint32_t node)
{
    return (traversal->sides[node / 32] >> (node & 31) & 1u) == traversal->reverse;
}

static void step(fxl_bsp_resume_point *place, uint32_t node, uint32_t phase)
{
    place->node = (uint16_t)node;
    place->phase = (uint16_t)phase;
    place->index = 0;
    place->face = 0;
}

/* Goes up to the next node that is not finished. Returns false where there is none. */
static bool go_up(const bsp_traversal *traversal, fxl_bsp_resume_point *place)
{
    uint32_t node = place->node, from;
    do {
        from = node;
        node = traversal->scene->bsp_nodes[from].parent;
        if (node == FXL_BSP_NONE) {
            return false;
        }
    } while ((traversal->scene->bsp_nodes[node].front == from) !=
             visits_front_first(traversal, node));
    step(place, node, FACES);
    return true;
}

/* Does the work at a node and in its leaves. Returns false where the traversal was stopped.
 * Otherwise *place is at a node below, or this subtree is finished and *more is false. */
static bool work_at(bsp_traversal *traversal, fxl_bsp_resume_point *place, bool *more)
{
    const fxl_bsp_node *node = &traversal->scene->bsp_nodes[place->node];
    *more = true;
    if (place->phase == FIRST && place->index == 0 && place->face == 0) {
        find_side(traversal, place->node);
        if (is_invisible(traversal, place->node)) {
            *more = false;
            return true;
        }
    }
    if (place->phase == FACES) {
        if (!submit_faces(traversal, place)) {
            return false;
        }
        step(place, place->node, SECOND);
    }
    bool front = visits_front_first(traversal, place->node) == (place->phase == FIRST);
    uint32_t below = front ? node->front : node->back;
    if (below != FXL_BSP_NONE) {
        step(place, below, FIRST);
        return true;
    }
    if (traversal->workspace->movers > 0 &&
        !fxl_submit_bsp_leaf(traversal->on, traversal->workspace, 2u * place->node + !front,
                             place)) {
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
static bool submit_nodes(bsp_traversal *traversal, fxl_bsp_resume_point *place)
{
    do {
        bool more;
        do {
            if (!work_at(traversal, place, &more)) {
                return false;
            }
        } while (more);
    } while (go_up(traversal, place));
    return true;
}

/* Submits the layer of the BSP. Returns false where the traversal was stopped. If the display
 * list was full, the workspace holds the place to resume. */
static bool submit_layer(const fxl_traversal *on, fxl_bsp_workspace *workspace,
                         const fxl_bsp_parts *parts)
{
    const fxl_renderer *renderer = on->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_instance *instance = &scene->instances[scene->bsp_instance];
    const fxl_point *eye = &on->renderer->frame.view.camera.position;
    fxl_model_view model_view;
    /* Eye and centre are within FXL_COORDINATE_MAX, so a difference is below 2^30. */
    bsp_traversal traversal = {.on = on,
                               .scene = scene,
                               .workspace = workspace,
                               .sides = parts->sides,
                               .busy = parts->busy,
                               .from = {eye->x - instance->centre.x, eye->y - instance->centre.y,
                                        eye->z - instance->centre.z},
                               .reverse = renderer->near_first};
    if (workspace->owner != FXL_ITEM_NONE) {
        (void)fxl_view_instance(on, &on->renderer->frame.order[workspace->owner], &model_view);
        traversal.model_view = &model_view;
        traversal.planes = model_view.planes;
        traversal.inside_end = traversal.planes == 0 ? scene->bsp_node_count : 0;
    }
    fxl_bsp_resume_point place = {0, 0, 0, FIRST};
    if (on->resume->faces != 0) {
        place = workspace->rest;
        for (uint32_t node = place.node; node != FXL_BSP_NONE; node = scene->bsp_nodes[node].parent) {
            find_side(&traversal, node); /* another workspace has not come down to the node */
        }
    }
    bool done = submit_nodes(&traversal, &place);
    if (!done && on->band == NULL) {
        workspace->rest = place;
        on->resume->faces = 1; /* the workspace has the place to resume */
    }
    return done;
}

/* An instance of another layer. */
static bool submit_other(const fxl_traversal *on, const fxl_order_entry *entry)
{
    const fxl_billboards *billboards = on->renderer->billboards;
    return billboards != NULL ? billboards->code->instance(on, entry)
                              : fxl_submit_any_instance(on, entry);
}

bool fxl_submit_by_bsp(const fxl_traversal *on)
{
    const fxl_renderer *renderer = on->renderer;
    const uint32_t count = on->renderer->frame.visible_count;
    if (renderer->scene->bsp_nodes == NULL) {
        return renderer->billboards != NULL ? renderer->billboards->code->all(on)
                                            : fxl_submit_by_distance(on);
    }
    fxl_bsp_workspace *workspace = (fxl_bsp_workspace *)renderer->order_memory;
    fxl_bsp_parts parts = fxl_bsp_parts_of(renderer->scene, workspace);
    if (!fxl_is_own_workspace(on)) {
        parts.sides = (uint32_t *)fxl_tree_scratch(on);
    }
    if (on->display_list != NULL) {
        find_layer(on, workspace);
        if (renderer->scene->turns != NULL) {
            on->counters->rounded = (uint16_t)renderer->scene->turn_code->count_rounded(
                on, workspace->first, workspace->end);
        }
        fxl_bsp_cut_movers(on, workspace);
    }
    while (on->resume->instances < count) {
        const uint32_t number = on->resume->instances;
        const uint32_t at = renderer->near_first ? count - 1 - number : number;
        const bool by_bsp = at >= workspace->first && at < workspace->end;
        if (!(by_bsp ? submit_layer(on, workspace, &parts)
                     : submit_other(on, &on->renderer->frame.order[at]))) {
            return false;
        }
        on->resume->instances =
            (uint16_t)(number + (by_bsp ? (uint32_t)(workspace->end - workspace->first) : 1u));
        on->resume->faces = 0;
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
        workspace->pieces_size = config->tree_size - least;
    }
    return status;
}

const fxl_order fxl_by_tree = {.submit = fxl_submit_by_bsp,
                               .memory_size = fxl_bsp_workspace_size,
                               .choose = choose};
