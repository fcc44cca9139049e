/* SPDX-License-Identifier: MIT */
#include "fixel/stage/order.h"

#include "../math/arith.h"
#include "../scene/face_bounds.h"
#include "front_faces.h"

uint64_t fxl_distance_squared(const fxl_point *eye, const fxl_point *point)
{
    FXL_ASSERT(fxl_point_in_range(eye) && fxl_point_in_range(point));
    return fxl_square(point->x - eye->x) + fxl_square(point->y - eye->y) +
           fxl_square(point->z - eye->z);
}

uint64_t fxl_face_distance_squared(const fxl_point *eye, const fxl_scene *scene,
                                   const fxl_instance *instance, const fxl_face *face)
{
    fxl_point relative;
    fxl_subtract(eye, &instance->centre, &relative);
    fxl_point box = fxl_face_box(&scene->vertices[scene->models[instance->model].first_vertex],
                                 &scene->indices[face->first_index], face->count);
    return fxl_box_distance(box.x, box.y, box.z, &relative);
}

/* Whether a is drawn before b. */
static inline bool before(const fxl_order_entry *a, const fxl_order_entry *b)
{
    uint64_t from_a = fxl_order_distance(a), from_b = fxl_order_distance(b);
    if (a->instance.layer == b->instance.layer) {
        if (from_a > from_b) { /* bug: near-first */
            return true;
        }
        return from_a == from_b && a->index < b->index; /* bug: half-distance */
    }
    return a->instance.layer < b->instance.layer;
}

/* Shellsort with the gaps of Sedgewick (1986), 4^k + 3 * 2^(k - 1) + 1: in place, without
 * recursion, and of order count^(4/3) at most, for any input. Few instances are visible, so
 * it matters most that short arrays are fast. */
void fxl_order_sort(fxl_order_entry *entries, uint32_t count)
{
    static const uint16_t gaps[] = {16577, 4193, 1073, 281, 77, 23, 8, 1};
    for (uint32_t g = 0; g < sizeof gaps / sizeof gaps[0]; g++) {
        uint32_t gap = gaps[g];
        for (uint32_t i = gap; i < count; i++) {
            const fxl_order_entry entry = entries[i];
            fxl_order_entry *place = &entries[i];
            while (place >= &entries[gap] && before(&entry, place - gap)) {
                *place = *(place - gap);
                place -= gap;
            }
            *place = entry;
        }
    }
}

/* Sorts faces as instances of one layer. */
static void sort_as_instances(fxl_order_entry *entries, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        entries[i].next = 0;
    }
    fxl_order_sort(entries, count);
    for (uint32_t i = 0; i < count; i++) {
        entries[i].face = entries[i].index;
    }
}

/* The `next` of the last entry of a chain. No entry has this place. */
#define END 0xFFFFu

/* Merges two chains of entries, each in order, into one; returns its first place. Requires that
 * a's entries have lower places than b's: of two entries with equal distances a's comes first. */
static uint32_t merge(fxl_order_entry *entries, uint32_t a, uint32_t b)
{
    fxl_order_entry *at_a = &entries[a], *at_b = &entries[b];
    uint64_t from_a = fxl_order_distance(at_a), from_b = fxl_order_distance(at_b);
    uint32_t head = from_a >= from_b ? a : b; /* bug: chain-head */
    fxl_order_entry *last = NULL;
    for (;;) {
        if (from_a >= from_b) {
            if (last != NULL) {
                last->next = (uint16_t)a;
            }
            last = at_a;
            a = at_a->next;
            if (a == END) {
                last->next = (uint16_t)b;
                return head;
            }
            at_a = &entries[a];
            from_a = fxl_order_distance(at_a);
        } else {
            if (last != NULL) {
                last->next = (uint16_t)b;
            }
            last = at_b;
            b = at_b->next;
            if (b == END) {
                last->next = (uint16_t)a;
                return head;
            }
            at_b = &entries[b];
            from_b = fxl_order_distance(at_b);
        }
    }
}

/* Chains the longest run of entries from *place on that are in order, or in the reverse order
 * without equal distances, and moves *place behind the run. Returns the chain. */
static uint32_t take_run(fxl_order_entry *entries, uint32_t count, uint32_t *place)
{
    uint32_t head = *place, at = head + 1;
    uint64_t from_last = fxl_order_distance(&entries[head]);
    if (at < count && fxl_order_distance(&entries[at]) > from_last) {
        entries[head].next = END;
        /* bug: run-tie */
        for (; at < count && fxl_order_distance(&entries[at]) > from_last; at++) {
            from_last = fxl_order_distance(&entries[at]);
            entries[at].next = (uint16_t)head;
            head = at;
        }
    } else {
        for (; at < count && fxl_order_distance(&entries[at]) <= from_last; at++) {
            from_last = fxl_order_distance(&entries[at]);
            entries[at - 1].next = (uint16_t)at;
        }
        entries[at - 1].next = END;
    }
    *place = at;
    return head;
}

