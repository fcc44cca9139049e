/* SPDX-License-Identifier: MIT */
#include "scene/face_bounds.h"
#include "tiny.h"
#include "view/cull.h"

#ifdef UNIT_ON_TARGET
#define MANY 180
#else
#define MANY 4000 /* more than are sorted by digits */
#endif

static fxl_draw_entry entries[MANY];

/* The definition (SPEC.md, section 6): whether a is drawn before b. */
static bool before(const fxl_draw_entry *a, const fxl_draw_entry *b)
{
    if (a->instance.layer != b->instance.layer) {
        return a->instance.layer < b->instance.layer;
    }
    if (fxl_draw_entry_distance(a) != fxl_draw_entry_distance(b)) {
        return fxl_draw_entry_distance(a) > fxl_draw_entry_distance(b);
    }
    return a->index < b->index;
}

static void expect_sorted(uint32_t count)
{
    static uint8_t seen[MANY];
    memset(seen, 0, sizeof seen);
    for (uint32_t i = 0; i < count; i++) {
        TEST_ASSERT_TRUE(entries[i].index < count);
        seen[entries[i].index]++;
        TEST_ASSERT_TRUE(i == 0 || before(&entries[i - 1], &entries[i]));
    }
    for (uint32_t i = 0; i < count; i++) {
        TEST_ASSERT_EQUAL_MESSAGE(1, seen[i], "an entry lost or doubled");
    }
}

/* Few different keys, so that ties abound; an entry's key is a function of its
 * index, so that keys cannot change places. */
/* SPEC 6.1a-d */
void test_sorting_is_by_layer_distance_and_index(void)
{
    for (int round = 0; round < UNIT_REPEAT / 500 + 10; round++) {
        uint32_t count = (uint32_t)unit_between(0, round % 8 ? 40 : MANY);
        uint32_t spread = (uint32_t)unit_between(1, 20);
        for (uint32_t i = 0; i < count; i++) {
            uint64_t distance = unit_random() % spread;
            entries[i] = fxl_draw_entry_of(distance << (unit_random() % 2 * 59), (uint16_t)i,
                                           (uint8_t)(unit_random() % (1 + spread / 4)));
        }
        for (uint32_t i = count; i > 1; i--) {
            uint32_t other = unit_random() % i;
            fxl_draw_entry swap = entries[i - 1];
            entries[i - 1] = entries[other];
            entries[other] = swap;
        }
        fxl_sort_instances(entries, count);
        expect_sorted(count);
    }
}

void test_sorted_and_reversed_input(void)
{
    for (int way = 0; way < 2; way++) {
        for (uint32_t i = 0; i < MANY; i++) {
            uint32_t key = way ? i : MANY - 1 - i;
            entries[i] = fxl_draw_entry_of(key, (uint16_t)i, 0);
        }
        fxl_sort_instances(entries, MANY);
        expect_sorted(MANY);
        TEST_ASSERT_EQUAL_UINT64(MANY - 1, fxl_draw_entry_distance(&entries[0]));
    }
}

/* Distances that rise and fall in runs, jump, or repeat; the entries by number, as
 * faces come. */
static void make_faces(uint32_t count, uint32_t kind)
{
    uint64_t distance = unit_random();
    for (uint32_t i = 0; i < count; i++) {
        uint64_t step = unit_random() % (kind % 4 == 0 ? 2 : 1000);
        distance = i % (1 + kind) > kind / 2 ? distance + step : distance - step;
        if (kind == 3) {
            distance = (uint64_t)unit_random() << 32 | unit_random();
        }
        entries[i] = fxl_draw_entry_of(distance, (uint16_t)i, 0);
    }
}

static fxl_sort_work work;

/* What was to be sorted: entries lose their distances by it. */
static uint64_t keys[MANY];

static void sort_faces(uint32_t count)
{
    static uint8_t seen[MANY];
    memset(seen, 0, sizeof seen);
    for (uint32_t i = 0; i < count; i++) {
        keys[i] = fxl_draw_entry_distance(&entries[i]);
    }
    fxl_sort_faces(entries, count, &work);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t face = entries[i].face, last = i > 0 ? entries[i - 1].face : face;
        TEST_ASSERT_TRUE(face < count);
        TEST_ASSERT_EQUAL_MESSAGE(0, seen[face]++, "a face twice");
        TEST_ASSERT_TRUE(keys[face] <= keys[last] && (keys[face] < keys[last] || face >= last));
    }
}

