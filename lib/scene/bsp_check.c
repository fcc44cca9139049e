/* SPDX-License-Identifier: MIT */
#include "scene_check.h"

#include "../math/plane.h"
#include "bsp_node.h"
#include "scene_check.h"
#include "placement_code.h"

/* place field: the check of a tree's values */
/* The object: its model is sorted, so that who knows no tree can draw it, and no
 * other object's, so that nothing else is to be clipped to the tree with it. It has no
 * clusters, because the nodes take its faces in turn. What is
 * clipped to it, the other objects of its layer, is convex. */
/* formats 1.7 */
static FXL_COLD fxl_status check_owner(const fxl_scene *scene, fxl_scene_fault *fault)
{
    if (scene->bsp_instance >= scene->instance_count) {
        return fxl_fault_at(fault, "BSP tree", 0, FXL_E_INDEX);
    }
    if (fxl_placement_code_of(scene, scene->bsp_instance) != NULL) {
        return fxl_fault_at(fault, "BSP tree", 0, FXL_E_BSP);
    }
    const fxl_instance *owner = &scene->instances[scene->bsp_instance];
    uint32_t model = owner->model;
    if (scene->models[model].kind != FXL_MODEL_SORTED) {
        return fxl_fault_at(fault, "BSP tree", 0, FXL_E_RESERVED);
    }
    if (scene->models[model].first_cluster != 0) {
        return fxl_fault_at(fault, "BSP tree", 0, FXL_E_BSP);
    }
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const fxl_instance *instance = &scene->instances[i];
        bool shares = instance->model == model;
        bool moves = instance->layer == owner->layer;
        if (instance != owner &&
            (shares || (moves && scene->models[instance->model].kind != FXL_MODEL_CONVEX))) {
            return fxl_fault_at(fault, "instance", i, FXL_E_BSP);
        }
    }
    return FXL_OK;
}

/* formats 1.7 */
static FXL_COLD fxl_status check_plane(const fxl_bsp_node *node)
{
    if (node->reserved != 0) {
        return FXL_E_RESERVED;
    }
    if (!fxl_is_unit(&node->normal)) {
        return FXL_E_NORMAL;
    }
    return fxl_within(fxl_bsp_distance(node), (int64_t)1 << 61) ? FXL_OK : FXL_E_RANGE;
}

/* Whether all vertices of a face lie on the node's plane, to within FXL_BSP_PLANARITY_MAX. A
 * vertex is below 2^30 in each coordinate, so its height is below 2^61, and the difference is
 * below 2^62. */
/* formats 1.7 */
static bool lies_on(const fxl_scene *scene, const fxl_model *model, const fxl_face *face,
                    const fxl_bsp_node *node)
{
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    for (uint32_t i = 0; i < face->count; i++) {
        const fxl_point *vertex = &vertices[fxl_face_indices(scene->indices, face)[i]];
        int64_t height = fxl_dot(&node->normal, vertex->x, vertex->y, vertex->z);
        if (!fxl_within(height - fxl_bsp_distance(node),
                        (int64_t)FXL_BSP_PLANARITY_MAX * FXL_Q2_30_ONE)) {
            return false;
        }
    }
    return true;
}

/* The squared distance of two points. Each coordinate is below 2^30, so the differences are
 * below 2^31 and the sum is below 3 * 2^62. */
static uint64_t square_between(const fxl_point *a, const fxl_point *b)
{
    const int64_t x = (int64_t)a->x - b->x, y = (int64_t)a->y - b->y, z = (int64_t)a->z - b->z;
    return (uint64_t)(x * x) + (uint64_t)(y * y) + (uint64_t)(z * z);
}

static uint64_t square(fxl_q16_16 radius)
{
    return (uint64_t)((int64_t)radius * radius);
}

/* Whether the centre of the node's sphere lies in the world, and the radius is at most
 * FXL_RADIUS_MAX. */
static bool sphere_in_range(const fxl_scene *scene, const fxl_bsp_node *node)
{
    const fxl_point *origin = &scene->instances[scene->bsp_instance].centre;
    const int64_t limit = FXL_COORDINATE_MAX;
    return fxl_within((int64_t)node->centre.x + origin->x, limit) &&
           fxl_within((int64_t)node->centre.y + origin->y, limit) &&
           fxl_within((int64_t)node->centre.z + origin->z, limit) && node->radius >= 0 &&
           node->radius <= FXL_RADIUS_MAX;
}

/* Whether the node's sphere holds the node's faces and lies within its parent's sphere. The node
 * of the parent's number is taken for the parent; check_links checks that it is. */