/* Writes the numbers of a chain's faces into `face` of the entries from `place` on. Returns the
 * place behind the last. This overwrites distances, but no links. */
static uint32_t put_in_order(fxl_order_entry *entries, uint32_t chain, uint32_t place)
{
    while (chain != END) {
        const fxl_order_entry *entry = &entries[chain];
        entries[place++].face = entry->index;
        chain = entry->next;
    }
    return place;
}

/* Merge sort of runs, in place and without recursion. chains[i] has 2^i runs, whose places are
 * below those of chains[i - 1]. A run has at least two entries, except the last. */
static void sort_by_merging(fxl_order_entry *entries, uint32_t count)
{
    uint16_t chains[16];
    uint32_t levels = 0, place = 0;
    while (place < count) {
        uint32_t chain = take_run(entries, count, &place), level = 0;
        for (; level < levels && chains[level] != END; level++) {
            chain = merge(entries, chains[level], chain);
            chains[level] = END;
        }
        if (level == levels) {
            levels += 1;
        }
        chains[level] = (uint16_t)chain;
    }
    uint32_t all = END;
    for (uint32_t level = 0; level < levels; level++) {
        if (chains[level] != END) {
            all = all == END ? chains[level] : merge(entries, chains[level], all);
        }
    }
    put_in_order(entries, all, 0);
}

/* Buckets of equal width, the farthest first. Their chains take 128 bytes of stack. */
#define BUCKETS 64u

/* The steps along chains, on average a face, after which the sort by buckets gives up. */
#define STEPS_A_FACE 4u

/* The map from distances to buckets. */
typedef struct {
    uint64_t farthest; /* farther distances go into the first bucket */
    uint64_t range;    /* farthest - nearest; nearer distances go into the last bucket */
    uint32_t factor;   /* below BUCKETS 2^(32 + shift) / range */
    uint32_t shift;
} buckets;

/* Sets up the buckets from a sample of the faces. */
static void survey_distances(const fxl_order_entry *entries, uint32_t count, buckets *by)
{
    uint64_t farthest = 0, nearest = UINT64_MAX;
    for (uint32_t i = 0; i < count; i += count / 64 | 1) {
        uint64_t distance = fxl_order_distance(&entries[i]);
        farthest = distance > farthest ? distance : farthest;
        nearest = distance < nearest ? distance : nearest;
    }
    by->farthest = farthest;
    by->range = farthest - nearest;
    uint32_t high = (uint32_t)(by->range >> 32), low = (uint32_t)by->range | UINT16_MAX;
    unsigned zeros = fxl_leading_zeros(high != 0 ? high : low);
    unsigned bits = (high != 0 ? 64u : 32u) - zeros;
    uint32_t upper = high != 0 ? high << zeros | low >> 1 >> (31 - zeros) : low << zeros;
    uint32_t rest, factor = fxl_divide_u32(UINT32_MAX, (upper >> 16) + 1, &rest);
    by->factor = bits < 32   ? factor << 15
                 : bits < 47 ? factor << (47 - bits)
                             : factor >> (bits - 47);
    by->shift = bits < 32 ? bits - 7 : 25;
}

/* floor((farthest - distance) factor / 2^(32 + shift)). The range is below 2^bits. Its upper 16
 * bits, plus 1, times the first factor are not above 2^32. So range factor is below 2^63 if
 * bits >= 32, else below 2^(31 + bits). Nothing wraps, and the result is below 2^6. */
static inline uint32_t bucket_of(const buckets *by, uint64_t distance)
{
    uint64_t nearer = by->farthest - distance;
    if (nearer > by->range) {
        return distance > by->farthest ? 0 : BUCKETS - 1;
    }
    uint32_t high = (uint32_t)(nearer >> 32) * by->factor;
    return (high + (uint32_t)(fxl_multiply_u32((uint32_t)nearer, by->factor) >> 32)) >> by->shift;
}

/* Inserts each face into its bucket, which is a chain in order. Faces come from the last number to
 * the first, so a face goes before others of the same distance. Squared distances of the points of
 * a plane or a sphere are spread evenly, so a bucket holds few. Returns false if too many faces
 * share too few buckets: then only links have changed. */