/* SPEC 6.3a, 6.3c */
void test_sorting_faces_is_by_distance_and_index(void)
{
    for (uint32_t round = 0; round < UNIT_REPEAT / 500 + 10; round++) {
        uint32_t count = (uint32_t)unit_between(0, round % 8 ? 40 : MANY);
        make_faces(count, round % 23);
        sort_faces(count);
    }
}

/* Distances over ranges of all sizes, of which those that come last or those
 * that no look at a few will find lie far beyond. */
void test_sorting_faces_of_any_range(void)
{
    for (uint32_t round = 0; round < 4 * 62; round++) {
        uint32_t count = (uint32_t)unit_between(2, MANY);
        uint64_t range = ((uint64_t)4 << round / 4) - round % 2;
        for (uint32_t i = 0; i < count; i++) {
            uint64_t distance = ((uint64_t)unit_random() << 32 | unit_random()) % range;
            if (round % 4 >= 2) {
                distance = distance / 65536 + (i % 61 == 1 ? range - range / 65536 : 0);
            }
            entries[i] = fxl_draw_entry_of(distance, (uint16_t)i, 0);
        }
        sort_faces(count);
    }
}

/* Faces whose distances are spread evenly have a bucket each, so that no chain is followed. A
 * bucket is as wide as their step. The last few are not among the sample that says how far they
 * reach. */
void test_faces_that_are_spread_evenly_share_no_bucket(void)
{
    const uint32_t most = FXL_ORDER_CHAINS <= MANY ? FXL_ORDER_CHAINS : MANY / 2;
    for (uint32_t count = 4; count <= most && !FXL_IS_SMALL; count *= 2) {
        for (uint32_t shift = 24; shift < 59; shift++) {
            const uint64_t range = (uint64_t)1 << shift | (uint64_t)unit_random() << shift >> 32;
            uint32_t alone = 0;
            for (uint32_t i = 0; i < count; i++) {
                entries[i] = fxl_draw_entry_of(range / (count - 1) * i, (uint16_t)i, 0);
            }
            sort_faces(count);
            for (uint32_t i = 0; i < count; i++) {
                alone += entries[i].next == UINT16_MAX;
            }
            TEST_ASSERT_TRUE(alone + count / 16 >= count);
        }
    }
}

/* As many runs as there can be: each of two entries. */
void test_sorting_faces_of_the_shortest_runs(void)
{
    for (uint32_t i = 0; i < MANY; i++) {
        entries[i] = fxl_draw_entry_of(i % 2 ? MANY - i : 3 * MANY - i, (uint16_t)i, 0);
    }
    fxl_sort_faces(entries, MANY, &work);
    for (uint32_t i = 0; i < MANY; i++) {
        TEST_ASSERT_EQUAL_UINT32(i < MANY / 2 ? 2 * i : 2 * (i - MANY / 2) + 1, entries[i].face);
    }
}

/* The places count to 65534, and the chains are as many as there can be: all but
 * two faces, which lie at the ends of the range, are in one bucket. */
void test_sorting_the_most_faces(void)
{
#ifndef UNIT_ON_TARGET
    static fxl_draw_entry many[FXL_MODEL_FACES_MAX];
    const uint32_t count = FXL_MODEL_FACES_MAX;
    for (uint32_t i = 0; i < count; i++) {
        many[i] = fxl_draw_entry_of((i % 2 ? 1 : 3) * count - i, (uint16_t)i, 0);
    }
    many[0] = fxl_draw_entry_of(0, 0, 0);
    many[1] = fxl_draw_entry_of(UINT64_MAX >> 1, 1, 0);
    fxl_sort_faces(many, count, &work);
    TEST_ASSERT_EQUAL_UINT32(1, many[0].face);
    TEST_ASSERT_EQUAL_UINT32(0, many[count - 1].face);
    for (uint32_t i = 1; i < count - 1; i++) {
        TEST_ASSERT_EQUAL_UINT32(i <= count / 2 ? 2 * i : 2 * (i - count / 2) + 1, many[i].face);
    }
#endif
}

void test_nothing_and_one_entry(void)
{
    entries[0] = fxl_draw_entry_of(7, 0, 3);
    fxl_sort_instances(entries, 0);
    fxl_sort_instances(entries, 1);
    fxl_sort_faces(entries, 0, &work);
    TEST_ASSERT_EQUAL_UINT64(7, fxl_draw_entry_distance(&entries[0]));
    TEST_ASSERT_EQUAL_UINT32(3, entries[0].instance.layer);
}

