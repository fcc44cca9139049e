/* SPDX-License-Identifier: MIT */
/* The check of a scene that may have clusters, a BSP tree, beams and placements. It is a file of
 * its own, so that a program whose scene has none of them does not link these checks. */
#include "scene_check.h"

#include "../math/plane.h"
#include "face_bounds.h"
#include "fixel/scene.h"

/* --- clusters -------------------------------------------------------------------------------- */

/* The faces of a cluster within its model. */
typedef struct {
    const fxl_cluster *cluster;
    const fxl_face *faces;
    const fxl_point *vertices; /* of the model */
    const uint16_t *indices;   /* of the scene */
} cluster_faces;

/* place field: the check of a cluster's values */
/* Whether a model may say that it has clusters. */
static FXL_COLD fxl_status check_models(const fxl_scene *scene, fxl_scene_fault *fault)
{
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const fxl_model *model = &scene->models[i];
        if (model->first_cluster != 0 &&
            (scene->cluster_count == 0 || model->kind != FXL_MODEL_SORTED)) {
            return fxl_fault_at(fault, "model", i, FXL_E_RESERVED);
        }
    }
    return FXL_OK;
}

/* Whether low <= value <= high for each coordinate. */
static bool box_holds(const fxl_point *low, const fxl_point *high, const fxl_point *value)
{
    return value->x >= low->x && value->x <= high->x && value->y >= low->y && value->y <= high->y &&
           value->z >= low->z && value->z <= high->z;
}

/* Whether the sphere's centre lies in the bounding box of the faces. So the centre lies in the
 * world wherever an instance of the model lies. */
static bool centre_is_among(const cluster_faces *in)
{
    fxl_point low = in->vertices[in->faces[0].indices[0]];
    fxl_point high = low;
    for (uint32_t i = 0; i < in->cluster->face_count; i++) {
        for (uint32_t corner = 0; corner < in->faces[i].count; corner++) {
            const fxl_point *vertex =
                &in->vertices[fxl_face_indices(in->indices, &in->faces[i])[corner]];
            fxl_widen(vertex->x, &low.x, &high.x);
            fxl_widen(vertex->y, &low.y, &high.y);
            fxl_widen(vertex->z, &low.z, &high.z);
        }
    }
    return box_holds(&low, &high, &in->cluster->centre);
}

/* Whether all vertices lie in the sphere. Each coordinate of a model is below 2^30, so differences
 * are below 2^31 and the sum is below 3 * 2^62. Exact. */
/* formats 1.8 */
static bool sphere_holds(const cluster_faces *in)
{
    const fxl_point *centre = &in->cluster->centre;
    const uint64_t most = (uint64_t)((int64_t)in->cluster->radius * in->cluster->radius);
    for (uint32_t i = 0; i < in->cluster->face_count; i++) {
        for (uint32_t corner = 0; corner < in->faces[i].count; corner++) {
            const fxl_point *vertex =
                &in->vertices[fxl_face_indices(in->indices, &in->faces[i])[corner]];
            const int64_t x = (int64_t)vertex->x - centre->x, y = (int64_t)vertex->y - centre->y,
                          z = (int64_t)vertex->z - centre->z;
            if ((uint64_t)(x * x) + (uint64_t)(y * y) + (uint64_t)(z * z) > most) {
                return false;
            }
        }
    }
    return true;
}

/* a . b for vectors of unit length, in units of 2^-60: below 2^61. */
static int64_t dot_units(const fxl_direction *a, const fxl_direction *b)
{
    return (int64_t)a->x * b->x + (int64_t)a->y * b->y + (int64_t)a->z * b->z;
}

/* Whether a face shows no front to any eye in the cone.
 *
 * It shows none to the apex: normal . apex <= height, exactly. So it shows none to an eye with
 * normal . u >= 0, where u = apex - eye. For the u of the cone that holds if the angle between
 * normal and axis is at most a right angle less the angle between axis and border of the cone. With
 * cutoff = K 2^32, the cosine of that second angle is at least sqrt(K) / |axis|. So it must be that
 * normal . axis >= 0 and (normal . axis)^2 >= |normal|^2 (|axis|^2 - K).
 *
 * rest is |axis|^2 - K in units of 2^-60. along is normal . axis in units of 2^-30, rounded down.
 * |normal|^2 is at most 1 + 2^-28, hence the addition. All are below 2^61. */
/* formats 1.8 */
static bool faces_away(const cluster_faces *in, const fxl_face *face)
{
    const fxl_cluster *cluster = in->cluster;
    const fxl_point *apex = &cluster->apex;
    const int64_t along = dot_units(&face->normal, &cluster->axis) >> 30;
    const int64_t across =
        dot_units(&cluster->axis, &cluster->axis) - (int64_t)((uint64_t)cluster->cutoff << 28);
    return fxl_dot(&face->normal, apex->x, apex->y, apex->z) <=
               fxl_face_height(in->vertices, face) &&
           along >= 0 && along * along >= across + (across >> 28) + 1;
}

static FXL_COLD fxl_status check_sphere(const cluster_faces *in)
{
    if (in->cluster->radius < 0 || in->cluster->radius > FXL_RADIUS_MAX || !centre_is_among(in)) {
        return FXL_E_RANGE;
    }
    return sphere_holds(in) ? FXL_OK : FXL_E_RADIUS;
}

