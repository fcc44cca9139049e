/* SPDX-License-Identifier: MIT */
#include "unit.h"

/* |difference| < 2^30 and unit vectors: below 2^61. */
static int64_t along(const fxl_direction *row, const fxl_camera *camera, const fxl_point *point)
{
    return (int64_t)row->x * (point->x - camera->position.x) +
           (int64_t)row->y * (point->y - camera->position.y) +
           (int64_t)row->z * (point->z - camera->position.z);
}

static uint32_t size_of(int32_t mantissa)
{
    return mantissa < 0 ? 0u - (uint32_t)mantissa : (uint32_t)mantissa;
}

/* Half a unit of the mantissa, where it was shifted down; none otherwise. */
static void expect_coordinate(int64_t exact, int32_t mantissa, int exponent)
{
    if (exponent <= 0) {
        TEST_ASSERT_EQUAL_INT64(mantissa, exact * ((int64_t)1 << -exponent));
        return;
    }
    int64_t unit = (int64_t)1 << exponent;
    int64_t error = mantissa * unit - exact;
    TEST_ASSERT_TRUE(2 * error <= unit && -2 * error <= unit);
}

static void expect_view(const fxl_camera *camera, const fxl_point *point)
{
    fxl_view_point view;
    fxl_transform_point(camera, point, &view);
    int64_t x = along(&camera->right, camera, point);
    int64_t y = along(&camera->up, camera, point);
    int64_t z = along(&camera->forward, camera, point);
    expect_coordinate(x, view.x, view.exponent);
    expect_coordinate(y, view.y, view.exponent);
    expect_coordinate(z, view.z, view.exponent);
    if ((x | y | z) != 0) {
        uint32_t largest = size_of(view.x) | size_of(view.y) | size_of(view.z);
        TEST_ASSERT_TRUE_MESSAGE(largest >> 30 == 1, "the largest does not use 31 bits");
    }
}

void test_any_point_from_anywhere(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_pose pose = unit_pose();
        fxl_camera camera;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
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
        fxl_camera camera;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
        fxl_point step = unit_point(1 << (unit_random() % 20));
        fxl_point point = {pose.position.x + step.x, pose.position.y + step.y,
                           pose.position.z + step.z};
        expect_view(&camera, &point);
    }
}

/* 2^59 - 1: to 31 bits it rounds up to a number of 32, and takes a bit less. */
void test_rounding_up_to_another_bit(void)
{
    const fxl_direction slanted = {FXL_Q2_30_ONE - 1, 1, 0}, none = {0, 0, 0};
    const fxl_direction opposite = {1 - FXL_Q2_30_ONE, -1, 0};
    fxl_camera camera = {{Q16(-4096), Q16(-4096), 0}, slanted, opposite, none};
    fxl_point point = {Q16(4096), Q16(4096) - 1, 0};
    fxl_view_point view;
    fxl_transform_point(&camera, &point, &view);
    TEST_ASSERT_EQUAL_INT32(1 << 30, view.x);
    TEST_ASSERT_EQUAL_INT32(-(1 << 30), view.y);
    TEST_ASSERT_EQUAL(29, view.exponent);
}

void test_the_eye_itself_is_nowhere(void)
{
    fxl_pose pose = unit_pose();
    fxl_camera camera;
    fxl_view_point view;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
    fxl_transform_point(&camera, &pose.position, &view);
    TEST_ASSERT_EQUAL_INT32(0, view.x | view.y | view.z);
}

void test_opposite_corners_of_the_world(void)
{
    const fxl_q16_16 end = FXL_COORDINATE_MAX;
    for (int corner = 0; corner < 8; corner++) {
        fxl_point eye = {corner & 1 ? end : -end, corner & 2 ? end : -end, corner & 4 ? end : -end};
        fxl_point point = {-eye.x, -eye.y, -eye.z};
        fxl_pose pose = {eye, FXL_ANGLE_QUARTER / 2, 420000000u, FXL_ANGLE_QUARTER};
        fxl_camera camera;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
        expect_view(&camera, &point);
    }
}

void test_a_polygon_is_its_points(void)
{
    fxl_pose pose = unit_pose();
    fxl_camera camera;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
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
        TEST_ASSERT_EQUAL_INT32(point.x, view.points[i].x);
        TEST_ASSERT_EQUAL_INT32(point.y, view.points[i].y);
        TEST_ASSERT_EQUAL_INT32(point.z, view.points[i].z);
        TEST_ASSERT_EQUAL(point.exponent, view.points[i].exponent);
    }
}