/* SPEC 3.3e, 6.1c */
void test_distance_is_exact_at_the_ends(void)
{
    const fxl_q16_16 end = FXL_COORDINATE_MAX;
    fxl_point low = {-end, -end, -end}, high = {end, end, end};
    const uint64_t side = 2 * (uint64_t)FXL_COORDINATE_MAX;
    TEST_ASSERT_TRUE(3 * side * side < (uint64_t)1 << 62);
    TEST_ASSERT_EQUAL_UINT64(3 * side * side, fxl_distance_squared(&low, &high));
    TEST_ASSERT_EQUAL_UINT64(3 * side * side, fxl_distance_squared(&high, &low));
    TEST_ASSERT_EQUAL_UINT64(0, fxl_distance_squared(&high, &high));
}

/* Adds a square to a sum; fails where 64 bits do not hold it. */
static uint64_t add_square(uint64_t sum, int64_t value)
{
    uint64_t size = value < 0 ? (uint64_t)-value : (uint64_t)value;
    TEST_ASSERT_TRUE(size <= UINT32_MAX && sum <= UINT64_MAX - size * size);
    return sum + size * size;
}

/* SPEC 6.1c, accuracy 1.1n */
void test_distance_is_the_sum_of_squares(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_point a = unit_point(FXL_COORDINATE_MAX), b = unit_point(FXL_COORDINATE_MAX);
        uint64_t sum = add_square(0, (int64_t)a.x - b.x);
        sum = add_square(sum, (int64_t)a.y - b.y);
        sum = add_square(sum, (int64_t)a.z - b.z);
        TEST_ASSERT_EQUAL_UINT64(sum, fxl_distance_squared(&a, &b));
    }
}

static uint64_t face_distance(const tiny_scene *tiny, const fxl_instance *instance,
                              const fxl_face *face, const fxl_point *eye)
{
    int64_t low[3], high[3], at_eye[3] = {eye->x, eye->y, eye->z};
    uint64_t sum = 0;
    for (uint32_t i = 0; i < face->count; i++) {
        const fxl_model *model = &tiny->models[instance->model];
        const fxl_point *v =
            &tiny->vertices[model->first_vertex + fxl_face_indices(tiny->corners, face)[i]];
        int64_t at[3] = {(int64_t)v->x + instance->centre.x, (int64_t)v->y + instance->centre.y,
                         (int64_t)v->z + instance->centre.z};
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = i == 0 || at[axis] < low[axis] ? at[axis] : low[axis];
            high[axis] = i == 0 || at[axis] > high[axis] ? at[axis] : high[axis];
        }
    }
    for (int axis = 0; axis < 3; axis++) {
        sum = add_square(sum, low[axis] + high[axis] - 2 * at_eye[axis]);
    }
    return sum;
}

/* The distance of a face's box that the library keeps. */
static uint64_t distance_by_box(const fxl_scene *scene, const fxl_instance *instance,
                                const fxl_face *face, const fxl_point *eye)
{
    fxl_point relative;
    fxl_subtract(eye, &instance->centre, &relative);
    const fxl_point box =
        fxl_face_box(&scene->vertices[scene->models[instance->model].first_vertex],
                     fxl_face_indices(scene->indices, face), face->count);
    return fxl_box_distance(box.x, box.y, box.z, &relative);
}

/* SPEC 6.3b */
void test_face_distance_is_that_of_its_box(void)
{
    tiny_scene *tiny = tiny_make();
    for (int i = 0; i < UNIT_REPEAT / 2; i++) {
        fxl_instance *instance = &tiny->instances[i % 2];
        fxl_point eye = unit_point(FXL_COORDINATE_MAX);
        instance->centre = unit_point(FXL_COORDINATE_MAX - Q16(20));
        for (int v = 0; v < 16; v++) {
            tiny->vertices[v] = unit_point(Q16(20));
        }
        const fxl_face *face = &tiny->faces[6 * (i % 2) + (int)(unit_random() % 6)];
        TEST_ASSERT_EQUAL_UINT64(face_distance(tiny, instance, face, &eye),
                                 distance_by_box(&tiny->scene, instance, face, &eye));
    }
}

