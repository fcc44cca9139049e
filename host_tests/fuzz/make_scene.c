/* SPDX-License-Identifier: MIT */
#include "input.h"

#include <string.h>

#include "answers.h"

/* A plane to lay a face into: two axes and what stands on them. */
typedef struct {
    fxl_point origin;
    fxl_camera camera;
} face_plane;

static face_plane any_plane(fuzz_input *in)
{
    face_plane plane;
    fxl_pose pose = fuzz_pose(in);
    DEMAND(fxl_camera_from_pose(&pose, &plane.camera) == FXL_OK);
    plane.origin = pose.position;
    return plane;
}

static fxl_q16_16 along(fxl_q16_16 origin, fxl_q2_30 right, int64_t a, fxl_q2_30 up, int64_t b)
{
    int64_t value = origin + ((right * a + up * b + (1 << 29)) >> 30);
    const int64_t limit = 2 * (int64_t)FXL_COORDINATE_MAX;
    return (fxl_q16_16)(value > limit ? limit : value < -limit ? -limit : value);
}

/* origin + a right + b up, to the nearest unit. */
static fxl_point on_plane(const face_plane *plane, int64_t a, int64_t b)
{
    const fxl_axes *axes = &plane->camera.axes;
    fxl_point point;
    point.x = along(plane->origin.x, axes->right.x, a, axes->up.x, b);
    point.y = along(plane->origin.y, axes->right.y, a, axes->up.y, b);
    point.z = along(plane->origin.z, axes->right.z, a, axes->up.z, b);
    return point;
}

/* One face of new vertices, all of them in a plane or all but for a mistake. */
static void add_face(made_scene *made, fxl_model *model, fuzz_input *in)
{
    fxl_scene *scene = &made->scene;
    fxl_face *face = &made->faces[scene->face_count];
    face_plane plane = any_plane(in);
    uint32_t kind = fuzz_below(in, 64);
    unsigned scale = kind % 16;
    fxl_q2_30 turned = kind < 32 ? 1 : -1;
    face->normal.x = plane.camera.axes.forward.x * turned;
    face->normal.y = plane.camera.axes.forward.y * turned;
    face->normal.z = plane.camera.axes.forward.z * turned;
    face->count = (uint8_t)(3 + fuzz_below(in, FXL_FACE_VERTICES_MAX - 2));
    face->material = (uint8_t)fuzz_bits(in, 1);
    for (uint32_t i = 0; i < face->count; i++) {
        int64_t a = (int64_t)(int16_t)fuzz_bits(in, 2) * (1 << scale);
        int64_t b = (int64_t)(int16_t)fuzz_bits(in, 2) * (1 << scale);
        if (kind % 32 >= 28) {
            b = i % 2 == 0 ? -(int64_t)32768 * (1 << scale) : b; /* a comb */
        }
        made->vertices[scene->vertex_count + i] = on_plane(&plane, a, b);
        made->corners[scene->index_count + i] = (uint16_t)(model->vertex_count + i);
    }
    fxl_face_take_indices(face, made->corners, scene->index_count);
    scene->face_count += 1;
    scene->index_count += face->count;
    scene->vertex_count += face->count;
    model->face_count += 1;
    model->vertex_count += face->count;
}

/* The least radius whose square is not below this. */
static fxl_q16_16 least_radius(uint64_t most)
{
    uint64_t radius = 0;
    for (uint64_t step = (uint64_t)1 << 31; step > 0; step /= 2) {
        if ((radius + step) * (radius + step) <= most) {
            radius += step;
        }
    }
    radius += radius * radius < most;
    return (fxl_q16_16)(radius < INT32_MAX ? radius : INT32_MAX);
}

/* The least radius that holds a model. */
static void set_radius(const made_scene *made, fxl_model *model)
{
    uint64_t most = 0;
    for (uint32_t i = 0; i < model->vertex_count; i++) {
        const fxl_point *v = &made->vertices[model->first_vertex + i];
        uint64_t square = (uint64_t)((int64_t)v->x * v->x) + (uint64_t)((int64_t)v->y * v->y) +
                          (uint64_t)((int64_t)v->z * v->z);
        most = square > most ? square : most;
    }
    model->radius = least_radius(most);
}

