/* SPDX-License-Identifier: MIT */
/* Points of the world as a camera sees them: one by one, and through a cache. */
#include "unit.h"
#include "tiny.h"

/* |difference| < 2^30 and unit vectors: below 2^61. */
static int64_t along(const fxl_direction *row, const fxl_camera *camera, const fxl_point *point)
{
    return (int64_t)row->x * (point->x - camera->position.x) +
           (int64_t)row->y * (point->y - camera->position.y) +
           (int64_t)row->z * (point->z - camera->position.z);
}

static void expect_in_range(int64_t coordinate)
{
    TEST_ASSERT_TRUE(coordinate < (int64_t)1 << 61 && coordinate > -((int64_t)1 << 61));
}

static void expect_view(const fxl_camera *camera, const fxl_point *point)
{
    fxl_view_point view;
    fxl_transform_point(camera, point, &view);
    TEST_ASSERT_EQUAL_INT64(along(&camera->axes.right, camera, point), view.x);
    TEST_ASSERT_EQUAL_INT64(along(&camera->axes.up, camera, point), view.y);
    TEST_ASSERT_EQUAL_INT64(along(&camera->axes.forward, camera, point), view.z);
    expect_in_range(view.x);
    expect_in_range(view.y);
    expect_in_range(view.z);
}

static fxl_camera camera_at(const fxl_pose *pose)
{
    fxl_camera camera;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(pose, &camera));
    return camera;
}

/* SPEC 4.6a */
void test_any_point_from_anywhere(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_pose pose = unit_pose();
        fxl_camera camera = camera_at(&pose);
        fxl_point point = unit_point(FXL_COORDINATE_MAX);
        expect_view(&camera, &point);
    }
}

/* Near the eye the sums are small, and no bit of them may be lost. */
void test_points_near_the_eye(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_pose pose = unit_pose();
        pose.position = unit_point(Q16(8000));
        fxl_camera camera = camera_at(&pose);
        fxl_point step = unit_point(1 << (unit_random() % 20));
        fxl_point point = {pose.position.x + step.x, pose.position.y + step.y,
                           pose.position.z + step.z};
        expect_view(&camera, &point);
    }
}

/* One step of a coordinate is one entry of the matrix. */
void test_a_step_along_an_axis_gives_a_column(void)
{
    fxl_pose pose = {{5, -6, 7}, DEGREES(33), DEGREES(-21), DEGREES(140)};
    fxl_camera camera = camera_at(&pose);
    fxl_view_point view;
    fxl_transform_point(&camera, &(fxl_point){6, -6, 7}, &view);
    TEST_ASSERT_EQUAL_INT64(camera.axes.right.x, view.x);
    TEST_ASSERT_EQUAL_INT64(camera.axes.up.x, view.y);
    TEST_ASSERT_EQUAL_INT64(camera.axes.forward.x, view.z);
    fxl_transform_point(&camera, &(fxl_point){5, -7, 7}, &view);
    TEST_ASSERT_EQUAL_INT64(-camera.axes.right.y, view.x);
    TEST_ASSERT_EQUAL_INT64(-camera.axes.up.y, view.y);
    TEST_ASSERT_EQUAL_INT64(-camera.axes.forward.y, view.z);
    fxl_transform_point(&camera, &(fxl_point){5, -6, 8}, &view);
    TEST_ASSERT_EQUAL_INT64(camera.axes.right.z, view.x);
    TEST_ASSERT_EQUAL_INT64(camera.axes.up.z, view.y);
    TEST_ASSERT_EQUAL_INT64(camera.axes.forward.z, view.z);
}

/* SPEC 2.1e */
void test_an_unturned_view_is_the_difference(void)
{
    fxl_pose pose = {{Q16(-8191), Q16(100.5), 3}, 0, 0, 0};
    fxl_camera camera = camera_at(&pose);
    fxl_view_point view;
    fxl_transform_point(&camera, &(fxl_point){Q16(8191), Q16(-8191), Q16(0.75)}, &view);
    TEST_ASSERT_EQUAL_INT64((int64_t)16382 << 46, view.x);
    TEST_ASSERT_EQUAL_INT64(-((int64_t)16583 << 45), view.y);
    TEST_ASSERT_EQUAL_INT64(((int64_t)49152 - 3) << 30, view.z);
}

