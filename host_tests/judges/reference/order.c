/* SPDX-License-Identifier: MIT */
#include "reference/order.h"

#include <stdlib.h>

#include "reference/cull.h"
#include "reference/placement.h"

static ref_square square(int64_t value)
{
    ref_square size = (ref_square)llabs(value);
    return size * size;
}

static ref_square distance_squared(const ref_lattice_point *eye, const ref_lattice_point *point)
{
    return square((int64_t)point->x - eye->x) + square((int64_t)point->y - eye->y) +
           square((int64_t)point->z - eye->z);
}

static void widen(int64_t *low, int64_t *high, int32_t value)
{
    *low = value < *low ? value : *low;
    *high = value > *high ? value : *high;
}

/* A key that grows with the depth: the product of a direction and a point, moved above 0. */
static ref_square key_along(const int32_t ahead[3], int64_t x, int64_t y, int64_t z)
{
    return (ref_square)(((ref_exact)1 << 80) + (ref_exact)ahead[0] * x + (ref_exact)ahead[1] * y +
                        (ref_exact)ahead[2] * z);
}

/* The key of an instance in the order of drawing. */
static ref_square instance_key(const ref_lattice_point *eye, const ref_camera *camera,
                               const ref_lattice_point *centre)
{
    return camera->has_no_eye
               ? key_along(camera->forward_30, (int64_t)centre->x - eye->x,
                           (int64_t)centre->y - eye->y, (int64_t)centre->z - eye->z)
               : distance_squared(eye, centre);
}

/* The key of a face of a sorted model. */
static ref_square face_key(const ref_lattice_point *eye, const ref_camera *camera,
                           const ref_scene *scene, const ref_instance *instance,
                           const ref_face *face)
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    int64_t low[3] = {INT32_MAX, INT32_MAX, INT32_MAX};
    int64_t high[3] = {INT32_MIN, INT32_MIN, INT32_MIN};
    for (int i = 0; i < face->count; i++) {
        ref_lattice_point corner = placement ? ref_face_corner(scene, instance, face, i)
                                             : ref_face_vertex(scene, instance, face, i);
        widen(&low[0], &high[0], corner.x);
        widen(&low[1], &high[1], corner.y);
        widen(&low[2], &high[2], corner.z);
    }
    if (camera->has_no_eye) {
        int32_t ahead[3];
        ref_direction_in_model(scene, instance, camera->forward_30, ahead);
        return key_along(ahead, low[0] + high[0], low[1] + high[1], low[2] + high[2]);
    }
    if (placement) {
        ref_lattice_point at;
        const int shift = ref_placement_eye(placement, &instance->centre, eye,
                                            scene->models[instance->model].radius, &at);
        return square(((low[0] + high[0]) >> shift) - 2 * (int64_t)at.x) +
               square(((low[1] + high[1]) >> shift) - 2 * (int64_t)at.y) +
               square(((low[2] + high[2]) >> shift) - 2 * (int64_t)at.z);
    }
    return square(low[0] + high[0] - 2 * (int64_t)eye->x) +
           square(low[1] + high[1] - 2 * (int64_t)eye->y) +
           square(low[2] + high[2] - 2 * (int64_t)eye->z);
}

static int drawn_before(const void *a, const void *b)
{
    const ref_order_entry *first = a, *second = b;
    if (first->layer != second->layer) {
        return first->layer < second->layer ? -1 : 1;
    }
    if (first->distance != second->distance) {
        return first->distance > second->distance ? -1 : 1;
    }
    return (first->index > second->index) - (first->index < second->index);
}

/* Sorts entries: ascending layer, descending distance, ascending index. */
static void sort_entries(ref_order_entry *entries, uint32_t count)
{
    qsort(entries, count, sizeof *entries, drawn_before);
}

