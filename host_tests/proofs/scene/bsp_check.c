/* SPDX-License-Identifier: MIT */
#include "scene/bsp_check.c"
#include "scene/bsp_node.h"
#include "scene_tables.h"
#include "proof.h"

#define NODES 2

static fxl_bsp_node nodes[NODES];

/* A checked scene with a tree whose object was checked, too. */
static void any_tree(void)
{
    any_checked_scene();
    ANY_CONTENT(nodes);
    scene.bsp_nodes = nodes;
    ASSUME(scene.bsp_node_count >= 1 && scene.bsp_node_count <= NODES && scene.bsp_instance < scene.instance_count);
}

static const fxl_model *model_of_tree(void)
{
    return &models[instances[scene.bsp_instance].model];
}

/* What check_nodes leaves of a node before its faces are looked at. */
static bool is_node(const fxl_bsp_node *node)
{
    return FXL_DIRECTION(&node->normal) && WITHIN(fxl_bsp_distance(node), (int64_t)1 << 61) && node->radius >= 0 && node->radius <= FXL_RADIUS_MAX &&
           WITHIN(node->centre.x, 2 * FXL_COORDINATE_MAX) && WITHIN(node->centre.y, 2 * FXL_COORDINATE_MAX) &&
           WITHIN(node->centre.z, 2 * FXL_COORDINATE_MAX);
}

/* [[row]]
 * function = "check_owner"
 * property = "any checked scene: nothing is out of bounds, and the object of a tree that passes has a sorted model without clusters; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 473
 * unwind = 8
 */
void prove_check_owner(void)
{
    any_checked_scene();
    const fxl_status status = check_owner(&scene, &fault);
    ASSERT("an instance of the scene", status != FXL_OK || scene.bsp_instance < scene.instance_count);
    ASSERT("of a sorted model without clusters", status != FXL_OK || (model_of_tree()->kind == FXL_MODEL_SORTED && model_of_tree()->first_cluster == 0));
    PROOF_ENDS();
}

/* [[row]]
 * id = "check_plane of a tree"
 * function = "check_plane"
 * property = "any node: one that passes has a unit normal and a distance below 2^61"
 * checks = 68
 * unwind = 8
 * stands_in = { fxl_is_unit = "any_unit" }
 */
void prove_check_plane(void)
{
    fxl_bsp_node node;
    const fxl_status status = check_plane(&node);
    ASSERT("a unit normal, and a distance below 2^61", status != FXL_OK || (FXL_DIRECTION(&node.normal) && WITHIN(fxl_bsp_distance(&node), (int64_t)1 << 61)));
    PROOF_ENDS();
}

/* [[row]]
 * function = "lies_on"
 * property = "any face of a checked model and any checked node: nothing overflows or is out of bounds; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 500
 * unwind = 8
 * stands_in = { fxl_dot = "any_dot" }
 */
void prove_lies_on(void)
{
    any_tree();
    const fxl_model *model = model_of_tree();
    const uint32_t i = nondet_u32();
    ASSUME(is_node(&nodes[0]) && i >= model->first_face && i < FACES && i - model->first_face < model->face_count);
    (void)lies_on(&scene, model, &faces[i], &nodes[0]);
    PROOF_ENDS();
}

/* [[row]]
 * function = "square_between"
 * property = "any two points below 2^30: nothing overflows"
 * checks = 63
 * unwind = 8
 */
void prove_square_between(void)
{
    fxl_point a, b;
    const int32_t limit = 2 * FXL_COORDINATE_MAX;
    ASSUME(FXL_POINT_BELOW(&a, limit) && FXL_POINT_BELOW(&b, limit));
    (void)square_between(&a, &b);
    PROOF_ENDS();
}

/* [[row]]
 * function = "square"
 * property = "any radius: nothing overflows"
 * checks = 2
 */
void prove_square(void)
{
    (void)square(nondet_s32());
    PROOF_ENDS();
}

/* [[row]]
 * function = "sphere_in_range"
 * property = "any node: nothing overflows, and one that passes is below 2^30; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 356
 * unwind = 8
 */
void prove_sphere_in_range(void)
{
    any_tree();
    ASSERT("twice the range", !sphere_in_range(&scene, &nodes[0]) ||
                                  (WITHIN(nodes[0].centre.x, 2 * FXL_COORDINATE_MAX) && WITHIN(nodes[0].centre.y, 2 * FXL_COORDINATE_MAX) &&
                                   WITHIN(nodes[0].centre.z, 2 * FXL_COORDINATE_MAX) && nodes[0].radius >= 0 && nodes[0].radius <= FXL_RADIUS_MAX));
    PROOF_ENDS();
}

/* For square_between: any square of points below 2^30. */
uint64_t any_square(const fxl_point *a, const fxl_point *b)
{
    ASSERT("below 2^30", FXL_POINT_BELOW(a, 2 * FXL_COORDINATE_MAX) && FXL_POINT_BELOW(b, 2 * FXL_COORDINATE_MAX));
    return nondet_u64();
}

/* For square. */
uint64_t any_radius_square(fxl_q16_16 radius)
{
    ASSERT("a radius", radius >= 0 && radius <= FXL_RADIUS_MAX);
    return nondet_u64();
}

/* [[row]]
 * id = "sphere_holds of a tree"
 * function = "sphere_holds"
 * property = "any node whose faces are the model's: nothing overflows or is out of bounds; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 614
 * unwind = 8
 * stands_in = { square_between = "any_square", square = "any_radius_square" }
 */
