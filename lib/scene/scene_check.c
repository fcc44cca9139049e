/* SPDX-License-Identifier: MIT */
/* Checks of a scene's tables. For a scene that passes them no stage reads outside a table or leaves
 * its ranges. The time is linear in the size of the tables and in the sum of the vertex counts of
 * all instances' models, which is limited. */
#include "fixel/scene.h"

#include "../math/arith.h"
#include "../math/memory.h"
#include "../math/plane.h"
#include "placement_code.h"

#define FXL_HERE
#include "face_bounds.h"
#include "scene_check.h"

static bool count_in(uint32_t count, uint32_t low, uint32_t high)
{
    return count >= low && count <= high;
}

/* place field: the check of a table's values */
/* formats 1.4 */
static FXL_COLD fxl_status check_counts(const fxl_scene *scene, fxl_scene_fault *fault)
{
    if (!count_in(scene->vertex_count, 1, FXL_SCENE_VERTICES_MAX)) {
        return fxl_fault_at(fault, "vertex table", 0, FXL_E_COUNT);
    }
    if (scene->index_count > FXL_SCENE_INDICES_MAX) {
        return fxl_fault_at(fault, "index table", 0, FXL_E_COUNT);
    }
    if (scene->face_count > FXL_SCENE_FACES_MAX) {
        return fxl_fault_at(fault, "face table", 0, FXL_E_COUNT);
    }
    if (!count_in(scene->model_count, 1, FXL_SCENE_MODELS_MAX)) {
        return fxl_fault_at(fault, "model table", 0, FXL_E_COUNT);
    }
    if (!count_in(scene->instance_count, 1, FXL_SCENE_INSTANCES_MAX)) {
        return fxl_fault_at(fault, "instance table", 0, FXL_E_COUNT);
    }
    return FXL_OK;
}

static bool holds_indices(const fxl_scene *scene, uint32_t first, uint32_t count)
{
    return first <= scene->index_count && count <= scene->index_count - first;
}

/* Whether the scene has the indices of a face that is no triangle, of which it has the first. */
static bool is_listed(const fxl_scene *scene, const fxl_face *face)
{
    const uint32_t first = fxl_face_first_index(face);
    return holds_indices(scene, first, face->count) && scene->indices[first] == face->indices[0];
}

/* formats 1.5 */
static FXL_COLD fxl_status check_faces(const fxl_scene *scene, fxl_scene_fault *fault)
{
    for (uint32_t i = 0; i < scene->face_count; i++) {
        const fxl_face *face = &scene->faces[i];
        const uint32_t whole = scene->wholes != NULL ? scene->wholes[i] : 0;
        if (!count_in(face->count, 3, FXL_SCENE_FACE_VERTICES_MAX) ||
            (whole != 0 && !count_in(fxl_whole_count(whole), 3, FXL_SCENE_FACE_VERTICES_MAX))) {
            return fxl_fault_at(fault, "face", i, FXL_E_COUNT);
        }
        if (face->count > FXL_FACE_VERTICES_MAX) {
            return fxl_fault_at(fault, "face", i, FXL_E_CAPACITY);
        }
        if ((face->count != 3 && !is_listed(scene, face)) ||
            !holds_indices(scene, fxl_whole_first(whole), fxl_whole_count(whole))) {
            return fxl_fault_at(fault, "face", i, FXL_E_INDEX);
        }
    }
    return FXL_OK;
}

/* Whether a model has the vertices of a face or of a whole face. */
static bool has_vertices(const fxl_model *model, const uint16_t *indices, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        if (indices[i] >= model->vertex_count) {
            return false;
        }
    }
    return true;
}

static FXL_COLD fxl_status check_indices(const fxl_scene *scene, const fxl_model *model,
                                         fxl_scene_fault *fault)
{
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        const fxl_face_outline whole = fxl_whole_face(scene, face);
        if (!has_vertices(model, fxl_face_indices(scene->indices, face), face->count) ||
            !has_vertices(model, whole.indices, whole.count)) {
            return fxl_fault_at(fault, "face", model->first_face + i, FXL_E_INDEX);
        }
    }
    return FXL_OK;
}

/* Models take the vertices and the faces in turn, without gap or overlap. So all models
 * together are as long as the tables, and no longer. */