/* The keys of a model's faces, from the vertices. */
static void add_keys(made_scene *made, fxl_model *model)
{
    model->first_face_bounds = made->scene.face_bounds_count;
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &made->faces[model->first_face + i];
        int32_t low[3] = {INT32_MAX, INT32_MAX, INT32_MAX};
        int32_t high[3] = {INT32_MIN, INT32_MIN, INT32_MIN};
        const fxl_point *first = NULL;
        for (uint32_t k = 0; k < face->count; k++) {
            uint32_t number = fxl_face_indices(made->corners, face)[k];
            const fxl_point *v = &made->vertices[model->first_vertex + number];
            const int32_t at[3] = {v->x, v->y, v->z};
            first = k == 0 ? v : first;
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = at[axis] < low[axis] ? at[axis] : low[axis];
                high[axis] = at[axis] > high[axis] ? at[axis] : high[axis];
            }
        }
        uint64_t height = (uint64_t)((int64_t)face->normal.x * first->x) +
                          (uint64_t)((int64_t)face->normal.y * first->y) +
                          (uint64_t)((int64_t)face->normal.z * first->z);
        made->keys[made->scene.face_bounds_count++] =
            (fxl_face_bounds){(uint32_t)height, (uint32_t)(height >> 32), low[0] + high[0],
                              low[1] + high[1], low[2] + high[2]};
    }
}

static void add_model(made_scene *made, uint32_t faces, fuzz_input *in)
{
    fxl_model *model = &made->models[made->scene.model_count++];
    model->first_vertex = made->scene.vertex_count;
    model->first_face = made->scene.face_count;
    model->kind = fuzz_below(in, 2) ? FXL_MODEL_SORTED : FXL_MODEL_CONVEX;
    for (uint32_t i = 0; i < faces; i++) {
        add_face(made, model, in);
    }
    set_radius(made, model);
    if (model->kind == FXL_MODEL_SORTED) {
        add_keys(made, model);
    }
}

static void add_instance(made_scene *made, fuzz_input *in)
{
    fxl_instance *instance = &made->instances[made->scene.instance_count++];
    uint32_t kind = fuzz_below(in, 16);
    if (kind > 8) {
        instance->centre = fuzz_point(in, FXL_COORDINATE_MAX);
    }
    instance->model = (uint16_t)(kind % made->scene.model_count);
    instance->layer = (uint8_t)fuzz_below(in, 3);
}

/* A node with the plane of a face, or any plane where it has none. */
static fxl_bsp_node any_node(const made_scene *made, const fxl_model *model, uint32_t first_face,
                             bool has_face, fuzz_input *in)
{
    fxl_bsp_node node = {.front = FXL_BSP_NONE,
                         .back = FXL_BSP_NONE,
                         .parent = FXL_BSP_NONE,
                         .first_face = (uint16_t)first_face,
                         .face_count = has_face,
                         .radius = model->radius};
    if (has_face) {
        const fxl_face *face = &made->faces[model->first_face + first_face];
        const fxl_point *v =
            &made->vertices[model->first_vertex + face->indices[0]];
        uint64_t height = (uint64_t)((int64_t)face->normal.x * v->x) +
                          (uint64_t)((int64_t)face->normal.y * v->y) +
                          (uint64_t)((int64_t)face->normal.z * v->z);
        node.normal = face->normal;
        node.distance_low = (uint32_t)height;
        node.distance_high = (uint32_t)(height >> 32);
    } else {
        node.normal = any_plane(in).camera.axes.forward;
        const int32_t distance = (int32_t)fuzz_bits(in, 4);
        node.distance_high = (uint32_t)(distance >> (2 + fuzz_below(in, 16)));
    }
    return node;
}

/* Hangs a node behind the one that was made last, or above it: so that nodes are listed as one
 * comes upon them. */
static void hang(made_scene *made, uint32_t number, fuzz_input *in)
{
    fxl_bsp_node *nodes = made->nodes;
    uint32_t above = number - 1, up = fuzz_below(in, 4);
    if (fuzz_below(in, 2)) {
        nodes[above].front = (uint16_t)number;
        nodes[number].parent = (uint16_t)above;
        return;
    }
    for (uint32_t at = above; up > 0 && at != FXL_BSP_NONE; at = nodes[at].parent, up--) {
        above = nodes[at].back == FXL_BSP_NONE ? at : above;
    }
    nodes[above].back = (uint16_t)number;
    nodes[number].parent = (uint16_t)above;
}

/* A tree over the faces of an object; the others have other models, and convex ones on its
 * layer. Where that cannot be there is no tree. */
