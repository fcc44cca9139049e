/* SPDX-License-Identifier: MIT */
/* A file of its own, so that the compiler does not spend registers of the loop on the choice. */
#include "../math/family.h"
#include "../math/arith.h"
#include "../scene/face_bounds.h"
#include "../scene/placement_code.h"
#include "cull.h"
#include "model_view.h"
#include "order.h"
#include "outcode.h"

/* SPEC 6.1 */
uint64_t fxl_distance_squared(const fxl_point *eye, const fxl_point *point)
{
    FXL_ASSERT(fxl_point_in_range(eye) && fxl_point_in_range(point));
    return fxl_square(point->x - eye->x) + fxl_square(point->y - eye->y) +
           fxl_square(point->z - eye->z);
}

/* Whether a is drawn before b. */
/* SPEC 6.1 */
static inline bool before(const fxl_draw_entry *a, const fxl_draw_entry *b)
{
    uint64_t from_a = fxl_draw_entry_distance(a), from_b = fxl_draw_entry_distance(b);
    if (a->instance.layer == b->instance.layer) {
        if (from_a > from_b) {
            return true;
        }
        return from_a == from_b && a->index < b->index;
    }
    return a->instance.layer < b->instance.layer;
}

/* Shellsort with the gaps of Sedgewick (1986), 4^k + 3 * 2^(k - 1) + 1: in place, without
 * recursion, and of order count^(4/3) at most, for any input. Few instances are visible, so
 * it matters most that short arrays are fast. */
/* SPEC 6.1 */
void fxl_sort_instances(fxl_draw_entry *entries, uint32_t count)
{
    static const uint16_t gaps[] = {16577, 4193, 1073, 281, 77, 23, 8, 1};
    for (uint32_t g = 0; g < sizeof gaps / sizeof gaps[0]; g++) {
        uint32_t gap = gaps[g];
        for (uint32_t i = gap; i < count; i++) {
            const fxl_draw_entry entry = entries[i];
            fxl_draw_entry *place = &entries[i];
            while (place >= &entries[gap] && before(&entry, place - gap)) {
                *place = *(place - gap);
                place -= gap;
            }
            *place = entry;
        }
    }
}

uint32_t fxl_list_still_instances(const fxl_scene *scene, const fxl_camera *camera,
                                  const fxl_view_frustum *frustum, fxl_draw_entry *entries,
                                  uint32_t *left_out)
{
    uint32_t count = 0;
    *left_out = 0;
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const fxl_instance *instance = &scene->instances[i];
        const fxl_model *model = &scene->models[instance->model];
        fxl_q16_16 radius = model->radius;
        if (FXL_IS_COMPACT && i >= fxl_first_turned(scene)) {
            radius = fxl_scaled_radius(fxl_placement_of(scene, i)->scale, radius);
        }
        uint32_t planes = fxl_sphere_planes(camera, frustum, &instance->centre, radius);
        if (planes == FXL_SPHERE_OUTSIDE) {
            *left_out += model->face_count; /* below 2^16 * 2^16 */
            continue;
        }
        entries[count++] = fxl_draw_instance_of(instance, i, planes, camera);
    }
    fxl_sort_instances(entries, count);
    return count;
}

/* Whether normal . (vertex - eye) < 0: normal . eye > height, as each coordinate of the difference
 * of two points of the world is below 2^30. Exact. */
static inline bool is_front(const fxl_face *face, const fxl_point *vertex, const fxl_point *eye)
{
    return fxl_dot(&face->normal, vertex->x - eye->x, vertex->y - eye->y, vertex->z - eye->z) < 0;
}

/* The same as fxl_front_faces, for a scene without face bounds: bounds is null, and they are
 * computed from the vertices. With FXL_SMALL it serves both kinds of scenes. */