/* formats 1.4 */
static FXL_COLD fxl_status check_models(const fxl_scene *scene, fxl_scene_fault *fault)
{
    uint32_t vertex = 0, face = 0;
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const fxl_model *model = &scene->models[i];
        if (model->kind > FXL_MODEL_SORTED || model->reserved != 0) {
            return fxl_fault_at(fault, "model", i, FXL_E_RESERVED);
        }
        if (model->radius < 0 || model->radius > FXL_RADIUS_MAX) {
            return fxl_fault_at(fault, "model", i, FXL_E_RANGE);
        }
        const uint32_t least = model->face_count > 0 ? 3 : 1;
        if (!count_in(model->vertex_count, least, FXL_MODEL_VERTICES_MAX) ||
            model->face_count > FXL_MODEL_FACES_MAX ||
            (model->face_count == 0 && model->kind != FXL_MODEL_CONVEX)) {
            return fxl_fault_at(fault, "model", i, FXL_E_COUNT);
        }
        if (model->first_vertex != vertex || model->first_face != face ||
            model->vertex_count > scene->vertex_count - vertex ||
            model->face_count > scene->face_count - face) {
            return fxl_fault_at(fault, "model", i, FXL_E_INDEX);
        }
        vertex += model->vertex_count;
        face += model->face_count;
        fxl_status status = check_indices(scene, model, fault);
        if (status != FXL_OK) {
            return status;
        }
    }
    if (vertex != scene->vertex_count) {
        return fxl_fault_at(fault, "vertex table", 0, FXL_E_COUNT);
    }
    return face == scene->face_count ? FXL_OK : fxl_fault_at(fault, "face table", 0, FXL_E_COUNT);
}

static FXL_COLD fxl_status check_instances(const fxl_scene *scene, fxl_scene_fault *fault)
{
    uint64_t placed_vertices = 0; /* below 2^16 * 2^16 */
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const fxl_instance *instance = &scene->instances[i];
        if (instance->recolour != 0) {
            return fxl_fault_at(fault, "instance", i, FXL_E_RESERVED);
        }
        if (instance->model >= scene->model_count) {
            return fxl_fault_at(fault, "instance", i, FXL_E_INDEX);
        }
        if (!fxl_point_in_range(&instance->centre)) {
            return fxl_fault_at(fault, "instance", i, FXL_E_RANGE);
        }
        placed_vertices += scene->models[instance->model].vertex_count;
        if (placed_vertices > FXL_SCENE_PLACED_MAX) {
            return fxl_fault_at(fault, "instance", i, FXL_E_COUNT);
        }
    }
    return FXL_OK;
}

/* Whether a coordinate of an instance's vertex lies within the world. */
static bool sum_in_range(fxl_q16_16 vertex, fxl_q16_16 centre)
{
    return fxl_within((int64_t)vertex + centre, FXL_COORDINATE_MAX);
}

/* formats 1.4 */
static FXL_COLD fxl_status check_placed_vertices(const fxl_scene *scene, fxl_scene_fault *fault)
{
    const uint32_t end = fxl_first_turned(scene);
    for (uint32_t i = 0; i < end; i++) {
        const fxl_instance *instance = &scene->instances[i];
        const fxl_model *model = &scene->models[instance->model];
        for (uint32_t j = 0; j < model->vertex_count; j++) {
            const fxl_point *vertex = &scene->vertices[model->first_vertex + j];
            if (!sum_in_range(vertex->x, instance->centre.x) ||
                !sum_in_range(vertex->y, instance->centre.y) ||
                !sum_in_range(vertex->z, instance->centre.z)) {
                return fxl_fault_at(fault, "instance", i, FXL_E_RANGE);
            }
        }
    }
    return FXL_OK;
}

/* Turned instances. Their vertices lie in their spheres, because check_radii checks the models. */
/* formats 1.9 */
static FXL_COLD fxl_status check_placements(const fxl_scene *scene, fxl_scene_fault *fault)
{
    uint32_t number = 0;
    if (scene->placements == NULL) {
        return FXL_OK;
    }
    if (scene->placement_code == NULL) {
        return fxl_fault_at(fault, "placement table", 0, FXL_E_ARGUMENT);
    }
    if (scene->first_turned > scene->instance_count) {
        return fxl_fault_at(fault, "placement table", 0, FXL_E_INDEX);
    }
    const fxl_status status = scene->placement_code->check(scene, &number);
    return status == FXL_OK ? FXL_OK : fxl_fault_at(fault, "instance", number, status);
}

