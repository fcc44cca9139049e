/* SPDX-License-Identifier: MIT */
/* Counts of the order by tree: nodes, their faces, and instances among them. */
#include "order/bsp_pieces.h"
#include "predict/wrapped.h"
#include "scene/bsp_node.h"
#include "view/outcode.h"

/* A traversal, as far as it is counted. */
typedef struct {
    const fxl_traversal *traversal;
    const fxl_instance *instance;
    fxl_point from;                    /* the eye, relative to the instance */
    const fxl_bsp_resume_point *start; /* where it resumes; null: it is past that */
    const fxl_bsp_resume_point *end;   /* where the list was full; or null */
    bool has_ended;
} counted_walk;

/* The phases of a node, as submit_by_bsp.c calls them. */
enum {
    FIRST,
    FACES,
    SECOND
};

static bool is_place(const fxl_bsp_resume_point *place, uint32_t number, uint32_t phase)
{
    return place != NULL && place->node == number && place->phase == phase;
}

/* Whether the traversal is at work at a node. */
static bool is_at_work(counted_walk *walk, uint32_t number, uint32_t phase)
{
    if (is_place(walk->start, number, phase)) {
        walk->start = NULL;
    }
    walk->has_ended =
        walk->has_ended || (walk->start == NULL && is_place(walk->end, number, phase));
    return walk->start == NULL && !walk->has_ended;
}

/* The planes that a node's sphere may cross, or FXL_SPHERE_OUTSIDE. */
static uint32_t planes_of(const counted_walk *walk, const fxl_bsp_node *node)
{
    const fxl_view *view = &walk->traversal->renderer->frame.view;
    const fxl_point *origin = &walk->instance->centre;
    const fxl_point centre = {node->centre.x + origin->x, node->centre.y + origin->y,
                              node->centre.z + origin->z};
    counted.tree_spheres += 1;
    return fxl_sphere_planes(&view->camera, &view->view_frustum, &centre, node->radius);
}

/* A subtree as the traversal visits it. inside: no sphere of it is tested. */
static void count_subtree(counted_walk *walk, uint32_t number, fxl_q16_16 above, bool inside)
{
    const fxl_bsp_node *node = &walk->traversal->renderer->scene->bsp_nodes[number];
    const bool front_first =
        fxl_bsp_is_front(node, &walk->from) == walk->traversal->renderer->near_first;
    const uint32_t first = front_first ? node->front : node->back;
    const uint32_t second = front_first ? node->back : node->front;
    if (is_at_work(walk, number, FIRST)) {
        counted.tree_nodes += 1;
        if (!inside && node->radius != above) {
            const uint32_t planes = planes_of(walk, node);
            if (planes == FXL_SPHERE_OUTSIDE) {
                return;
            }
            inside = planes == 0;
        }
    }
    if (first != FXL_BSP_NONE) {
        count_subtree(walk, first, node->radius, inside);
    }
    if (is_at_work(walk, number, FACES)) {
        counted.tree_faces += node->face_count;
    }
    (void)is_at_work(walk, number, SECOND);
    if (second != FXL_BSP_NONE) {
        count_subtree(walk, second, node->radius, inside);
    }
}

static bool submit(const fxl_traversal *traversal)
{
    const fxl_renderer *renderer = traversal->renderer;
    const fxl_scene *scene = renderer->scene;
    const fxl_instance *instance = &scene->instances[scene->bsp_instance];
    const fxl_point *eye = &renderer->frame.view.camera.position;
    const fxl_bsp_workspace *workspace = (const fxl_bsp_workspace *)renderer->order_memory;
    const fxl_bsp_resume_point start = workspace->rest;
    const fxl_resume_point before = *traversal->resume;
    const bool done = fxl_by_tree.submit(traversal);
    counted_walk walk = {.traversal = traversal,
                         .instance = instance,
                         .from = {eye->x - instance->centre.x, eye->y - instance->centre.y,
                                  eye->z - instance->centre.z},
                         .start = before.faces != 0 && before.instances == workspace->first ? &start
                                                                                            : NULL,
                         .end = !done && traversal->resume->faces != 0 ? &workspace->rest : NULL};
    if (before.instances <= workspace->first) {
        count_subtree(&walk, 0, -1, false);
    }
    return done;
}

static uint32_t memory_size(const fxl_scene *scene)
{
    return fxl_by_tree.memory_size(scene);
}

static fxl_status choose(fxl_renderer *renderer, const fxl_config *config)
{
    return fxl_by_tree.choose(renderer, config);
}

const fxl_order counting_tree = {.submit = submit, .memory_size = memory_size, .choose = choose};

/* --- instances that are cut ----------------------------------------------------------------- */

WRAPPED(bool, fxl_bsp_cut,
        (fxl_bsp_cutter * cutter, const fxl_instance *instance, const fxl_point *eye,
         uint32_t entry))
{
    const uint32_t items = cutter->item_count, vertices = cutter->vertex_count;
    const bool done = __real_fxl_bsp_cut(cutter, instance, eye, entry);
    counted.tree_pieces += cutter->item_count - items;
    counted.tree_vertices += cutter->vertex_count - vertices;
    return done;
}

WRAPPED(bool, fxl_submit_bsp_leaf,
        (const fxl_traversal *traversal, fxl_bsp_workspace *workspace, uint32_t leaf,
         fxl_bsp_resume_point *place))
{
    counted.tree_leaves += 1;
    return __real_fxl_submit_bsp_leaf(traversal, workspace, leaf, place);
}
