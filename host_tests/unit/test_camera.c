/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "unit.h"

static const fxl_point origin = {0, 0, 0};

static fxl_camera camera_at(fxl_point position, fxl_angle yaw, fxl_angle pitch, fxl_angle roll)
{
    fxl_pose pose = {position, yaw, pitch, roll};
    fxl_camera camera;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
    return camera;
}

static void expect_row(const char *row, double x, double y, double z, fxl_direction actual)
{
    const double unit = FXL_Q2_30_ONE;
    TEST_ASSERT_TRUE_MESSAGE(unit_near(actual.x, x * unit, 2.0) &&
                                 unit_near(actual.y, y * unit, 2.0) &&
                                 unit_near(actual.z, z * unit, 2.0),
                             row);
}

void test_unturned_it_looks_along_z(void)
{
    fxl_camera camera = camera_at(origin, 0, 0, 0);
    TEST_ASSERT_EQUAL_INT32(FXL_Q2_30_ONE, camera.axes.right.x);
    TEST_ASSERT_EQUAL_INT32(FXL_Q2_30_ONE, camera.axes.up.y);
    TEST_ASSERT_EQUAL_INT32(FXL_Q2_30_ONE, camera.axes.forward.z);
    TEST_ASSERT_EQUAL_INT32(0, camera.axes.right.y | camera.axes.right.z | camera.axes.up.x |
                                   camera.axes.up.z | camera.axes.forward.x |
                                   camera.axes.forward.y);
}

/* SPEC 1.3 */
void test_yaw_turns_from_z_towards_x(void)
{
    fxl_camera camera = camera_at(origin, FXL_ANGLE_QUARTER, 0, 0);
    expect_row("forward", 1, 0, 0, camera.axes.forward);
    expect_row("right", 0, 0, -1, camera.axes.right);
    expect_row("up", 0, 1, 0, camera.axes.up);
}

/* SPEC 1.3 */
void test_pitch_raises_the_view(void)
{
    fxl_camera camera = camera_at(origin, 0, FXL_ANGLE_QUARTER, 0);
    expect_row("forward", 0, 1, 0, camera.axes.forward);
    expect_row("up", 0, 0, -1, camera.axes.up);
}

/* SPEC 1.3 */
void test_roll_turns_the_right_side_up(void)
{
    fxl_camera camera = camera_at(origin, 0, 0, FXL_ANGLE_QUARTER);
    expect_row("right", 0, 1, 0, camera.axes.right);
    expect_row("up", -1, 0, 0, camera.axes.up);
    expect_row("forward", 0, 0, 1, camera.axes.forward);
}

/* A view raised by a half right angle looks up wherever yaw has turned it;
 * pitch before yaw would look to the side. */
/* SPEC 1.3 */
void test_yaw_comes_before_pitch(void)
{
    double half = sqrt(0.5);
    fxl_camera camera = camera_at(origin, FXL_ANGLE_QUARTER, FXL_ANGLE_QUARTER / 2, 0);
    expect_row("forward", half, half, 0, camera.axes.forward);
}

/* Rolling does not change where the view looks. */
/* SPEC 1.3 */
void test_pitch_comes_before_roll(void)
{
    double half = sqrt(0.5);
    fxl_camera camera = camera_at(origin, 0, FXL_ANGLE_QUARTER / 2, FXL_ANGLE_QUARTER);
    expect_row("forward", 0, half, half, camera.axes.forward);
    expect_row("right", 0, half, -half, camera.axes.right);
}

/* SPEC 4.2, accuracy 1.1 */
void test_every_entry_is_within_two_units(void)
{
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_pose pose = unit_pose();
        double turn = 3.14159265358979323846 / 2147483648.0;
        double sy = sin(pose.yaw * turn), cy = cos(pose.yaw * turn);
        double sp = sin(pose.pitch * turn), cp = cos(pose.pitch * turn);
        double sr = sin(pose.roll * turn), cr = cos(pose.roll * turn);
        fxl_camera camera = camera_at(pose.position, pose.yaw, pose.pitch, pose.roll);
        expect_row("right", cr * cy - sr * sp * sy, sr * cp, -cr * sy - sr * sp * cy,
                   camera.axes.right);
        expect_row("up", -sr * cy - cr * sp * sy, cr * cp, sr * sy - cr * sp * cy, camera.axes.up);
        expect_row("forward", cp * sy, sp, cp * cy, camera.axes.forward);
        TEST_ASSERT_EQUAL_MEMORY(&pose.position, &camera.position, sizeof pose.position);
    }
}

/* A view's frames have numbers one after the other. 0 is the number of none: after 2^32 - 1 comes
 * 1. A pose that is refused begins no frame. */
void test_frames_are_numbered_from_one(void)
{
    const fxl_lens lens = unit_lens(48, 32);
    fxl_pose pose = {origin, 1, 2, 3};
    fxl_view view;
    fxl_view_set_lens(&view, &lens);
    TEST_ASSERT_EQUAL_UINT32(0, view.frame);
    for (uint32_t frame = 1; frame < 4; frame++) {
        TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
        TEST_ASSERT_EQUAL_UINT32(frame, view.frame);
    }
    view.frame = UINT32_MAX;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_view_set_pose(&view, &pose));
    TEST_ASSERT_EQUAL_UINT32(1, view.frame);
    pose.position.y = FXL_COORDINATE_MAX + 1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_view_set_pose(&view, &pose));
    TEST_ASSERT_EQUAL_UINT32(1, view.frame);
}

void test_a_position_out_of_range_is_refused(void)
{
    for (int axis = 0; axis < 3; axis++) {
        for (int side = -1; side <= 1; side += 2) {
            fxl_q16_16 at[3] = {0, 0, 0};
            at[axis] = side * (FXL_COORDINATE_MAX + 1);
            fxl_pose pose = {{at[0], at[1], at[2]}, 1, 2, 3};
            fxl_camera camera, before;
            memset(&camera, 0x5A, sizeof camera);
            memcpy(&before, &camera, sizeof before);
            TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_camera_from_pose(&pose, &camera));
            TEST_ASSERT_EQUAL_MEMORY(&before, &camera, sizeof before);
            at[axis] = side * FXL_COORDINATE_MAX;
            pose.position = (fxl_point){at[0], at[1], at[2]};
            TEST_ASSERT_EQUAL(FXL_OK, fxl_camera_from_pose(&pose, &camera));
        }
    }
}

void test_null_is_refused(void)
{
    fxl_pose pose = {origin, 0, 0, 0};
    fxl_camera camera;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_camera_from_pose(NULL, &camera));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_camera_from_pose(&pose, NULL));
}