/* A model may have no instance, so its vertices are checked too: against twice the range. */
/* formats 1.5 */
static FXL_COLD fxl_status check_vertices(const fxl_scene *scene, fxl_scene_fault *fault)
{
    const int64_t limit = 2 * (int64_t)FXL_COORDINATE_MAX;
    for (uint32_t i = 0; i < scene->vertex_count; i++) {
        const fxl_point *vertex = &scene->vertices[i];
        if (!fxl_within(vertex->x, limit) || !fxl_within(vertex->y, limit) ||
            !fxl_within(vertex->z, limit)) {
            return fxl_fault_at(fault, "vertex", i, FXL_E_RANGE);
        }
    }
    return FXL_OK;
}

/* Vertices lie within twice the range, so each square is below 2^60 and the sum is below
 * 2^62. A radius is below 2^31, so its square is below 2^62. Exact. */
/* formats 1.5 */
static FXL_COLD fxl_status check_radii(const fxl_scene *scene, fxl_scene_fault *fault)
{
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const fxl_model *model = &scene->models[i];
        for (uint32_t j = 0; j < model->vertex_count; j++) {
            uint32_t number = model->first_vertex + j;
            const fxl_point *vertex = &scene->vertices[number];
            int64_t square = (int64_t)vertex->x * vertex->x + (int64_t)vertex->y * vertex->y +
                             (int64_t)vertex->z * vertex->z;
            if (square > (int64_t)model->radius * model->radius) {
                return fxl_fault_at(fault, "vertex", number, FXL_E_RADIUS);
            }
        }
    }
    return FXL_OK;
}

/* Whether the vertices of a face lie on its plane, to within FXL_PLANARITY_MAX. The differences
 * of two vertices of a model are below 2^31, so the sum is below sqrt(3) * 2^61 for a unit
 * normal. */
/* SPEC 3.4 */
static bool is_flat(const fxl_scene *scene, const fxl_model *model, const fxl_face *face)
{
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    const fxl_point *first = &vertices[face->indices[0]];
    for (uint32_t i = 1; i < face->count; i++) {
        const fxl_point *vertex = &vertices[fxl_face_indices(scene->indices, face)[i]];
        int64_t height = (int64_t)face->normal.x * ((int64_t)vertex->x - first->x) +
                         (int64_t)face->normal.y * ((int64_t)vertex->y - first->y) +
                         (int64_t)face->normal.z * ((int64_t)vertex->z - first->z);
        if (!fxl_within(height, (int64_t)FXL_PLANARITY_MAX * FXL_Q2_30_ONE)) {
            return false;
        }
    }
    return true;
}

/* SPEC 3.4 */
static FXL_COLD fxl_status check_normals(const fxl_scene *scene, fxl_scene_fault *fault)
{
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const fxl_model *model = &scene->models[i];
        for (uint32_t j = 0; j < model->face_count; j++) {
            uint32_t number = model->first_face + j;
            if (!fxl_is_unit(&scene->faces[number].normal)) {
                return fxl_fault_at(fault, "face", number, FXL_E_NORMAL);
            }
            if (!is_flat(scene, model, &scene->faces[number])) {
                return fxl_fault_at(fault, "face", number, FXL_E_PLANARITY);
            }
        }
    }
    return FXL_OK;
}

/* formats 1.6 */
static bool face_bounds_match(const fxl_scene *scene, const fxl_model *model, const fxl_face *face,
                              const fxl_face_bounds *key)
{
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    const uint16_t *indices = fxl_face_indices(scene->indices, face);
    fxl_point box = fxl_face_box(vertices, indices, face->count);
    return fxl_face_bounds_height(key) == fxl_face_height(vertices, face) && key->box_x == box.x &&
           key->box_y == box.y && key->box_z == box.z;
}