/* formats 1.7 */
static bool sphere_holds(const fxl_scene *scene, const fxl_model *model, uint32_t number)
{
    const fxl_bsp_node *node = &scene->bsp_nodes[number];
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    for (uint32_t j = 0; j < node->face_count; j++) {
        const fxl_face *face = &scene->faces[model->first_face + node->first_face + j];
        for (uint32_t i = 0; i < face->count; i++) {
            const fxl_point *vertex = &vertices[fxl_face_indices(scene->indices, face)[i]];
            if (square_between(vertex, &node->centre) > square(node->radius)) {
                return false;
            }
        }
    }
    if (node->parent >= number) {
        return true;
    }
    const fxl_bsp_node *above = &scene->bsp_nodes[node->parent];
    return above->radius >= node->radius &&
           square_between(&above->centre, &node->centre) <= square(above->radius - node->radius);
}

/* Checks planes, spheres and faces. The nodes take the model's faces in turn. */
/* bsp 1.1, formats 1.7 */
static FXL_COLD fxl_status check_nodes(const fxl_scene *scene, fxl_scene_fault *fault)
{
    const fxl_model *model = &scene->models[scene->instances[scene->bsp_instance].model];
    uint32_t first = 0;
    for (uint32_t i = 0; i < scene->bsp_node_count; i++) {
        const fxl_bsp_node *node = &scene->bsp_nodes[i];
        fxl_status status = check_plane(node);
        if (status == FXL_OK && !sphere_in_range(scene, node)) {
            status = FXL_E_RANGE;
        }
        if (status != FXL_OK) {
            return fxl_fault_at(fault, "BSP node", i, status);
        }
        if (node->first_face != first || node->face_count > model->face_count - first) {
            return fxl_fault_at(fault, "BSP node", i, FXL_E_INDEX);
        }
        for (uint32_t j = 0; j < node->face_count; j++) {
            uint32_t number = model->first_face + first + j;
            if (!lies_on(scene, model, &scene->faces[number], node)) {
                return fxl_fault_at(fault, "BSP node", i, FXL_E_PLANARITY);
            }
        }
        if (!sphere_holds(scene, model, i)) {
            return fxl_fault_at(fault, "BSP node", i, FXL_E_RADIUS);
        }
        first += node->face_count;
    }
    bool complete = first == model->face_count;
    return complete ? FXL_OK : fxl_fault_at(fault, "BSP node table", 0, FXL_E_COUNT);
}

/* Traverses the tree in pre-order, without a stack. Each step down must be to the next number, so
 * the traversal ends. Each step up is to the parent, from which a step down was made. At the end
 * every node must have been visited. */
/* bsp 1.1, formats 1.7 */
static FXL_COLD fxl_status check_links(const fxl_scene *scene, fxl_scene_fault *fault)
{
    const fxl_bsp_node *nodes = scene->bsp_nodes;
    uint32_t at = 0, next = 1, depth = 0;
    bool front_done = false;
    if (nodes[0].parent != FXL_BSP_NONE) {
        return fxl_fault_at(fault, "BSP node", 0, FXL_E_BSP);
    }
    for (;;) {
        uint32_t below = front_done ? nodes[at].back : nodes[at].front;
        if (below != FXL_BSP_NONE) {
            if (below != next || next >= scene->bsp_node_count || nodes[below].parent != at ||
                depth == FXL_BSP_DEPTH_MAX) {
                return fxl_fault_at(fault, "BSP node", at, FXL_E_BSP);
            }
            at = below;
            next += 1;
            depth += 1;
            front_done = false;
        } else if (!front_done) {
            front_done = true;
        } else {
            /* Up, past every node of which this is the back child. */
            uint32_t from;
            do {
                from = at;
                at = nodes[at].parent;
                depth -= 1;
            } while (at != FXL_BSP_NONE && nodes[at].front != from);
            if (at == FXL_BSP_NONE) {
                break;
            }
        }
    }
    return next == scene->bsp_node_count ? FXL_OK
                                         : fxl_fault_at(fault, "BSP node", next, FXL_E_BSP);
}

FXL_COLD fxl_status fxl_bsp_check(const fxl_scene *scene, fxl_scene_fault *fault)
{
    if (scene->bsp_nodes == NULL) {
        return scene->bsp_node_count == 0 && scene->bsp_instance == 0
                   ? FXL_OK
                   : fxl_fault_at(fault, "BSP node table", 0, FXL_E_COUNT);
    }
    if (scene->bsp_node_count == 0 || scene->bsp_node_count > FXL_BSP_NODES_MAX) {
        return fxl_fault_at(fault, "BSP node table", 0, FXL_E_COUNT);
    }
    fxl_status status = check_owner(scene, fault);
    if (status == FXL_OK) {
        status = check_nodes(scene, fault);
    }
    return status == FXL_OK ? check_links(scene, fault) : status;
}
