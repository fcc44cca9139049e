/* SPDX-License-Identifier: MIT */
/* The numbers of lib/src/order.c, which says why they fit; one way to find front
 * faces, by their vertices, and one to sort. */
#include "fixel/order.h"

#include "arith.h"
#include "face_key.h"

static uint64_t square_sum(int32_t x, int32_t y, int32_t z)
{
    return (uint64_t)fxl_multiply_s32(x, x) + (uint64_t)fxl_multiply_s32(y, y) +
           (uint64_t)fxl_multiply_s32(z, z);
}

uint64_t fxl_distance_squared(const fxl_point *eye, const fxl_point *point)
{
    FXL_ASSERT(fxl_point_in_range(eye) && fxl_point_in_range(point));
    return square_sum(point->x - eye->x, point->y - eye->y, point->z - eye->z);
}

/* Minimum + maximum less twice the eye, of one coordinate of a face's corners: below
 * 2^31; what wraps on the way cancels. */
static int32_t box_offset(const int32_t *coordinate, const uint16_t *corners, uint32_t count,
                          int32_t eye)
{
    int32_t low = INT32_MAX, high = INT32_MIN;
    for (; count != 0; count--) {
        fxl_widen(coordinate[*corners++ * (sizeof(fxl_point) / sizeof(int32_t))], &low, &high);
    }
    return (int32_t)((uint32_t)low + (uint32_t)high - 2 * (uint32_t)eye);
}

static uint64_t box_distance(const fxl_point *vertices, const uint16_t *corners, uint32_t count,
                             const fxl_point *eye)
{
    return square_sum(box_offset(&vertices->x, corners, count, eye->x),
                      box_offset(&vertices->y, corners, count, eye->y),
                      box_offset(&vertices->z, corners, count, eye->z));
}

static fxl_point relative_to(const fxl_point *eye, const fxl_point *centre)
{
    fxl_point relative = {eye->x - centre->x, eye->y - centre->y, eye->z - centre->z};
    return relative;
}

uint64_t fxl_face_distance_squared(const fxl_point *eye, const fxl_scene *scene,
                                   const fxl_object *object, const fxl_face *face)
{
    fxl_point relative = relative_to(eye, &object->centre);
    return box_distance(&scene->vertices[scene->models[object->model].first_vertex],
                        &scene->corners[face->first_corner], face->count, &relative);
}

/* Whether a is drawn before b. */
static bool before(const fxl_order_entry *a, const fxl_order_entry *b)
{
    uint64_t from_a = fxl_order_distance(a), from_b = fxl_order_distance(b);
    if (a->layer != b->layer) {
        return a->layer < b->layer;
    }
    return from_a != from_b ? from_a > from_b : a->index < b->index;
}

/* Shellsort with the gaps of Hibbard, 2^k - 1: of order count^(3/2) at most. */
void fxl_order_sort(fxl_order_entry *entries, uint32_t count)
{
    for (uint32_t gap = 32767; gap != 0; gap >>= 1) {
        for (uint32_t i = gap; i < count; i++) {
            const fxl_order_entry entry = entries[i];
            uint32_t place = i;
            for (; place >= gap && before(&entry, &entries[place - gap]); place -= gap) {
                entries[place] = entries[place - gap];
            }
            entries[place] = entry;
        }
    }
}

/* Faces, which are of one layer. */
static void sort_faces(fxl_order_entry *entries, uint32_t count)
{
    fxl_order_sort(entries, count);
    for (uint32_t i = 0; i < count; i++) {
        entries[i].face = entries[i].index;
    }
}

void fxl_order_sort_faces(fxl_order_entry *entries, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        entries[i].next = 0;
    }
    sort_faces(entries, count);
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
    const fxl_point from = relative_to(eye, &object->centre);
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    uint32_t count = 0;
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face *face = &scene->faces[model->first_face + i];
        const uint16_t *corners = &scene->corners[face->first_corner];
        const fxl_point *first = &vertices[*corners];
        /* Of vectors below 2^30 in each coordinate: fxl_placed_face_is_front's sum. */
        if (fxl_dot(&face->normal, from.x - first->x, from.y - first->y, from.z - first->z) > 0) {
            fxl_order_entry *entry = &entries[count++];
            *entry = fxl_order_entry_of(box_distance(vertices, corners, face->count, &from),
                                        (uint16_t)i, 0);
        }
    }
    sort_faces(entries, count);
    return count;
}