/* 2^59 - 1 needs every bit of a sum. */
/* SPEC 4.6b, accuracy 1.1o */
void test_no_bit_is_rounded_away(void)
{
    const fxl_direction slanted = {FXL_Q2_30_ONE - 1, 1, 0}, none = {0, 0, 0};
    const fxl_direction opposite = {1 - FXL_Q2_30_ONE, -1, 0};
    fxl_camera camera = {{Q16(-4096), Q16(-4096), 0}, {slanted, opposite, none}};
    fxl_point point = {Q16(4096), Q16(4096) - 1, 0};
    fxl_view_point view;
    fxl_transform_point(&camera, &point, &view);
    TEST_ASSERT_EQUAL_INT64(((int64_t)1 << 59) - 1, view.x);
    TEST_ASSERT_EQUAL_INT64(1 - ((int64_t)1 << 59), view.y);
    TEST_ASSERT_EQUAL_INT64(0, view.z);
}

void test_the_eye_itself_is_nowhere(void)
{
    fxl_pose pose = unit_pose();
    fxl_camera camera = camera_at(&pose);
    fxl_view_point view;
    fxl_transform_point(&camera, &pose.position, &view);
    TEST_ASSERT_EQUAL_INT64(0, view.x | view.y | view.z);
}

/* Turned so that forward runs along the world's diagonal: the largest sums. */
/* SPEC 3.3a, 3.3c-d, 4.6b, clippers 1.4b */
void test_opposite_corners_of_the_world(void)
{
    const fxl_q16_16 end = FXL_COORDINATE_MAX;
    int64_t largest = 0;
    for (int corner = 0; corner < 8; corner++) {
        fxl_point eye = {corner & 1 ? end : -end, corner & 2 ? end : -end, corner & 4 ? end : -end};
        fxl_point point = {-eye.x, -eye.y, -eye.z};
        fxl_pose pose = {eye, FXL_ANGLE_QUARTER / 2, 420000000u, FXL_ANGLE_QUARTER};
        fxl_camera camera = camera_at(&pose);
        fxl_view_point view;
        expect_view(&camera, &point);
        fxl_transform_point(&camera, &point, &view);
        largest = view.z > largest ? view.z : largest;
    }
    TEST_ASSERT_TRUE_MESSAGE(largest > (int64_t)28370 << 46, "no corner was straight ahead");
    TEST_ASSERT_TRUE(largest < (int64_t)28375 << 46);
}

/* Vertices seen through a cache of any size are those worked out by themselves. */

enum {
    ENTRIES = 16,
    VERTICES = 40
};

static fxl_cached_vertex entries[ENTRIES + 1];
static fxl_point vertices[2 * VERTICES];
static fxl_view view;
static fxl_vertex_cache cache;

/* Two objects, each of a model of its own. */
static const fxl_model models[] = {
    {.first_vertex = 0, .vertex_count = VERTICES, .face_count = 1},
    {.first_vertex = VERTICES, .vertex_count = VERTICES, .face_count = 1}};
static fxl_instance instances[] = {{{0, 0, 0}, 0, 0, 0}, {{0, 0, 0}, 1, 0, 0}};
static const fxl_scene scene = {.vertices = vertices, .models = models, .instances = instances};

static void start(uint32_t count)
{
    fxl_lens lens = unit_lens(64, 48);
    fxl_pose pose = unit_pose();
    memset(entries, 0x5A, sizeof entries);
    for (int i = 0; i < 2 * VERTICES; i++) {
        vertices[i] = unit_point(Q16(4000));
    }
    instances[0].centre = unit_point(Q16(4000));
    instances[1].centre = unit_point(Q16(4000));
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    fxl_vertex_cache_init(&cache, entries, count);
}

static fxl_model_view place(int instance, fxl_planes planes)
{
    fxl_model_view model_view;
    fxl_model_view_of_instance(&model_view, &scene, &instances[instance], &view, &cache);
    model_view.planes = planes;
    return model_view;
}

static void expect_seen(const fxl_model_view *model_view, int instance, uint32_t number)
{
    const fxl_point *vertex = &vertices[models[instance].first_vertex + number];
    const fxl_point *centre = &instances[instance].centre;
    fxl_point point = {vertex->x + centre->x, vertex->y + centre->y, vertex->z + centre->z};
    fxl_view_point expected;
    fxl_transform_point(&view.camera, &point, &expected);
    fxl_cached_vertex *seen = fxl_fetch_vertex(model_view, number);
    TEST_ASSERT_EQUAL_MEMORY(&expected, &seen->position, sizeof expected);
    TEST_ASSERT_EQUAL_HEX8(fxl_outcode(&view.view_frustum, model_view->planes, &expected),
                           seen->clip_flags & ~FXL_VERTEX_UNPROJECTED);
    TEST_ASSERT_EQUAL_PTR(&entries[number & cache.mask], seen);
}