/* Sorted models take the face bounds in turn. */
/* formats 1.6 */
static FXL_COLD fxl_status check_face_bounds(const fxl_scene *scene, fxl_scene_fault *fault)
{
    uint32_t first = 0;
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const fxl_model *model = &scene->models[i];
        if (scene->face_bounds == NULL || model->kind != FXL_MODEL_SORTED) {
            if (model->first_face_bounds != 0) {
                return fxl_fault_at(fault, "model", i, FXL_E_RESERVED);
            }
            continue;
        }
        if (model->first_face_bounds != first ||
            model->face_count > scene->face_bounds_count - first) {
            return fxl_fault_at(fault, "model", i, FXL_E_INDEX);
        }
        for (uint32_t j = 0; j < model->face_count; j++) {
            const fxl_face *face = &scene->faces[model->first_face + j];
            if (!face_bounds_match(scene, model, face, &scene->face_bounds[first + j])) {
                return fxl_fault_at(fault, "face", model->first_face + j, FXL_E_FACE_BOUNDS);
            }
        }
        first += model->face_count;
    }
    if (first != scene->face_bounds_count) {
        return fxl_fault_at(fault, "face bounds table", 0, FXL_E_COUNT);
    }
    return FXL_OK;
}

/* One entry for each instance, and one for each face of the largest sorted model. */
static uint32_t draw_list_needed(const fxl_scene *scene)
{
    uint32_t faces = 0;
    for (uint32_t i = 0; i < scene->model_count; i++) {
        const fxl_model *model = &scene->models[i];
        if (model->kind == FXL_MODEL_SORTED && model->face_count > faces) {
            faces = model->face_count;
        }
    }
    return scene->instance_count + faces;
}

/* Whether every table begins where its records may; a null one does. */
static bool is_aligned(const fxl_scene *scene)
{
    const uintptr_t words = (uintptr_t)scene->vertices | (uintptr_t)scene->faces |
                            (uintptr_t)scene->models | (uintptr_t)scene->instances |
                            (uintptr_t)scene->face_bounds | (uintptr_t)scene->bsp_nodes |
                            (uintptr_t)scene->beams | (uintptr_t)scene->clusters |
                            (uintptr_t)scene->placements | (uintptr_t)scene->wholes;
    return (words & (FXL_WORD - 1)) == 0 && fxl_is_aligned(scene->indices, sizeof(uint16_t));
}

FXL_COLD fxl_status fxl_scene_check_with(fxl_scene *scene, fxl_scene_fault *fault,
                                         fxl_scene_checker *more)
{
    static fxl_scene_checker *const checks[] = {
        check_counts,   check_faces, check_models,  check_instances,   check_placed_vertices,
        check_vertices, check_radii, check_normals, check_face_bounds, check_placements,
    };
    if (scene == NULL || scene->vertices == NULL ||
        (scene->indices == NULL && scene->index_count != 0) ||
        (scene->faces == NULL && scene->face_count != 0) ||
        scene->models == NULL || scene->instances == NULL) {
        return fxl_fault_at(fault, "scene", 0, FXL_E_ARGUMENT);
    }
    if (!is_aligned(scene)) {
        return fxl_fault_at(fault, "scene", 0, FXL_E_ALIGNMENT);
    }
    for (size_t i = 0; i < sizeof checks / sizeof checks[0]; i++) {
        fxl_status status = checks[i](scene, fault);
        if (status != FXL_OK) {
            return status;
        }
    }
    fxl_status status = more(scene, fault);
    if (status == FXL_OK) {
        scene->draw_list_needed = draw_list_needed(scene);
    }
    return status;
}

/* A scene without a table of clusters has no model with clusters. */
static FXL_COLD fxl_status check_no_clusters(const fxl_scene *scene, fxl_scene_fault *fault)
{
    if (scene->clusters != NULL || scene->cluster_count != 0) {
        return fxl_fault_at(fault, "cluster table", 0, FXL_E_ARGUMENT);
    }
    for (uint32_t i = 0; i < scene->model_count; i++) {
        if (scene->models[i].first_cluster != 0) {
            return fxl_fault_at(fault, "model", i, FXL_E_RESERVED);
        }
    }
    return FXL_OK;
}

static FXL_COLD fxl_status check_bare(const fxl_scene *scene, fxl_scene_fault *fault)
{
    if (scene->bsp_nodes != NULL || scene->bsp_node_count != 0 || scene->bsp_instance != 0) {
        return fxl_fault_at(fault, "BSP node table", 0, FXL_E_ARGUMENT);
    }
    if (scene->beam_count != 0) {
        return fxl_fault_at(fault, "beam table", 0, FXL_E_ARGUMENT);
    }
    return check_no_clusters(scene, fault);
}

FXL_COLD fxl_status fxl_scene_check(fxl_scene *scene, fxl_scene_fault *fault)
{
    return fxl_scene_check_with(scene, fault, check_bare);
}
