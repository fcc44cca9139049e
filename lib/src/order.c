/* SPDX-License-Identifier: MIT */
#include "fixel/order.h"

#include "arith.h"
#include "face.h"
#include "fixel/cull.h"

static uint64_t square(int64_t value)
{
    return (uint64_t)(value * value);
}

uint64_t fxl_distance_squared(const fxl_point *eye, const fxl_point *point)
{
    FXL_ASSERT(fxl_point_in_range(eye) && fxl_point_in_range(point));
    return square((int64_t)point->x - eye->x) + square((int64_t)point->y - eye->y) +
           square((int64_t)point->z - eye->z);
}

static void widen(fxl_q16_16 value, fxl_q16_16 *low, fxl_q16_16 *high)
{
    if (value < *low) {
        *low = value;
    }
    if (value > *high) {
        *high = value;
    }
}

uint64_t fxl_face_distance_squared(const fxl_point *eye, const fxl_scene *scene,
                                   const fxl_object *object, const fxl_face *face)
{
    fxl_point low = fxl_face_vertex(scene, object, face, 0);
    fxl_point high = low;
    for (uint32_t i = 1; i < face->count; i++) {
        fxl_point point = fxl_face_vertex(scene, object, face, i);
        widen(point.x, &low.x, &high.x);
        widen(point.y, &low.y, &high.y);
        widen(point.z, &low.z, &high.z);
    }
    return square((int64_t)low.x + high.x - 2 * (int64_t)eye->x) +
           square((int64_t)low.y + high.y - 2 * (int64_t)eye->y) +
           square((int64_t)low.z + high.z - 2 * (int64_t)eye->z);
}

/* Whether a is drawn before b. */
static bool before(const fxl_order_entry *a, const fxl_order_entry *b)
{
    if (a->layer != b->layer) {
        return a->layer < b->layer;
    }
    if (a->distance_high != b->distance_high) {
        return a->distance_high > b->distance_high;
    }
    if (a->distance_low != b->distance_low) {
        return a->distance_low > b->distance_low;
    }
    return a->index < b->index;
}

/* Lets entries[root] sink below those that are drawn after it. */
static void sift_down(fxl_order_entry *entries, uint32_t root, uint32_t count)
{
    fxl_order_entry sinking = entries[root];
    uint32_t child;
    while ((child = 2 * root + 1) < count) {
        if (child + 1 < count && before(&entries[child], &entries[child + 1])) {
            child += 1;
        }
        if (!before(&sinking, &entries[child])) {
            break;
        }
        entries[root] = entries[child];
        root = child;
    }
    entries[root] = sinking;
}

/* Heapsort: in place, without recursion, and no order of input makes it slow. */
void fxl_order_sort(fxl_order_entry *entries, uint32_t count)
{
    for (uint32_t root = count / 2; root-- > 0;) {
        sift_down(entries, root, count);
    }
    for (uint32_t end = count; end-- > 1;) {
        fxl_order_entry last = entries[0];
        entries[0] = entries[end];
        entries[end] = last;
        sift_down(entries, 0, end);
    }
}

uint32_t fxl_order_objects(const fxl_scene *scene, const fxl_camera *camera,
                           const fxl_view_frustum *frustum, fxl_order_entry *entries,
                           uint32_t *left_out)
{
    uint32_t count = 0;
    *left_out = 0;
    for (uint32_t i = 0; i < scene->object_count; i++) {
        const fxl_object *object = &scene->objects[i];
        const fxl_model *model = &scene->models[object->model];
        uint32_t planes = fxl_sphere_planes(camera, frustum, &object->centre, model->radius);
        if (planes == FXL_SPHERE_OUTSIDE) {
            *left_out += model->face_count; /* below 2^16 * 2^16 */
            continue;
        }
        fxl_order_entry *entry = &entries[count++];
        *entry = fxl_order_entry_of(fxl_distance_squared(&camera->position, &object->centre),
                                    (uint16_t)i, object->layer);
        entry->planes = (uint8_t)planes;
    }
    fxl_order_sort(entries, count);
    return count;
}

uint32_t fxl_order_faces(const fxl_scene *scene, const fxl_object *object, const fxl_point *eye,
                         fxl_order_entry *entries)
{
    const fxl_model *model = &scene->models[object->model];
    uint32_t count = 0;
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        if (fxl_face_is_front(scene, object, face, eye)) {
            entries[count++] = fxl_order_entry_of(
                fxl_face_distance_squared(eye, scene, object, face), (uint16_t)i, 0);
        }
    }
    fxl_order_sort(entries, count);
    return count;
}