static void add_bsp(made_scene *made, fuzz_input *in)
{
    fxl_scene *scene = &made->scene;
    uint32_t owner = fuzz_below(in, scene->instance_count);
    const fxl_model *model = &made->models[made->instances[owner].model];
    if (model->kind != FXL_MODEL_SORTED) {
        return;
    }
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        fxl_instance *instance = &made->instances[i];
        if (i != owner && instance->model == made->instances[owner].model) {
            instance->model = (uint16_t)((instance->model + 1u) % scene->model_count);
            if (instance->model == made->instances[owner].model) {
                return;
            }
        }
        if (i != owner && made->models[instance->model].kind == FXL_MODEL_SORTED &&
            instance->layer == made->instances[owner].layer) {
            instance->layer += 3;
        }
    }
    uint32_t face = 0;
    while (face < model->face_count && scene->bsp_node_count < MADE_NODES) {
        bool has_face = MADE_NODES - scene->bsp_node_count <= model->face_count - face ||
                        fuzz_below(in, 4) != 0;
        made->nodes[scene->bsp_node_count] = any_node(made, model, face, has_face, in);
        if (scene->bsp_node_count > 0) {
            hang(made, scene->bsp_node_count, in);
        }
        face += has_face;
        scene->bsp_node_count += 1;
    }
    scene->bsp_instance = owner;
}

/* The sphere about a face's vertices that has the first one for its centre. */
static void set_sphere(const made_scene *made, const fxl_model *model, const fxl_face *face,
                       fxl_cluster *cluster)
{
    const fxl_point *vertices = &made->vertices[model->first_vertex];
    cluster->centre = vertices[face->indices[0]];
    uint64_t most = 0;
    for (uint32_t i = 0; i < face->count; i++) {
        const fxl_point *v = &vertices[fxl_face_indices(made->corners, face)[i]];
        const int64_t x = (int64_t)v->x - cluster->centre.x, y = (int64_t)v->y - cluster->centre.y,
                      z = (int64_t)v->z - cluster->centre.z;
        const uint64_t square = (uint64_t)(x * x) + (uint64_t)(y * y) + (uint64_t)(z * z);
        most = square > most ? square : most;
    }
    cluster->radius = least_radius(most);
}

/* A cluster for each face of a model, with a cone along its normal or with none. */
static void add_clusters_of(made_scene *made, fxl_model *model, fuzz_input *in)
{
    model->first_cluster = (uint16_t)(made->scene.cluster_count + 1);
    for (uint32_t i = 0; i < model->face_count; i++) {
        fxl_cluster *cluster = &made->clusters[made->scene.cluster_count++];
        const fxl_face *face = &made->faces[model->first_face + i];
        set_sphere(made, model, face, cluster);
        cluster->face_count = 1;
        if (fuzz_below(in, 4) != 0) {
            cluster->axis = face->normal;
            cluster->apex = cluster->centre;
            cluster->cutoff = (uint32_t)fuzz_bits(in, 2);
            cluster->cutoff = 64 + (cluster->cutoff << fuzz_below(in, 17));
        }
    }
}

/* Clusters for the sorted models, but not for that of the tree. */
static void add_clusters(made_scene *made, fuzz_input *in)
{
    const fxl_scene *scene = &made->scene;
    const uint32_t of_tree =
        scene->bsp_node_count > 0 ? made->instances[scene->bsp_instance].model : MADE_MODELS;
    for (uint32_t i = 0; i < scene->model_count; i++) {
        if (i != of_tree && made->models[i].kind == FXL_MODEL_SORTED) {
            add_clusters_of(made, &made->models[i], in);
        }
    }
}

/* A count that the tables do not have: lower, or above every limit. */
static uint32_t spoilt_count(uint32_t count, fuzz_input *in)
{
    uint32_t value = fuzz_below(in, count + 1);
    return value == count ? UINT32_MAX - (uint32_t)fuzz_bits(in, 3) : value;
}

