/* SPDX-License-Identifier: MIT */
#include "scene/scene_check_all.c"
#include "scene_tables.h"

#define CLUSTERS 2

static fxl_cluster clusters[CLUSTERS];
static cluster_faces in;

/* A cluster of faces of a checked model, of one or two faces. */
static void any_cluster(void)
{
    any_checked_scene();
    ANY_CONTENT(clusters);
    const fxl_model *model = &models[0];
    const uint32_t first = nondet_u32();
    ASSUME(first < model->face_count && clusters[0].face_count >= 1 && clusters[0].face_count <= model->face_count - first);
    in.cluster = &clusters[0];
    in.faces = &faces[model->first_face + first];
    in.vertices = &vertices[model->first_vertex];
    in.indices = indices;
    for (uint32_t i = 0; i < FACES; i++) {
        ASSUME(FXL_DIRECTION(&faces[i].normal)); /* as check_normals leaves them */
    }
}

/* [[row]]
 * id = "check_models of clusters"
 * function = "check_models"
 * property = "any checked scene: nothing is out of bounds; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 334
 * unwind = 8
 */
void prove_check_models(void)
{
    any_checked_scene();
    (void)check_models(&scene, &fault);
    PROOF_ENDS();
}

/* [[row]]
 * function = "centre_is_among"
 * property = "any cluster of a checked model: nothing is out of bounds, and a centre that passes is below 2^30; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 518
 * unwind = 8
 */
void prove_centre_is_among(void)
{
    any_cluster();
    ASSERT("below 2^30", !centre_is_among(&in) || is_vertex(&clusters[0].centre));
    PROOF_ENDS();
}

/* [[row]]
 * id = "sphere_holds of a cluster"
 * function = "sphere_holds"
 * property = "any sphere, and one vertex of any face: nothing overflows or is out of bounds; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 417
 * unwind = 8
 */
/* One round: a vertex of a face. */
void prove_sphere_holds(void)
{
    any_checked_scene();
    ANY_CONTENT(clusters);
    const uint32_t first = fxl_face_first_index(&faces[0]);
    ASSUME(first < INDICES && indices[first] < VERTICES && is_vertex(&vertices[indices[first]]));
    ASSUME(faces[0].indices[0] == indices[first]);
    ASSUME(clusters[0].radius >= 0 && is_vertex(&clusters[0].centre));
    clusters[0].face_count = 1;
    faces[0].count = 1;
    in.cluster = &clusters[0];
    in.faces = faces;
    in.vertices = vertices;
    in.indices = indices;
    (void)sphere_holds(&in);
    PROOF_ENDS();
}

/* [[row]]
 * function = "dot_units"
 * property = "any two directions: nothing overflows"
 * checks = 53
 * unwind = 8
 */
void prove_dot_units(void)
{
    fxl_direction a, b;
    ASSUME(FXL_DIRECTION(&a) && FXL_DIRECTION(&b));
    (void)dot_units(&a, &b);
    PROOF_ENDS();
}

/* For dot_units and fxl_face_height. The scalar product of two vectors of unit length, to within the
 * tolerance of their squares, is at most 1 + 2^-28. */
int64_t any_dot_units(const fxl_direction *a, const fxl_direction *b)
{
    const int64_t dot = nondet_s64();
    ASSERT("directions", FXL_DIRECTION(a) && FXL_DIRECTION(b));
    ASSUME(WITHIN(dot, ((int64_t)1 << 60) + ((int64_t)1 << 32)) && (a != b || dot >= 0));
    return dot;
}

/* [[row]]
 * function = "faces_away"
 * property = "any face of a checked cluster and any cone: nothing overflows or is out of bounds; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 519
 * unwind = 8
 * stands_in = { dot_units = "any_dot_units", fxl_dot = "any_dot" }
 */
void prove_faces_away(void)
{
    any_cluster();
    ASSUME(FXL_DIRECTION(&clusters[0].axis) && FXL_POINT_BELOW(&clusters[0].apex, FXL_CLUSTER_APEX_MAX));
    (void)faces_away(&in, &in.faces[0]);
    PROOF_ENDS();
}

/* For centre_is_among, sphere_holds and faces_away: any answer. */
bool any_answer(const cluster_faces *of)
{
    ASSERT("of the cluster", of == &in && in.cluster->face_count >= 1);
    return nondet_bool();
}

bool any_away(const cluster_faces *of, const fxl_face *face)
{
    ASSERT("a face of the cluster", of == &in && face >= in.faces && face < in.faces + in.cluster->face_count);
    ASSERT("a checked cone", FXL_DIRECTION(&in.cluster->axis) && FXL_POINT_BELOW(&in.cluster->apex, FXL_CLUSTER_APEX_MAX));
    return nondet_bool();
}

