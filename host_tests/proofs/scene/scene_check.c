/* SPDX-License-Identifier: MIT */
#include "scene/scene_check.c"
#define VERTICES 6 /* of two models */
#include "scene_tables.h"

static uint32_t below(uint32_t end)
{
    const uint32_t i = nondet_u32();
    ASSUME(i < end);
    return i;
}

/* [[row]]
 * id = "check_counts of a scene"
 * function = "check_counts"
 * property = "any counts: those that pass are in range; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 43
 * unwind = 8
 */
void prove_check_counts(void)
{
    any_scene();
    scene.vertex_count = nondet_u32();
    scene.index_count = nondet_u32();
    scene.face_count = nondet_u32();
    scene.model_count = nondet_u32();
    scene.instance_count = nondet_u32();
    const fxl_status status = check_counts(&scene, &fault);
    ASSERT("in range", status != FXL_OK || (scene.vertex_count >= 1 && scene.vertex_count <= FXL_SCENE_VERTICES_MAX &&
                                            scene.index_count <= FXL_SCENE_INDICES_MAX && scene.face_count <= FXL_SCENE_FACES_MAX &&
                                            scene.model_count >= 1 && scene.model_count <= FXL_SCENE_MODELS_MAX && scene.instance_count >= 1 &&
                                            scene.instance_count <= FXL_SCENE_INSTANCES_MAX));
    PROOF_ENDS();
}

/* [[row]]
 * function = "check_faces"
 * property = "any faces: of those that pass the indices lie in their table; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 189
 * unwind = 8
 */
void prove_check_faces(void)
{
    any_scene();
    const uint32_t i = below(FACES);
    const fxl_status status = check_faces(&scene, &fault);
    ASSERT("each is a face", status != FXL_OK || i >= scene.face_count || is_face(&faces[i]));
    PROOF_ENDS();
}

/* [[row]]
 * function = "check_indices"
 * property = "any model and faces that passed: nothing is out of bounds, and indices that pass are below the number of vertices; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 365
 * unwind = 8
 */
void prove_check_indices(void)
{
    any_scene();
    const uint32_t number = below(MODELS);
    for (uint32_t i = 0; i < FACES; i++) {
        ASSUME(i >= scene.face_count || is_face(&faces[i]));
    }
    ASSUME(is_model(&models[number]));
    const fxl_status status = check_indices(&scene, &models[number], &fault);
    const uint32_t i = below(FACES), corner = below(INDICES);
    ASSERT("each index is below the number of vertices",
           status != FXL_OK || i < models[number].first_face || i - models[number].first_face >= models[number].face_count ||
               index_is_below(i, corner, models[number].vertex_count));
    PROOF_ENDS();
}