void test_vertices_that_displace_each_other(void)
{
    for (uint32_t count = 1; count <= ENTRIES; count++) {
        start(count);
        for (int i = 0; i < UNIT_REPEAT / 100; i++) {
            int instance = i % 2;
            fxl_model_view model_view =
                place(instance, (fxl_planes)(unit_random() & FXL_PLANES_ALL));
            for (int k = 0; k < 20; k++) {
                expect_seen(&model_view, instance, unit_random() % VERTICES);
            }
        }
        for (uint32_t i = count; i <= ENTRIES; i++) {
            TEST_ASSERT_EACH_EQUAL_HEX8(0x5A, &entries[i], sizeof entries[i]);
        }
    }
}

/* Of a number of entries that is no power of two, what is more lies idle. */
void test_the_largest_power_of_two_that_fits(void)
{
    static const uint32_t counts[][2] = {{1, 1}, {2, 2}, {3, 2},  {4, 4},
                                         {7, 4}, {8, 8}, {15, 8}, {16, 16}};
    for (int i = 0; i < 8; i++) {
        start(counts[i][0]);
        TEST_ASSERT_EQUAL_UINT32(counts[i][1] - 1, cache.mask);
    }
}

/* A vertex is worked out once: what was written into its entry stays. */
void test_a_vertex_is_worked_out_when_it_is_asked_for(void)
{
    start(ENTRIES);
    fxl_model_view model_view = place(0, FXL_PLANES_ALL);
    fxl_cached_vertex before = entries[4];
    fxl_fetch_vertex(&model_view, 3)->position.x = 12345;
    TEST_ASSERT_EQUAL_INT64(12345, fxl_fetch_vertex(&model_view, 3)->position.x);
    TEST_ASSERT_EQUAL_MEMORY(&before, &entries[4], sizeof before);
    (void)fxl_fetch_vertex(&model_view, 3 + ENTRIES);
    expect_seen(&model_view, 0, 3);
}

void test_what_was_seen_of_another_object_is_stale(void)
{
    start(ENTRIES);
    fxl_model_view first = place(0, FXL_PLANES_ALL);
    expect_seen(&first, 0, 5);
    fxl_model_view second = place(1, FXL_PLANES_ALL);
    expect_seen(&second, 1, 5);
    /* The same object in another view. */
    fxl_pose pose = unit_pose();
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    fxl_model_view third = place(1, 0);
    expect_seen(&third, 1, 5);
}

/* After 65535 objects their count begins anew; what the first of all left in the
 * cache must not be taken for what the first anew asks for. */
/* SPEC 4.10b */
void test_the_count_of_objects_begins_anew(void)
{
    start(ENTRIES);
    fxl_model_view model_view = place(0, FXL_PLANES_ALL);
    const uint32_t first_tag = model_view.tag;
    expect_seen(&model_view, 0, 7);
    for (uint32_t i = 1; i < 65535; i++) {
        model_view = place(1, FXL_PLANES_ALL);
    }
    model_view = place(1, FXL_PLANES_ALL);
    TEST_ASSERT_EQUAL_HEX32(first_tag, model_view.tag);
    expect_seen(&model_view, 1, 7);
}

void test_a_cache_knows_nothing_of_another(void)
{
    static fxl_cached_vertex others[ENTRIES];
    fxl_vertex_cache other;
    start(ENTRIES);
    fxl_vertex_cache_init(&other, others, ENTRIES);
    fxl_model_view a = place(0, FXL_PLANES_ALL), b;
    fxl_model_view_of_instance(&b, &scene, &instances[1], &view, &other);
    TEST_ASSERT_EQUAL_HEX32(a.tag, b.tag);
    for (uint32_t i = 0; i < VERTICES; i++) {
        expect_seen(&a, 0, i);
        fxl_cached_vertex *seen = fxl_fetch_vertex(&b, i);
        TEST_ASSERT_EQUAL_PTR(&others[i % ENTRIES], seen);
    }
}

/* A polygon of any size has its vertices in turn: each index is its own place. */
void test_a_polygon_has_its_points_in_turn(void)
{
    fxl_model_view model_view;
    start(ENTRIES);
    fxl_model_view_of_polygon(&model_view, vertices, &view, &cache);
    TEST_ASSERT_EQUAL_PTR(vertices, model_view.vertices);
    for (uint32_t i = 0; i < FXL_POLYGON_CAPACITY; i++) {
        TEST_ASSERT_EQUAL(i, model_view.indices[i]);
    }
    TEST_ASSERT_EQUAL_INT32(-view.camera.position.x, model_view.offset.x);
    TEST_ASSERT_EQUAL_INT32(-view.camera.position.y, model_view.offset.y);
    TEST_ASSERT_EQUAL_INT32(-view.camera.position.z, model_view.offset.z);
    TEST_ASSERT_NULL(model_view.shader);
}