static bool sort_by_buckets(fxl_order_entry *entries, uint32_t count)
{
    buckets by;
    uint16_t chains[BUCKETS];
    uint32_t steps = STEPS_A_FACE * count;
    survey_distances(entries, count, &by);
    for (uint32_t i = 0; i < BUCKETS; i++) {
        chains[i] = END;
    }
    for (uint32_t i = count; i-- > 0;) {
        uint64_t distance = fxl_order_distance(&entries[i]);
        uint16_t *link = &chains[bucket_of(&by, distance)];
        /* bug: bucket-tie */
        while (*link != END && fxl_order_distance(&entries[*link]) > distance) {
            link = &entries[*link].next;
            if (steps-- == 0) {
                return false;
            }
        }
        entries[i].next = *link;
        *link = (uint16_t)i;
    }
    uint32_t place = 0;
    for (uint32_t i = 0; i < BUCKETS; i++) {
        place = put_in_order(entries, chains[i], place);
    }
    return true;
}

void fxl_order_sort_faces(fxl_order_entry *entries, uint32_t count)
{
    if (FXL_IS_SMALL) {
        sort_as_instances(entries, count);
    } else if (!sort_by_buckets(entries, count)) {
        sort_by_merging(entries, count);
    }
}

uint32_t fxl_order_instances(const fxl_scene *scene, const fxl_camera *camera,
                             const fxl_view_frustum *frustum, fxl_order_entry *entries,
                             uint32_t *left_out)
{
    uint32_t count = 0;
    *left_out = 0;
    for (uint32_t i = 0; i < scene->instance_count; i++) {
        const fxl_instance *instance = &scene->instances[i];
        const fxl_model *model = &scene->models[instance->model];
        uint32_t planes = fxl_sphere_planes(camera, frustum, &instance->centre, model->radius);
        if (planes == FXL_SPHERE_OUTSIDE) {
            *left_out += model->face_count; /* below 2^16 * 2^16 */
            continue;
        }
        fxl_order_entry *entry = &entries[count++];
        *entry = fxl_order_entry_of(fxl_distance_squared(&camera->position, &instance->centre),
                                    (uint16_t)i, instance->layer);
        entry->instance.planes = (uint8_t)planes;
    }
    fxl_order_sort(entries, count);
    return count;
}

/* The same as fxl_front_faces, for a scene without face bounds: bounds is null, and they are
 * computed from the vertices. With FXL_SMALL it serves both kinds of scenes. */
static fxl_order_entry *find_front(const fxl_scene *scene, const fxl_model *model,
                                   const fxl_face_bounds *bounds, const fxl_point *eye,
                                   fxl_order_entry *entry)
{
    const fxl_point *vertices = &scene->vertices[model->first_vertex];
    const fxl_face *faces = &scene->faces[model->first_face];
    for (uint32_t i = 0; i < model->face_count; i++) {
        const fxl_face_bounds *known = FXL_IS_SMALL && bounds != NULL ? &bounds[i] : NULL;
        const uint16_t *indices = &scene->indices[faces[i].first_index];
        const fxl_q18_46 height = known != NULL ? fxl_face_bounds_height(known)
                                                : fxl_face_height(vertices, indices, &faces[i]);
        if (fxl_dot(&faces[i].normal, eye->x, eye->y, eye->z) > height) {
            fxl_point box;
            if (known != NULL) {
                box.x = known->box_x;
                box.y = known->box_y;
                box.z = known->box_z;
            } else {
                box = fxl_face_box(vertices, indices, faces[i].count);
            }
            *entry++ =
                fxl_order_entry_of(fxl_box_distance(box.x, box.y, box.z, eye), (uint16_t)i, 0);
        }
    }
    return entry;
}

uint32_t fxl_order_faces(const fxl_scene *scene, const fxl_instance *instance, const fxl_point *eye,
                         fxl_order_entry *entries)
{
    const fxl_model *model = &scene->models[instance->model];
    fxl_point relative;
    fxl_subtract(eye, &instance->centre, &relative);
    const fxl_face_bounds *bounds =
        scene->face_bounds != NULL ? &scene->face_bounds[model->first_face_bounds] : NULL;
    const fxl_order_entry *end = FXL_IS_SMALL || bounds == NULL
                                     ? find_front(scene, model, bounds, &relative, entries)
                                     : fxl_front_faces(&scene->faces[model->first_face], bounds,
                                                       &relative, entries, model->face_count);
    uint32_t count = (uint32_t)(end - entries);
    fxl_order_sort_faces(entries, count);
    return count;
}
