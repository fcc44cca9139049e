/* SPDX-License-Identifier: MIT */
/* Any scene of small tables, for the proofs of its checks, and what each check leaves to those after it. */
#ifndef SCENE_TABLES_H
#define SCENE_TABLES_H

#include "fixel/scene.h"
#include "proof.h"

#ifndef VERTICES
#define VERTICES 4
#endif
#define INDICES   6
#define FACES     2
#define MODELS    2
#define INSTANCES 2

static fxl_point vertices[VERTICES];
static uint16_t indices[INDICES];
static fxl_face faces[FACES];
static uint32_t wholes[FACES];
static fxl_model models[MODELS];
static fxl_instance instances[INSTANCES];
static fxl_scene scene;
static fxl_scene_fault fault;

/* Tables of any length up to the above, with any content. */
static inline void any_scene(void)
{
    ANY_CONTENT(&scene);
    ANY_CONTENT(vertices);
    ANY_CONTENT(indices);
    ANY_CONTENT(faces);
    ANY_CONTENT(wholes);
    ANY_CONTENT(models);
    ANY_CONTENT(instances);
    scene.vertices = vertices;
    scene.indices = indices;
    scene.faces = faces;
    scene.wholes = nondet_bool() ? wholes : NULL;
    scene.models = models;
    scene.instances = instances;
    scene.face_bounds = NULL;
    scene.bsp_nodes = NULL;
    scene.beams = NULL;
    scene.lit = NULL;
    scene.clusters = NULL;
    scene.cluster_code = NULL;
    scene.placements = NULL;
    scene.placement_code = NULL;
    ASSUME(scene.vertex_count <= VERTICES && scene.index_count <= INDICES && scene.face_count <= FACES);
    ASSUME(scene.model_count <= MODELS && scene.instance_count <= INSTANCES);
}

/* Whether the scene has so many indices from a number on. */
static inline bool are_indices(uint32_t first, uint32_t count)
{
    return first <= scene.index_count && count <= scene.index_count - first;
}

/* What check_faces leaves of a face. */
static inline bool is_face(const fxl_face *face)
{
    const uint32_t first = face->indices[1] + 65536u * face->indices[2];
    const uint32_t whole = scene.wholes != NULL ? scene.wholes[face - faces] : 0;
    return face->count >= 3 && face->count <= FXL_SCENE_FACE_VERTICES_MAX &&
           (face->count == 3 || (are_indices(first, face->count) && indices[first] == face->indices[0])) &&
           (whole == 0 || (whole % 32 >= 3 && whole % 32 <= FXL_SCENE_FACE_VERTICES_MAX && are_indices(whole / 32, whole % 32)));
}

/* What check_models leaves of a model, but for its indices. */
static inline bool is_model(const fxl_model *model)
{
    return model->kind <= FXL_MODEL_SORTED && model->radius >= 0 && model->radius <= FXL_RADIUS_MAX && model->vertex_count >= 3 &&
           model->face_count >= 1 && model->first_vertex <= scene.vertex_count &&
           model->vertex_count <= scene.vertex_count - model->first_vertex && model->first_face <= scene.face_count &&
           model->face_count <= scene.face_count - model->first_face;
}

/* Whether an index of a face, and of the face that it is a part of, is below a count. */
static inline bool index_is_below(uint32_t face, uint32_t corner, uint32_t count)
{
    const uint32_t whole = scene.wholes != NULL ? scene.wholes[face] : 0;
    return (corner >= faces[face].count || fxl_face_indices(indices, &faces[face])[corner] < count) &&
           (corner >= whole % 32 || indices[whole / 32 + corner] < count);
}

/* What check_indices leaves: the indices of a model's faces are below its number of vertices. */
static inline bool has_indices(const fxl_model *model)
{
    for (uint32_t i = 0; i < FACES; i++) {
        for (uint32_t corner = 0; corner < INDICES; corner++) {
            if (i >= model->first_face && i - model->first_face < model->face_count && !index_is_below(i, corner, model->vertex_count)) {
                return false;
            }
        }
    }
    return true;
}

static inline bool is_instance(const fxl_instance *instance)
{
    return instance->recolour == 0 && instance->model < scene.model_count &&
           WITHIN(instance->centre.x, FXL_COORDINATE_MAX) && WITHIN(instance->centre.y, FXL_COORDINATE_MAX) &&
           WITHIN(instance->centre.z, FXL_COORDINATE_MAX);
}

/* Each vertex is within twice the range: below 2^30. */
static inline bool is_vertex(const fxl_point *vertex)
{
    return WITHIN(vertex->x, 2 * FXL_COORDINATE_MAX) && WITHIN(vertex->y, 2 * FXL_COORDINATE_MAX) && WITHIN(vertex->z, 2 * FXL_COORDINATE_MAX);
}

/* A scene whose faces, models, indices, instances and vertices were checked. */
static inline void any_checked_scene(void)
{
    any_scene();
    for (uint32_t i = 0; i < FACES; i++) {
        ASSUME(i >= scene.face_count || is_face(&faces[i]));
    }
    for (uint32_t i = 0; i < MODELS; i++) {
        ASSUME(i >= scene.model_count || (is_model(&models[i]) && has_indices(&models[i])));
    }
    for (uint32_t i = 0; i < INSTANCES; i++) {
        ASSUME(i >= scene.instance_count || is_instance(&instances[i]));
    }
    for (uint32_t i = 0; i < VERTICES; i++) {
        ASSUME(i >= scene.vertex_count || is_vertex(&vertices[i]));
    }
    ASSUME(scene.instance_count >= 1 && scene.model_count >= 1);
}

/* For fxl_is_unit and fxl_dot: what their contracts say. */
bool any_unit(const fxl_direction *normal)
{
    const bool unit = nondet_bool();
    ASSUME(!unit || FXL_DIRECTION(normal));
    return unit;
}

fxl_q18_46 any_dot(const fxl_direction *direction, int32_t x, int32_t y, int32_t z)
{
    const fxl_q18_46 dot = nondet_s64();
    ASSERT("a unit normal, below 2^30", FXL_DIRECTION(direction) && WITHIN(x, 1 << 30) && WITHIN(y, 1 << 30) && WITHIN(z, 1 << 30));
    ASSUME(WITHIN(dot, (int64_t)7 << 59));
    return dot;
}

#endif