void test_face_distance_at_the_ends(void)
{
    tiny_scene *tiny = tiny_make();
    const fxl_q16_16 end = FXL_COORDINATE_MAX;
    fxl_point eye = {-end, -end, -end};
    tiny->instances[0].centre = (fxl_point){end, end, end};
    for (int v = 0; v < 8; v++) {
        tiny->vertices[v] = (fxl_point){0, 0, 0};
    }
    const uint64_t side = 4 * (uint64_t)FXL_COORDINATE_MAX;
    TEST_ASSERT_EQUAL_UINT64(
        3 * side * side, distance_by_box(&tiny->scene, &tiny->instances[0], &tiny->faces[0], &eye));
}

/* An eye at (0, 0, -5) that looks ahead, with a wide lens: it sees all of tiny's
 * objects. */
static uint32_t order_from(tiny_scene *tiny, const fxl_pose *pose, uint32_t *left_out)
{
    fxl_lens lens = unit_lens(48, 32);
    fxl_camera camera;
    fxl_view_frustum frustum;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(pose, &camera));
    fxl_view_frustum_from_lens(&lens, &frustum);
    return fxl_list_still_instances(&tiny->scene, &camera, &frustum, entries, left_out);
}

static const fxl_pose before_all = {{0, 0, Q16(-5)}, 0, 0, 0};

/* SPEC 6.1b-c */
void test_objects_by_layer_then_far_to_near(void)
{
    tiny_scene *tiny = tiny_make();
    uint32_t left_out;
    entries[TINY_INSTANCES].index = 4321;
    TEST_ASSERT_EQUAL_UINT32(TINY_INSTANCES, order_from(tiny, &before_all, &left_out));
    TEST_ASSERT_EQUAL_UINT32(0, left_out);
    const uint32_t far_to_near[] = {2, 1, 0};
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(4321, entries[TINY_INSTANCES].index, "one entry too many");
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        const fxl_draw_entry *entry = &entries[i];
        TEST_ASSERT_EQUAL_UINT32(far_to_near[i], entry->index);
        TEST_ASSERT_EQUAL_UINT64(
            fxl_distance_squared(&before_all.position, &tiny->instances[entry->index].centre),
            fxl_draw_entry_distance(entry));
        TEST_ASSERT_EQUAL_UINT32(0, entry->instance.planes);
    }
    tiny->instances[0].layer = 1;
    tiny->instances[1].layer = 255;
    tiny->instances[2].layer = 255;
    TEST_ASSERT_EQUAL_UINT32(TINY_INSTANCES, order_from(tiny, &before_all, &left_out));
    TEST_ASSERT_EQUAL_UINT32(0, entries[0].index);
    TEST_ASSERT_EQUAL_UINT32(2, entries[1].index);
    TEST_ASSERT_EQUAL_UINT32(1, entries[2].index);
    TEST_ASSERT_EQUAL_UINT32(255, entries[2].instance.layer);
}

/* SPEC 6.1d */
void test_equally_far_objects_by_number(void)
{
    tiny_scene *tiny = tiny_make();
    uint32_t left_out;
    for (int i = 0; i < TINY_INSTANCES; i++) {
        tiny->instances[i].centre = (fxl_point){i % 2 ? Q16(3) : Q16(-3), 0, Q16(3)};
    }
    TEST_ASSERT_EQUAL_UINT32(TINY_INSTANCES, order_from(tiny, &before_all, &left_out));
    for (uint32_t i = 0; i < TINY_INSTANCES; i++) {
        TEST_ASSERT_EQUAL_UINT32(i, entries[i].index);
    }
}

/* Between the first object and the others, and with one moved to the left
 * border: what is behind is left out with all its faces, and no key is wasted. */
void test_objects_out_of_sight_are_left_out(void)
{
    tiny_scene *tiny = tiny_make();
    const fxl_pose between = {{0, 0, Q16(4)}, 0, 0, 0};
    uint32_t left_out;
    tiny->instances[2].centre = (fxl_point){Q16(-8), 0, Q16(12)};
    TEST_ASSERT_EQUAL_UINT32(2, order_from(tiny, &between, &left_out));
    TEST_ASSERT_EQUAL_UINT32(6, left_out);
    TEST_ASSERT_EQUAL_UINT32(2, entries[0].index);
    TEST_ASSERT_EQUAL_HEX32(1u << FXL_PLANE_LEFT, entries[0].instance.planes);
    TEST_ASSERT_EQUAL_UINT32(1, entries[1].index);
    TEST_ASSERT_EQUAL_HEX32(0, entries[1].instance.planes);
    const fxl_pose behind = {{0, 0, Q16(40)}, 0, 0, 0};
    TEST_ASSERT_EQUAL_UINT32(0, order_from(tiny, &behind, &left_out));
    TEST_ASSERT_EQUAL_UINT32(18, left_out);
}