/* Lets one number be what it should not. */
static void spoil(made_scene *made, fuzz_input *in)
{
    fxl_scene *scene = &made->scene;
    fxl_model *model = &made->models[fuzz_below(in, scene->model_count)];
    fxl_instance *instance = &made->instances[fuzz_below(in, scene->instance_count)];
    fxl_face *face = &made->faces[fuzz_below(in, scene->face_count)];
    fxl_point *vertex = &made->vertices[fuzz_below(in, scene->vertex_count)];
    uint16_t *corner = &made->corners[fuzz_below(in, scene->index_count)];
    fxl_bsp_node *node = &made->nodes[fuzz_below(in, MADE_NODES)];
    fxl_cluster *cluster = &made->clusters[fuzz_below(in, MADE_FACES)];
    uint32_t *const counts[] = {&scene->vertex_count,   &scene->index_count,
                                &scene->face_count,     &scene->model_count,
                                &scene->instance_count, &scene->face_bounds_count,
                                &scene->bsp_node_count, &scene->bsp_instance};
    uint32_t *const words[] = {&model->first_vertex, &model->vertex_count, &model->first_face,
                               &model->face_count, &model->first_face_bounds};
    int32_t *const numbers[] = {&face->normal.x,     &face->normal.y,     &face->normal.z,
                                &instance->centre.x, &instance->centre.y, &instance->centre.z,
                                &vertex->x,          &vertex->y,          &vertex->z,
                                &model->radius};
    uint8_t *const bytes[] = {&face->count, &model->kind, &model->reserved, &instance->recolour};
    uint16_t *const halves[] = {&face->indices[0], &instance->model, corner, &model->first_cluster,
                                &cluster->face_count};
    uint16_t *const links[] = {&node->front,      &node->back,       &node->parent,
                               &node->first_face, &node->face_count, &node->reserved};
    int32_t *const planes[] = {&node->normal.x, &node->normal.y, &node->normal.z, &node->centre.x,
                               &node->centre.y, &node->centre.z, &node->radius};
    int32_t *const shapes[] = {&cluster->centre.x, &cluster->radius, &cluster->axis.y,
                               &cluster->apex.z, (int32_t *)(void *)&cluster->cutoff};
    uint32_t which = fuzz_below(in, 58);
    if (which == 57) {
        scene->cluster_count = spoilt_count(scene->cluster_count, in);
    } else if (which >= 52) {
        *shapes[which - 52] = fuzz_any(in);
    } else if (which >= 32) {
        uint32_t of_bsp = which - 32;
        if (of_bsp < 2) {
            *counts[6 + of_bsp] = spoilt_count(*counts[6 + of_bsp], in);
        } else if (of_bsp < 8) {
            /* A small number more often than not. */
            *links[of_bsp - 2] =
                (uint16_t)(fuzz_below(in, 4) ? fuzz_below(in, MADE_NODES) : fuzz_bits(in, 2));
        } else if (of_bsp < 15) {
            *planes[of_bsp - 8] = fuzz_any(in);
        } else {
            node->distance_high = (uint32_t)fuzz_any(in);
        }
    } else if (which < 6) {
        *counts[which] = spoilt_count(*counts[which], in);
    } else if (which == 6) {
        const uint32_t first = (uint32_t)fuzz_any(in);
        face->indices[1] = (uint16_t)first;
        face->indices[2] = (uint16_t)(first >> 16);
    } else if (which < 12) {
        *words[which - 7] = (uint32_t)fuzz_any(in);
    } else if (which < 22) {
        *numbers[which - 12] = fuzz_any(in);
    } else if (which < 26) {
        *bytes[which - 22] = (uint8_t)fuzz_bits(in, 1);
    } else if (which < 31) {
        *halves[which - 26] = (uint16_t)fuzz_bits(in, 2);
    } else {
        fxl_face_bounds *const key = &made->keys[fuzz_below(in, MADE_FACES)];
        key->height_high = (uint32_t)fuzz_any(in);
    }
}

/* Copies of exactly the tables' size: the sanitizer sees what lies behind. */
static void *copy(const void *table, size_t size)
{
    void *copied = malloc(size);
    DEMAND(copied != NULL);
    memcpy(copied, table, size);
    return copied;
}

/* What each table holds, before its stated count is spoilt. */
static void copy_tables(made_scene *made, fxl_scene sizes)
{
    fxl_scene *scene = &made->scene;
    scene->vertices = copy(made->vertices, sizes.vertex_count * sizeof *made->vertices);
    scene->indices = copy(made->corners, sizes.index_count * sizeof *made->corners);
    scene->faces = copy(made->faces, sizes.face_count * sizeof *made->faces);
    scene->models = copy(made->models, sizes.model_count * sizeof *made->models);
    scene->instances = copy(made->instances, sizes.instance_count * sizeof *made->instances);
    scene->face_bounds = copy(made->keys, sizes.face_bounds_count * sizeof *made->keys);
    scene->bsp_nodes = sizes.bsp_node_count > 0
                           ? copy(made->nodes, sizes.bsp_node_count * sizeof *made->nodes)
                           : NULL;
    scene->clusters = sizes.cluster_count > 0
                          ? copy(made->clusters, sizes.cluster_count * sizeof *made->clusters)
                          : NULL;
}