uint32_t ref_order_instances(const ref_scene *scene, const ref_lattice_point *eye,
                             const ref_camera *camera, const ref_view_frustum *frustum,
                             ref_order_entry *entries)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const ref_instance *instance = &scene->instances[i];
        ref_point centre = ref_point_from_lattice(&instance->centre);
        ref_sphere_distances distances = ref_sphere_measure(camera, frustum, &centre);
        double radius = ref_instance_radius(scene, instance) / REF_ONE;
        if (ref_sphere_planes(&distances, radius) != REF_SPHERE_OUTSIDE) {
            entries[count++] =
                (ref_order_entry){instance_key(eye, camera, &instance->centre), i, instance->layer};
        }
    }
    sort_entries(entries, count);
    return count;
}

#define LARGEST (REF_COORDINATE_MAX * 65536)

/* Tells whether the sphere test rejects a cluster of an instance. */
static bool cluster_is_outside(const ref_scene *scene, const ref_cluster *cluster,
                               const ref_instance *instance, const ref_camera *camera,
                               const ref_view_frustum *frustum)
{
    const ref_placement *placement = ref_placement_of(scene, instance);
    ref_lattice_point placed = {instance->centre.x + cluster->centre.x,
                                instance->centre.y + cluster->centre.y,
                                instance->centre.z + cluster->centre.z};
    double radius = cluster->radius;
    if (placement) {
        placed = ref_placement_rounded(placement, &instance->centre, &cluster->centre);
        radius = (double)ref_placement_radius(placement, cluster->radius);
        if (radius > LARGEST + REF_PLACEMENT_SLACK || labs(placed.x) > LARGEST ||
            labs(placed.y) > LARGEST || labs(placed.z) > LARGEST) {
            return false;
        }
    }
    ref_point centre = ref_point_from_lattice(&placed);
    ref_sphere_distances distances = ref_sphere_measure(camera, frustum, &centre);
    return ref_sphere_planes(&distances, radius / REF_ONE) == REF_SPHERE_OUTSIDE;
}

uint32_t ref_order_faces(const ref_scene *scene, const ref_instance *instance,
                         const ref_lattice_point *eye, const ref_camera *camera,
                         const ref_view_frustum *frustum, bool by_number, ref_order_entry *entries,
                         uint32_t *left_out)
{
    const ref_model *model = &scene->models[instance->model];
    uint32_t count = 0, cluster = model->first_cluster, left = 0;
    bool outside = false;
    *left_out = 0;
    for (uint32_t i = 0; i < model->face_count; i++) {
        const ref_face *face = &scene->faces[model->first_face + i];
        if (cluster > 0 && left == 0) {
            const ref_cluster *next = &scene->clusters[cluster++ - 1];
            outside = cluster_is_outside(scene, next, instance, camera, frustum);
            left = next->face_count;
        }
        left -= left > 0;
        if (outside) {
            *left_out += 1;
        } else if (ref_face_shows_front(scene, instance, face, eye, camera)) {
            entries[count++] =
                (ref_order_entry){face_key(eye, camera, scene, instance, face), i, 0};
        }
    }
    if (!by_number) {
        sort_entries(entries, count);
    }
    return count;
}

bool ref_display_list_append(ref_display_list *list, const ref_drawn *drawn)
{
    ref_drawn *drawn_list =
        ref_grown(list->drawn, list->count, &list->capacity, 256, sizeof *drawn_list);
    if (!drawn_list) {
        return false;
    }
    list->drawn = drawn_list;
    list->drawn[list->count++] = *drawn;
    return true;
}

/* Tells whether two ranges of rows have a row in common. */
static bool share_a_row(ref_rows these, ref_rows those)
{
    int first = these.first > those.first ? these.first : those.first;
    int end = these.end < those.end ? these.end : those.end;
    return first < end;
}

const ref_drawn *ref_display_list_next(const ref_display_list *list, ref_rows rows, size_t *place)
{
    while (*place < list->count) {
        const ref_drawn *drawn = &list->drawn[(*place)++];
        if (share_a_row(drawn->rows, rows)) {
            return drawn;
        }
    }
    return NULL;
}

void ref_display_list_close(ref_display_list *list)
{
    free(list->drawn);
    *list = (ref_display_list){0};
}