/* For check_indices. */
fxl_status any_indices(const fxl_scene *of, const fxl_model *model, fxl_scene_fault *to)
{
    (void)to;
    ASSERT("a model", of == &scene && is_model(model));
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * id = "check_models of a scene"
 * function = "check_models"
 * property = "any models: those that pass lie in their tables; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 196
 * unwind = 8
 * stands_in = { check_indices = "any_indices" }
 */
void prove_check_models(void)
{
    any_scene();
    const uint32_t i = below(MODELS);
    const fxl_status status = check_models(&scene, &fault);
    ASSERT("each is a model", status != FXL_OK || i >= scene.model_count || is_model(&models[i]));
    PROOF_ENDS();
}

/* [[row]]
 * function = "check_instances"
 * property = "any instances: those that pass have a model, and a centre in the world; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 143
 * unwind = 8
 */
void prove_check_instances(void)
{
    any_scene();
    const uint32_t i = below(INSTANCES);
    const fxl_status status = check_instances(&scene, &fault);
    ASSERT("each is an instance", status != FXL_OK || i >= scene.instance_count || is_instance(&instances[i]));
    PROOF_ENDS();
}

static fxl_status any_check_placements(const fxl_scene *of, uint32_t *number)
{
    ASSERT("turned instances", of == &scene && scene.first_turned <= scene.instance_count);
    *number = nondet_u32();
    return (fxl_status)nondet_u32();
}

static const fxl_placement_code code = {.check = any_check_placements};
static fxl_placement placement;

/* [[row]]
 * function = "check_placed_vertices"
 * property = "any models and instances that passed: nothing overflows or is out of bounds; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 423
 * unwind = 8
 */
void prove_check_placed_vertices(void)
{
    any_checked_scene();
    scene.placements = nondet_bool() ? &placement : NULL;
    (void)check_placed_vertices(&scene, &fault);
    PROOF_ENDS();
}

/* [[row]]
 * function = "check_vertices"
 * property = "any vertices: those that pass are below 2^30; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 88
 * unwind = 8
 */
void prove_check_vertices(void)
{
    any_scene();
    const uint32_t i = below(VERTICES);
    const fxl_status status = check_vertices(&scene, &fault);
    ASSERT("each below 2^30", status != FXL_OK || i >= scene.vertex_count || is_vertex(&vertices[i]));
    PROOF_ENDS();
}

/* [[row]]
 * function = "check_radii"
 * property = "any model and vertex that passed: no square overflows, nor their sum; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 122
 * unwind = 8
 */
void prove_check_radii(void)
{
    any_scene();
    scene.model_count = 1;
    models[0].first_vertex = below(VERTICES);
    models[0].vertex_count = 1; /* a round in any state: none depends on those before */
    ASSUME(models[0].radius >= 0 && models[0].radius <= FXL_RADIUS_MAX && is_vertex(&vertices[models[0].first_vertex]));
    (void)check_radii(&scene, &fault);
    PROOF_ENDS();
}

/* [[row]]
 * function = "is_flat"
 * property = "any normal of a direction's range, any two vertices that passed: nothing overflows"
 * checks = 217
 * unwind = 8
 */
void prove_is_flat(void)
{
    any_scene();
    models[0].first_vertex = 0;
    faces[0].count = 2; /* a round in any state */
    ASSUME(fxl_face_first_index(&faces[0]) <= INDICES - 2 && faces[0].indices[0] < VERTICES && fxl_face_indices(indices, &faces[0])[1] < VERTICES);
    ASSUME(FXL_DIRECTION(&faces[0].normal) && is_vertex(&vertices[faces[0].indices[0]]) &&
           is_vertex(&vertices[fxl_face_indices(indices, &faces[0])[1]]));
    (void)is_flat(&scene, &models[0], &faces[0]);
    PROOF_ENDS();
}

/* For is_flat. */
bool any_flat(const fxl_scene *of, const fxl_model *model, const fxl_face *face)
{
    ASSERT("a face of the model, of a unit normal", of == &scene && is_model(model) && is_face(face) && FXL_DIRECTION(&face->normal));
    return nondet_bool();
}

/* [[row]]
 * function = "check_normals"
 * property = "any models and faces that passed: what the tests require; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 420
 * unwind = 8
 * stands_in = { is_flat = "any_flat", fxl_is_unit = "any_unit" }
 */
void prove_check_normals(void)
{
    any_checked_scene();
    (void)check_normals(&scene, &fault);
    PROOF_ENDS();
}

static fxl_face_bounds bounds[FACES];

/* [[row]]
 * function = "face_bounds_match"
 * property = "any face that passed: nothing overflows or is out of bounds; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 527
 * unwind = 8
 * stands_in = { fxl_dot = "any_dot" }
 */
void prove_face_bounds_match(void)
{
    any_checked_scene();
    const uint32_t number = below(MODELS), i = below(FACES), key = below(FACES);
    const fxl_model *model = &models[number];
    ASSUME(number < scene.model_count && i >= model->first_face && i - model->first_face < model->face_count && FXL_DIRECTION(&faces[i].normal));
    (void)face_bounds_match(&scene, model, &faces[i], &bounds[key]);
    PROOF_ENDS();
}

/* For face_bounds_match. */
bool any_match(const fxl_scene *of, const fxl_model *model, const fxl_face *face, const fxl_face_bounds *key)
{
    ASSERT("a face of the model", of == &scene && is_model(model) && face >= faces + model->first_face &&
                                      face < faces + model->first_face + model->face_count);
    ASSERT("a key of the table", key >= bounds && key < bounds + scene.face_bounds_count);
    return nondet_bool();
}

/* [[row]]
 * function = "check_face_bounds"
 * property = "any models that passed and any face bounds: nothing is out of bounds; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 465
 * unwind = 8
 * stands_in = { face_bounds_match = "any_match" }
 */
void prove_check_face_bounds(void)
{
    any_checked_scene();
    scene.face_bounds = nondet_bool() ? bounds : NULL;
    ASSUME(scene.face_bounds_count <= FACES);
    (void)check_face_bounds(&scene, &fault);
    PROOF_ENDS();
}

/* For each check: any status. */
static unsigned checked;
fxl_status any_check(const fxl_scene *of, fxl_scene_fault *to)
{
    ASSERT("of the scene", of == &scene && to == &fault);
    checked++;
    return (fxl_status)nondet_u32();
}

static bool more_checked;
static fxl_status any_more(const fxl_scene *of, fxl_scene_fault *to)
{
    ASSERT("after all others", of == &scene && to == &fault && checked == 10);
    more_checked = true;
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * function = "fxl_scene_check_with"
 * property = "any scene, or null: one that passes was checked by all, in their order; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 251
 * unwind = 12
 * stands_in = { check_counts = "any_check", check_faces = "any_check", check_models = "any_check", check_instances = "any_check", check_placed_vertices = "any_check", check_vertices = "any_check", check_radii = "any_check", check_normals = "any_check", check_face_bounds = "any_check", check_placements = "any_check" }
 */
void prove_scene_check_with(void)
{
    any_scene();
    scene.vertices = nondet_bool() ? vertices : NULL;
    checked = 0;
    more_checked = false;
    const fxl_status status = fxl_scene_check_with(nondet_bool() ? &scene : NULL, &fault, any_more);
    ASSERT("checked by all", status != FXL_OK || (checked == 10 && more_checked));
    PROOF_ENDS();
}

/* [[row]]
 * function = "check_bare"
 * property = "any scene: one that passes has neither tree nor beams nor clusters; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 75
 * unwind = 8
 */
void prove_check_bare(void)
{
    any_scene();
    const fxl_status status = check_bare(&scene, &fault);
    ASSERT("no tree, no beams, no clusters", status != FXL_OK || (scene.bsp_node_count == 0 && scene.beam_count == 0 && scene.cluster_count == 0));
    PROOF_ENDS();
}

/* For fxl_scene_check_with. */
fxl_status any_check_with(fxl_scene *of, fxl_scene_fault *to, fxl_scene_checker *more)
{
    ASSERT("the bare scene's", of == &scene && to == &fault && more == check_bare);
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * function = "fxl_scene_check"
 * property = "any scene: the checks of a bare one; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 1
 * unwind = 8
 * stands_in = { fxl_scene_check_with = "any_check_with" }
 */
void prove_scene_check(void)
{
    any_scene();
    (void)fxl_scene_check(&scene, &fault);
    PROOF_ENDS();
}

/* [[row]]
 * function = "lib/scene/placement_code.h:fxl_placement_code_of"
 * property = "any instance, turned or not: its number and its placement, in their tables; tables of up to 2 entries, 6 vertices and 6 indices"
 * checks = 1527
 */
void prove_placement_code_of(void)
{
    any_scene();
    static fxl_placement some[INSTANCES];
    const uint32_t number = below(INSTANCES);
    scene.placements = nondet_bool() ? some : NULL;
    scene.placement_code = &code;
    ASSUME(number < scene.instance_count && scene.first_turned <= scene.instance_count);
    ASSERT("at most all", fxl_first_turned(&scene) <= scene.instance_count);
    ASSERT("its number", fxl_instance_number(&scene, &instances[number]) == number);
    const bool turned = fxl_placement_code_of(&scene, number) != NULL;
    ASSERT("a placement of the table", !turned || (fxl_placement_of(&scene, number) >= some && fxl_placement_of(&scene, number) < some + INSTANCES));
    (void)fxl_check_placements(&scene);
    PROOF_ENDS();
}