void prove_sphere_holds(void)
{
    any_tree();
    const fxl_model *model = model_of_tree();
    const uint32_t number = nondet_u32();
    ASSUME(number < scene.bsp_node_count);
    for (uint32_t i = 0; i < NODES; i++) {
        ASSUME(i > number || is_node(&nodes[i]));
    }
    ASSUME(nodes[number].first_face <= model->face_count && nodes[number].face_count <= model->face_count - nodes[number].first_face);
    (void)sphere_holds(&scene, model, number);
    PROOF_ENDS();
}

/* For check_plane, sphere_in_range, lies_on and sphere_holds: what their rows assume and assert. */
fxl_status any_plane(const fxl_bsp_node *node)
{
    const bool good = nondet_bool();
    ASSUME(!good || (FXL_DIRECTION(&node->normal) && WITHIN(fxl_bsp_distance(node), (int64_t)1 << 61)));
    return good ? FXL_OK : FXL_E_NORMAL;
}

bool any_range(const fxl_scene *of, const fxl_bsp_node *node)
{
    const bool good = nondet_bool();
    ASSERT("of the scene", of == &scene && node >= nodes && node < nodes + scene.bsp_node_count);
    ASSUME(!good || (WITHIN(node->centre.x, 2 * FXL_COORDINATE_MAX) && WITHIN(node->centre.y, 2 * FXL_COORDINATE_MAX) &&
                     WITHIN(node->centre.z, 2 * FXL_COORDINATE_MAX) && node->radius >= 0 && node->radius <= FXL_RADIUS_MAX));
    return good;
}

bool any_lies_on(const fxl_scene *of, const fxl_model *model, const fxl_face *face, const fxl_bsp_node *node)
{
    ASSERT("a face of the model, a checked node", of == &scene && face >= faces + model->first_face &&
                                                      face < faces + model->first_face + model->face_count && is_node(node));
    return nondet_bool();
}

bool any_holds(const fxl_scene *of, const fxl_model *model, uint32_t number)
{
    ASSERT("faces of the model, a checked node", of == &scene && number < scene.bsp_node_count && is_node(&nodes[number]) &&
                                                     nodes[number].first_face <= model->face_count &&
                                                     nodes[number].face_count <= model->face_count - nodes[number].first_face);
    return nondet_bool();
}

/* [[row]]
 * function = "check_nodes"
 * property = "any tree of up to 2 nodes: each test gets what it requires"
 * checks = 645
 * unwind = 8
 * stands_in = { check_plane = "any_plane", sphere_in_range = "any_range", lies_on = "any_lies_on", sphere_holds = "any_holds" }
 */
void prove_check_nodes(void)
{
    any_tree();
    (void)check_nodes(&scene, &fault);
    PROOF_ENDS();
}

/* [[row]]
 * function = "check_links"
 * property = "any links of up to 2 nodes: it ends, and nothing is out of bounds"
 * checks = 393
 * unwind = 8
 */
void prove_check_links(void)
{
    any_tree();
    (void)check_links(&scene, &fault);
    PROOF_ENDS();
}

/* For check_owner, check_nodes and check_links: any status. */
static unsigned passed; /* how many of them gave FXL_OK */
fxl_status any_check(const fxl_scene *of, fxl_scene_fault *to)
{
    ASSERT("a tree of nodes", of == &scene && to == &fault && scene.bsp_node_count >= 1 && scene.bsp_node_count <= FXL_BSP_NODES_MAX);
    const fxl_status status = (fxl_status)nondet_u32();
    passed += status == FXL_OK;
    return status;
}

/* [[row]]
 * function = "fxl_bsp_check"
 * property = "any checked scene, with a tree or without: nothing is looked at but nodes of the table, and a checked tree has passed all three checks"
 * checks = 329
 * unwind = 8
 * stands_in = { check_owner = "any_check", check_nodes = "any_check", check_links = "any_check" }
 */
void prove_bsp_check(void)
{
    any_checked_scene();
    scene.bsp_nodes = nondet_bool() ? nodes : NULL;
    passed = 0;
    const fxl_status status = fxl_bsp_check(&scene, &fault);
    ASSERT("a checked tree has passed all three checks", status != FXL_OK || scene.bsp_nodes == NULL || passed == 3);
    ASSERT("without a tree there are no nodes", status != FXL_OK || scene.bsp_nodes != NULL || scene.bsp_node_count == 0);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/scene/bsp_node.h:fxl_bsp_is_front"
 * property = "any checked node and any point below 2^30: nothing overflows, and the distance is that of both halves"
 * checks = 87
 * stands_in = { fxl_dot = "any_dot" }
 */
/* As check_plane of lib/scene/bsp_check.c leaves a node: its row asserts it. */
void prove_bsp_is_front(void)
{
    fxl_bsp_node node;
    fxl_point point;
    ASSUME(FXL_DIRECTION(&node.normal) && FXL_POINT_BELOW(&point, 1 << 30));
    const fxl_q18_46 distance = fxl_bsp_distance(&node);
    ASSERT("both halves", fxl_low_32(fxl_bits_64(distance)) == node.distance_low && (int32_t)(distance >> 32) == fxl_signed_32(node.distance_high));
    (void)fxl_bsp_is_front(&node, &point);
    PROOF_ENDS();
}
