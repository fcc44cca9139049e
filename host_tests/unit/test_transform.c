/* SPDX-License-Identifier: MIT */
#include "unit.h"

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

/* SPEC 4.6 */
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

/* SPEC 2.1 */
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
/* SPEC 4.6 */
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
/* SPEC 3.3, 4.6, clippers 1.4 */
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
}

void test_a_polygon_is_its_points(void)
{
    fxl_pose pose = unit_pose();
    fxl_camera camera = camera_at(&pose);
    fxl_polygon polygon = {.colour = 77, .count = FXL_POLYGON_CAPACITY};
    for (int i = 0; i < polygon.count; i++) {
        polygon.vertices[i].position = unit_point(FXL_COORDINATE_MAX);
    }
    static fxl_view_polygon view;
    fxl_transform_polygon(&camera, &polygon, &view);
    TEST_ASSERT_EQUAL(77, view.colour);
    TEST_ASSERT_EQUAL(FXL_POLYGON_CAPACITY, view.count);
    for (int i = 0; i < view.count; i++) {
        fxl_view_point point;
        fxl_transform_point(&camera, &polygon.vertices[i].position, &point);
        TEST_ASSERT_EQUAL_MEMORY(&point, &view.vertices[i].position, sizeof point);
    }
}