/* [[row]]
 * function = "check_sphere"
 * property = "any cluster: a radius that passes is in its range; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 338
 * unwind = 8
 * stands_in = { centre_is_among = "any_answer", sphere_holds = "any_answer" }
 */
void prove_check_sphere(void)
{
    any_cluster();
    const fxl_status status = check_sphere(&in);
    ASSERT("a radius in its range", status != FXL_OK || (clusters[0].radius >= 0 && clusters[0].radius <= FXL_RADIUS_MAX));
    PROOF_ENDS();
}

/* [[row]]
 * function = "check_cone"
 * property = "any cluster: each face's test gets what it requires; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 508
 * unwind = 8
 * stands_in = { fxl_is_unit = "any_unit", faces_away = "any_away" }
 */
void prove_check_cone(void)
{
    any_cluster();
    (void)check_cone(&in);
    PROOF_ENDS();
}

/* For check_sphere and check_cone. */
fxl_status any_check(const cluster_faces *of)
{
    const fxl_model *model = &models[0];
    ASSERT("faces of the model", of->cluster->face_count >= 1 && of->faces >= faces + model->first_face &&
                                     of->faces + of->cluster->face_count <= faces + model->first_face + model->face_count);
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * function = "check_cluster"
 * property = "any cluster: its faces are the model's; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 414
 * unwind = 8
 * stands_in = { check_sphere = "any_check", check_cone = "any_check" }
 */
void prove_check_cluster(void)
{
    any_checked_scene();
    ANY_CONTENT(clusters);
    const uint32_t first = nondet_u32();
    ASSUME(first < models[0].face_count);
    const fxl_status status = check_cluster(&scene, &models[0], first, &clusters[0]);
    ASSERT("faces of the model", status != FXL_OK || (clusters[0].face_count >= 1 && clusters[0].face_count <= models[0].face_count - first));
    PROOF_ENDS();
}

/* For check_cluster. */
fxl_status any_checked_cluster(const fxl_scene *of, const fxl_model *model, uint32_t first, const fxl_cluster *cluster)
{
    const bool good = nondet_bool();
    ASSERT("of the scene", of == &scene && first < model->face_count && cluster >= clusters && cluster < clusters + scene.cluster_count);
    ASSUME(!good || (cluster->face_count >= 1 && cluster->face_count <= model->face_count - first));
    return good ? FXL_OK : FXL_E_CLUSTER;
}

/* [[row]]
 * function = "check_clusters"
 * property = "any model and up to 2 clusters: it ends, and no cluster is beyond the table"
 * checks = 432
 * unwind = 8
 * stands_in = { check_cluster = "any_checked_cluster" }
 */
void prove_check_clusters(void)
{
    any_checked_scene();
    ANY_CONTENT(clusters);
    scene.clusters = clusters;
    uint32_t next = nondet_u32(), number = nondet_u32();
    ASSUME(scene.cluster_count <= CLUSTERS && next <= scene.cluster_count && number < scene.model_count);
    (void)check_clusters(&scene, number, &next, &fault);
    ASSERT("never more than there are", next <= scene.cluster_count);
    PROOF_ENDS();
}

/* For check_models and check_clusters. */
fxl_status any_models(const fxl_scene *of, fxl_scene_fault *to)
{
    ASSERT("of the scene", of == &scene && to == &fault);
    return (fxl_status)nondet_u32();
}

fxl_status any_clusters(const fxl_scene *of, uint32_t number, uint32_t *next, fxl_scene_fault *to)
{
    (void)to;
    ASSERT("a model of the scene", of == &scene && number < scene.model_count && *next <= scene.cluster_count);
    *next = nondet_u32();
    ASSUME(*next <= scene.cluster_count);
    return (fxl_status)nondet_u32();
}

/* [[row]]
 * function = "fxl_cluster_check"
 * property = "any checked scene, with clusters or without: nothing is out of bounds; tables of up to 2 entries, 4 vertices and 6 indices"
 * checks = 367
 * unwind = 8
 * stands_in = { check_models = "any_models", check_clusters = "any_clusters" }
 */
void prove_cluster_check(void)
{
    any_checked_scene();
    scene.clusters = nondet_bool() ? clusters : NULL;
    const fxl_status status = fxl_cluster_check(&scene, &fault);
    ASSERT("a table, or none", status != FXL_OK || (scene.clusters == NULL) == (scene.cluster_count == 0));
    PROOF_ENDS();
}