made_scene *make_scene(fuzz_input *in)
{
    made_scene *made = calloc(1, sizeof *made);
    DEMAND(made != NULL);
    uint32_t models = 1 + fuzz_below(in, MADE_MODELS);
    uint32_t instances = 1 + fuzz_below(in, MADE_INSTANCES);
    uint32_t spoiling = fuzz_below(in, 8);
    for (uint32_t i = 0; i < models; i++) {
        add_model(made, 1 + fuzz_below(in, MADE_FACES / MADE_MODELS), in);
    }
    for (uint32_t i = 0; i < instances; i++) {
        add_instance(made, in);
    }
    if (fuzz_below(in, 2)) {
        add_bsp(made, in);
    }
    if (fuzz_below(in, 3) == 0) {
        add_clusters(made, in);
    }
    fxl_scene sizes = made->scene;
    if (spoiling == 7) {
        spoil(made, in);
    }
    copy_tables(made, sizes);
    return made;
}

/* About one of the axes. Sine and cosine are off by 0.51 units, so the rows are in range. */
static fxl_orientation about_axis(fuzz_input *in)
{
    static const int entries[3][4] = {{4, 5, 7, 8}, {0, 2, 6, 8}, {0, 1, 3, 4}};
    const uint32_t axis = fuzz_below(in, 3);
    const fxl_angle angle = (fxl_angle)fuzz_bits(in, 2) << 16;
    int32_t rows[9] = {FXL_Q2_30_ONE, 0, 0, 0, FXL_Q2_30_ONE, 0, 0, 0, FXL_Q2_30_ONE};
    rows[entries[axis][0]] = rows[entries[axis][3]] = fxl_cos(angle);
    rows[entries[axis][1]] = fxl_sin(angle);
    rows[entries[axis][2]] = -fxl_sin(angle);
    return (fxl_orientation){
        {rows[0], rows[1], rows[2]}, {rows[3], rows[4], rows[5]}, {rows[6], rows[7], rows[8]}};
}

void add_placements(made_scene *made, fuzz_input *in)
{
    fxl_scene *scene = &made->scene;
    const uint32_t count = scene->instance_count <= MADE_INSTANCES ? scene->instance_count : 0;
    if (count == 0) {
        return;
    }
    const uint32_t first = fuzz_below(in, count);
    fxl_placement placements[MADE_INSTANCES] = {0};
    for (uint32_t i = first; i < count; i++) {
        const fxl_instance *instance = &made->instances[i];
        fxl_placement *placement = &placements[i - first];
        placement->orientation = about_axis(in);
        placement->scale = FXL_Q16_16_ONE;
        if (fuzz_below(in, 4) != 0) {
            const uint32_t small = (uint32_t)fuzz_bits(in, 2) + 256u;
            placement->scale = (int32_t)(small << fuzz_below(in, 8));
        }
        while (placement->scale > FXL_SCALE_MIN && instance->model < MADE_MODELS &&
               fxl_placement_check(placement, &instance->centre,
                                   made->models[instance->model].radius) == FXL_E_RANGE) {
            placement->scale /= 2;
        }
    }
    if (fuzz_below(in, 16) == 7) {
        int32_t *const number = &placements[0].orientation.x.x + fuzz_below(in, 10);
        *number = fuzz_any(in);
    }
    scene->placements = copy(placements, (count - first) * sizeof *placements);
    scene->first_turned = first;
    scene->placement_code = &fxl_turned_instances;
}

void free_scene(made_scene *made)
{
    free((void *)(uintptr_t)made->scene.placements);
    free((void *)(uintptr_t)made->scene.vertices);
    free((void *)(uintptr_t)made->scene.indices);
    free((void *)(uintptr_t)made->scene.faces);
    free((void *)(uintptr_t)made->scene.models);
    free((void *)(uintptr_t)made->scene.instances);
    free((void *)(uintptr_t)made->scene.face_bounds);
    free((void *)(uintptr_t)made->scene.bsp_nodes);
    free((void *)(uintptr_t)made->scene.clusters);
    free(made);
}