static uint32_t find_front(const fxl_scene *scene, const fxl_model *model,
                           const fxl_face_bounds *bounds, const fxl_point *eye,
                           fxl_draw_entry *entries)
{
    uint32_t count = 0;
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    const fxl_face *faces = &scene->faces[model->first_face];
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face_bounds *known = FXL_IS_SMALL && bounds != NULL ? bounds++ : NULL;
        const uint16_t *indices = fxl_face_indices(scene->indices, &faces[i]);
        if (known != NULL
                ? fxl_dot(&faces[i].normal, eye->x, eye->y, eye->z) > fxl_face_bounds_height(known)
                : is_front(&faces[i], &vertices[*indices], eye)) {
            fxl_point box;
            if (known != NULL) {
                box.x = known->box_x;
                box.y = known->box_y;
                box.z = known->box_z;
            } else {
                box = fxl_face_box(vertices, indices, faces[i].count);
            }
            *entries++ =
                fxl_draw_entry_of(fxl_box_distance(box.x, box.y, box.z, eye), (uint16_t)i, 0);
            count++;
        }
    }
    return count;
}

uint32_t fxl_list_front_faces(const fxl_scene *scene, const fxl_model *model, const fxl_point *eye,
                              fxl_draw_entry *entries)
{
    const fxl_face_bounds *bounds =
        scene->face_bounds != NULL ? &scene->face_bounds[model->first_face_bounds] : NULL;
    if (FXL_IS_SMALL || bounds == NULL) {
        return find_front(scene, model, bounds, eye, entries);
    }
    return (uint32_t)(fxl_front_faces(&scene->faces[model->first_face], bounds, eye, entries,
                                      model->face_count, model->face_count) -
                      entries);
}

/* fxl_fetch_vertex, of a view whose members are read once: the clip flags. */
static inline uint32_t flags_of(const fxl_model_view *model_view, fxl_cached_vertex *cached,
                                uint32_t mask, uint32_t tag, uint32_t number)
{
    fxl_cached_vertex *vertex = &cached[number & mask];
    if (vertex->tag != tag + number) {
        fxl_transform_vertex(model_view, number, vertex);
    }
    return vertex->clip_flags;
}

/* The same of all vertices of a face from the fourth one on, beside those of the first three. Not
 * inline: triangles would be short of registers. */
static __attribute__((noinline)) uint32_t flags_of_others(const fxl_model_view *model_view,
                                                          const uint16_t *next, uint32_t left,
                                                          uint32_t of_all)
{
    do {
        of_all &= fxl_fetch_vertex(model_view, *next++)->clip_flags;
    } while (of_all != 0 && --left != 0);
    return of_all;
}

uint32_t fxl_drop_outside(const fxl_model_view *model_view, const fxl_face *faces,
                          fxl_draw_entry *entries, uint32_t count)
{
    fxl_cached_vertex *cached = model_view->entries;
    const uint32_t mask = model_view->mask, tag = model_view->tag;
    const fxl_draw_entry *end = entries + count;
    fxl_draw_entry *to = entries;
    for (const fxl_draw_entry *from = entries; from != end; from++) {
        const fxl_face *face = &faces[from->index];
        const uint16_t *next = fxl_face_indices(model_view->indices, face);
        const uint32_t left = face->count;
        uint32_t of_all = FXL_PLANES_ALL & flags_of(model_view, cached, mask, tag, *next++);
        if (of_all != 0) {
            of_all &= flags_of(model_view, cached, mask, tag, *next++);
            if (of_all != 0) {
                of_all &= flags_of(model_view, cached, mask, tag, *next++);
                if (of_all != 0 && left > 3) {
                    of_all = flags_of_others(model_view, next, left - 3, of_all);
                }
                if (of_all != 0) {
                    continue;
                }
            }
        }
        *to++ = *from;
    }
    return (uint32_t)(to - entries);
}

#if !FXL_KERNELS_ARMV6M && !FXL_KERNELS_ARMV7M

fxl_draw_entry *fxl_front_faces(const fxl_face *faces, const fxl_face_bounds *bounds,
                                const fxl_point *eye, fxl_draw_entry *entry, uint32_t count,
                                uint32_t end)
{
    const fxl_point from = *eye;
    for (uint32_t i = 0; i < count; i++) {
        const fxl_face_bounds *face_bounds = &bounds[i];
        if (fxl_dot(&faces[i].normal, from.x, from.y, from.z) >
            fxl_face_bounds_height(face_bounds)) {
            uint64_t distance =
                fxl_box_distance(face_bounds->box_x, face_bounds->box_y, face_bounds->box_z, &from);
            *entry++ = fxl_draw_entry_of(distance, (uint16_t)(end - count + i), 0);
        }
    }
    return entry;
}

#endif