static uint32_t order_faces(const fxl_scene *scene, const fxl_instance *instance,
                            const fxl_point *eye, fxl_draw_entry *order)
{
    const fxl_point *centre = &instance->centre;
    const fxl_point from = {eye->x - centre->x, eye->y - centre->y, eye->z - centre->z};
    const fxl_model *model = &scene->models[instance->model];
    uint32_t count = fxl_list_front_faces(scene, model, &from, order);
    fxl_sort_faces(order, count, &work);
    return count;
}

/* Seen from a corner: three faces, the nearest last. Indices are those of the
 * model's faces or of the scene's; which, the order of colours tells. */
/* SPEC 4.5a, 6.3a-b */
void test_faces_that_face_the_eye_far_to_near(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_point eye = {Q16(4), Q16(6), Q16(18)};
    const fxl_instance *instance = &tiny->instances[1];
    uint32_t count = order_faces(&tiny->scene, instance, &eye, entries);
    uint64_t last = 0;
    TEST_ASSERT_EQUAL_UINT32(3, count);
    for (uint32_t i = 0; i < count; i++) {
        const fxl_face *face = &tiny->faces[6 + entries[i].face];
        uint64_t distance = face_distance(tiny, instance, face, &eye);
        TEST_ASSERT_TRUE(entries[i].face % 2 == 1);
        TEST_ASSERT_TRUE(i == 0 || distance < last);
        last = distance;
    }
    TEST_ASSERT_EQUAL_UINT32(5, entries[2].face);
}

/* With keys and without, and each face by its own. */
void test_keys_change_nothing(void)
{
    for (int i = 0; i < UNIT_REPEAT / 20; i++) {
        tiny_scene *tiny = tiny_make();
        fxl_instance *instance = &tiny->instances[1];
        instance->centre = unit_point(FXL_COORDINATE_MAX - Q16(2));
        fxl_point eye = unit_point(FXL_COORDINATE_MAX);
        if (i % 2) {
            eye = instance->centre; /* on a plane, a unit before or behind it, or about */
            eye.x += unit_between(-1, 1) * Q16(1) + unit_between(-1, 1);
            eye.y += unit_between(-2, 2) * Q16(1) + unit_between(-1, 1);
            eye.z += unit_between(-2, 2) * Q16(1) + unit_between(-1, 1);
        }
        uint32_t count = order_faces(&tiny->scene, instance, &eye, entries);
        fxl_scene bare = tiny->scene;
        bare.face_bounds = NULL;
        TEST_ASSERT_EQUAL_UINT32(count, order_faces(&bare, instance, &eye, entries + 6));
        uint64_t last = 0;
        uint32_t front = 0;
        for (uint32_t f = 0; f < 6; f++) {
            front += fxl_face_is_front(&bare, instance, &tiny->faces[6 + f], &eye);
        }
        TEST_ASSERT_EQUAL_UINT32(front, count);
        for (uint32_t k = 0; k < count; k++) {
            const fxl_face *face = &tiny->faces[6 + entries[k].face];
            uint64_t distance = face_distance(tiny, instance, face, &eye);
            TEST_ASSERT_TRUE(fxl_face_is_front(&bare, instance, face, &eye));
            TEST_ASSERT_EQUAL_UINT32(entries[k].face, entries[6 + k].face);
            TEST_ASSERT_TRUE(k == 0 || distance <= last);
            last = distance;
        }
    }
}

/* SPEC 4.5a */
void test_every_face_is_seen_from_somewhere(void)
{
    tiny_scene *tiny = tiny_make();
    for (uint32_t f = 0; f < 6; f++) {
        fxl_q16_16 out = f % 2 ? Q16(9) : Q16(-9);
        fxl_point eye = {f / 2 == 0 ? out : 0, f / 2 == 1 ? out : 0, f / 2 == 2 ? out : 0};
        eye.z += Q16(10);
        uint32_t count = order_faces(&tiny->scene, &tiny->instances[1], &eye, entries);
        TEST_ASSERT_EQUAL_UINT32(1, count);
        TEST_ASSERT_EQUAL_UINT32(f, entries[0].face);
    }
}

void test_no_face_faces_an_eye_inside(void)
{
    tiny_scene *tiny = tiny_make();
    fxl_point eye = {0, 0, Q16(10)};
    TEST_ASSERT_EQUAL_UINT32(0, order_faces(&tiny->scene, &tiny->instances[1], &eye, entries));
}