/* formats 1.8 */
static FXL_COLD fxl_status check_cone(const cluster_faces *in)
{
    const fxl_cluster *cluster = in->cluster;
    const fxl_point *apex = &cluster->apex;
    if ((cluster->axis.x | cluster->axis.y | cluster->axis.z) == 0) {
        bool empty = cluster->cutoff == 0 && (apex->x | apex->y | apex->z) == 0;
        return empty ? FXL_OK : FXL_E_RESERVED;
    }
    if (!fxl_is_unit(&cluster->axis)) {
        return FXL_E_NORMAL;
    }
    if (!fxl_within(apex->x, FXL_CLUSTER_APEX_MAX) || !fxl_within(apex->y, FXL_CLUSTER_APEX_MAX) ||
        !fxl_within(apex->z, FXL_CLUSTER_APEX_MAX)) {
        return FXL_E_RANGE;
    }
    for (uint32_t i = 0; i < cluster->face_count; i++) {
        if (!faces_away(in, &in->faces[i])) {
            return FXL_E_CLUSTER;
        }
    }
    return FXL_OK;
}

/* Checks the cluster whose first face within the model is the stated one. */
/* formats 1.8 */
static FXL_COLD fxl_status check_cluster(const fxl_scene *scene, const fxl_model *model,
                                         uint32_t first, const fxl_cluster *cluster)
{
    const cluster_faces in = {cluster, &scene->faces[model->first_face + first],
                              &scene->vertices[model->first_vertex], scene->indices};
    if (cluster->reserved != 0) {
        return FXL_E_RESERVED;
    }
    if (cluster->face_count == 0 || cluster->face_count > model->face_count - first) {
        return FXL_E_COUNT;
    }
    fxl_status status = check_sphere(&in);
    return status == FXL_OK ? check_cone(&in) : status;
}

/* Checks the clusters of a model. *next is the number of the first, and becomes that of the next
 * model's first. */
static FXL_COLD fxl_status check_clusters(const fxl_scene *scene, uint32_t number, uint32_t *next,
                                          fxl_scene_fault *fault)
{
    const fxl_model *model = &scene->models[number];
    uint32_t first = 0;
    if (model->first_cluster != *next + 1) {
        return fxl_fault_at(fault, "model", number, FXL_E_INDEX);
    }
    while (first < model->face_count) {
        if (*next == scene->cluster_count) {
            return fxl_fault_at(fault, "model", number, FXL_E_INDEX);
        }
        fxl_status status = check_cluster(scene, model, first, &scene->clusters[*next]);
        if (status != FXL_OK) {
            return fxl_fault_at(fault, "cluster", *next, status);
        }
        first += scene->clusters[*next].face_count;
        *next += 1;
    }
    return FXL_OK;
}

FXL_COLD fxl_status fxl_cluster_check(const fxl_scene *scene, fxl_scene_fault *fault)
{
    if ((scene->clusters == NULL) != (scene->cluster_count == 0) ||
        scene->cluster_count > FXL_SCENE_CLUSTERS_MAX) {
        return fxl_fault_at(fault, "cluster table", 0, FXL_E_COUNT);
    }
    fxl_status status = check_models(scene, fault);
    uint32_t next = 0;
    for (uint32_t i = 0; status == FXL_OK && i < scene->model_count; i++) {
        if (scene->models[i].first_cluster != 0) {
            status = check_clusters(scene, i, &next, fault);
        }
    }
    if (status == FXL_OK && next != scene->cluster_count) {
        return fxl_fault_at(fault, "cluster table", 0, FXL_E_COUNT);
    }
    return status;
}

/* --- the rest --------------------------------------------------------------------------------- */

/* place field: the check of its values, in the file of its table */
static fxl_status check_beams(const fxl_scene *scene, fxl_scene_fault *fault)
{
    if (scene->beam_count == 0) {
        return FXL_OK;
    }
    if (scene->beams == NULL || scene->lit == NULL) {
        return fxl_fault_at(fault, "beam table", 0, FXL_E_ARGUMENT);
    }
    if (scene->beam_count > FXL_BEAMS_MAX) {
        return fxl_fault_at(fault, "beam table", 0, FXL_E_COUNT);
    }
    for (uint32_t i = 0; i < scene->beam_count; i++) {
        fxl_status status = fxl_beam_check(&scene->beams[i]);
        if (status != FXL_OK) {
            return fxl_fault_at(fault, "beam", i, status);
        }
    }
    for (uint32_t i = 0; i < scene->face_count; i++) {
        if (!fxl_beams_fit(scene->beams, scene->beam_count, scene->faces[i].count)) {
            return fxl_fault_at(fault, "face", i, FXL_E_CAPACITY);
        }
    }
    return FXL_OK;
}

static fxl_status check_more(const fxl_scene *scene, fxl_scene_fault *fault)
{
    fxl_status status = fxl_cluster_check(scene, fault);
    if (status == FXL_OK) {
        status = fxl_bsp_check(scene, fault);
    }
    return status == FXL_OK ? check_beams(scene, fault) : status;
}

FXL_COLD fxl_status fxl_scene_check_all(fxl_scene *scene, fxl_scene_fault *fault)
{
    if (scene == NULL) {
        return fxl_scene_check_with(scene, fault, check_more);
    }
    const fxl_placement_code *const before = scene->placement_code;
    if (scene->placements != NULL) {
        scene->placement_code = &fxl_turned_instances;
    }
    fxl_status status = fxl_scene_check_with(scene, fault, check_more);
    if (status == FXL_OK) {
        scene->cluster_code = scene->cluster_count > 0 ? &fxl_clusters : NULL;
    } else {
        scene->placement_code = before;
    }
    return status;
}
