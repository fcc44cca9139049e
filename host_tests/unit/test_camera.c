/* SPDX-License-Identifier: MIT */
/* Cameras from poses, and lenses. */
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

/* SPEC 1.3a */
void test_yaw_turns_from_z_towards_x(void)
{
    fxl_camera camera = camera_at(origin, FXL_ANGLE_QUARTER, 0, 0);
    expect_row("forward", 1, 0, 0, camera.axes.forward);
    expect_row("right", 0, 0, -1, camera.axes.right);
    expect_row("up", 0, 1, 0, camera.axes.up);
}

/* SPEC 1.3b */
void test_pitch_raises_the_view(void)
{
    fxl_camera camera = camera_at(origin, 0, FXL_ANGLE_QUARTER, 0);
    expect_row("forward", 0, 1, 0, camera.axes.forward);
    expect_row("up", 0, 0, -1, camera.axes.up);
}

/* SPEC 1.3c */
void test_roll_turns_the_right_side_up(void)
{
    fxl_camera camera = camera_at(origin, 0, 0, FXL_ANGLE_QUARTER);
    expect_row("right", 0, 1, 0, camera.axes.right);
    expect_row("up", -1, 0, 0, camera.axes.up);
    expect_row("forward", 0, 0, 1, camera.axes.forward);
}

/* A view raised by a half right angle looks up wherever yaw has turned it;
 * pitch before yaw would look to the side. */
/* SPEC 1.3d */
void test_yaw_comes_before_pitch(void)
{
    double half = sqrt(0.5);
    fxl_camera camera = camera_at(origin, FXL_ANGLE_QUARTER, FXL_ANGLE_QUARTER / 2, 0);
    expect_row("forward", half, half, 0, camera.axes.forward);
}

/* Rolling does not change where the view looks. */
/* SPEC 1.3d */
void test_pitch_comes_before_roll(void)
{
    double half = sqrt(0.5);
    fxl_camera camera = camera_at(origin, 0, FXL_ANGLE_QUARTER / 2, FXL_ANGLE_QUARTER);
    expect_row("forward", 0, half, half, camera.axes.forward);
    expect_row("right", 0, half, -half, camera.axes.right);
}

/* SPEC 1.3e-h, 3.1e, 4.2a, accuracy 1.1c */
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

void test_a_camera_refuses_null(void)
{
    fxl_pose pose = {origin, 0, 0, 0};
    fxl_camera camera;
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_camera_from_pose(NULL, &camera));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_camera_from_pose(&pose, NULL));
}

static fxl_status try_lens(uint16_t width, uint16_t height, fxl_angle fov, fxl_q16_16 near,
                           fxl_q16_16 far, fxl_q16_16 inset)
{
    fxl_lens lens, before;
    memset(&lens, 0x5A, sizeof lens);
    memcpy(&before, &lens, sizeof before);
    fxl_status status = fxl_lens_from_fov(width, height, fov, near, far, inset, &lens);
    if (status != FXL_OK) {
        TEST_ASSERT_EQUAL_MEMORY(&before, &lens, sizeof before);
    }
    return status;
}

/* SPEC 2.1b */
void test_ninety_degrees_is_half_the_width(void)
{
    fxl_lens lens = unit_lens(320, 240);
    TEST_ASSERT_NEAR(lens.focal, Q16(160), 1);
    TEST_ASSERT_EQUAL(320, lens.width);
    TEST_ASSERT_EQUAL(240, lens.height);
    TEST_ASSERT_EQUAL_INT32(Q16(0.0625), lens.near_z);
    TEST_ASSERT_EQUAL_INT32(Q16(1000), lens.far_z);
    TEST_ASSERT_EQUAL_INT32(4, lens.inset);
}

/* SPEC 4.2b, accuracy 1.1h */
void test_focal_is_within_its_bound(void)
{
    const fxl_angle ends[] = {FXL_FOV_MIN, FXL_FOV_MAX, FXL_FOV_MIN + 1, FXL_FOV_MAX - 1};
    for (int i = 0; i < UNIT_REPEAT / 10; i++) {
        uint16_t width = (uint16_t)unit_between(1, FXL_SCREEN_MAX);
        fxl_angle fov = (fxl_angle)unit_between((int32_t)FXL_FOV_MIN, (int32_t)FXL_FOV_MAX);
        fxl_lens lens;
        if (i < 4) {
            fov = ends[i];
            width = FXL_SCREEN_MAX;
        }
        TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov(width, 1, fov, Q16(1), Q16(2), 0, &lens));
        double focal = width / 2.0 / tan(fov * (3.14159265358979323846 / 4294967296.0)) * 65536.0;
        TEST_ASSERT_NEAR(lens.focal, focal, 0.5 + focal / 268435456.0);
    }
}

/* SPEC 3.1h */
void test_the_least_and_the_largest_focal_length(void)
{
    fxl_lens lens;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov(1, 1, FXL_FOV_MAX, Q16(1), Q16(2), 0, &lens));
    TEST_ASSERT_EQUAL_INT32(8780, lens.focal);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_lens_from_fov(FXL_SCREEN_MAX, 1, FXL_FOV_MIN, Q16(1), Q16(2), 0,
                                                &lens));
    TEST_ASSERT_NEAR(lens.focal, 5852.2 * 65536, 0.05 * 65536);
}

/* SPEC 3.1f-g, 3.1i-k */
void test_the_ends_of_every_range_are_taken(void)
{
    TEST_ASSERT_EQUAL(FXL_OK, try_lens(1, 1, FXL_FOV_MIN, FXL_NEAR_MIN, FXL_FAR_MAX, 0));
    TEST_ASSERT_EQUAL(FXL_OK, try_lens(FXL_SCREEN_MAX, FXL_SCREEN_MAX, FXL_FOV_MAX, FXL_NEAR_MIN,
                                       FXL_FAR_MAX, FXL_INSET_MAX));
    TEST_ASSERT_EQUAL(FXL_OK, try_lens(1, 1, FXL_FOV_MIN, 1000, 1021, 10));
    TEST_ASSERT_EQUAL_HEX32(119304647, FXL_FOV_MIN);
    TEST_ASSERT_EQUAL_HEX32(1789569707, FXL_FOV_MAX);
    TEST_ASSERT_EQUAL_HEX32(FXL_DEGREES(10), FXL_FOV_MIN);
    TEST_ASSERT_EQUAL_HEX32(FXL_DEGREES(150), FXL_FOV_MAX);
}

/* SPEC 3.1f-g, 3.1i-k */
void test_what_is_out_of_range_is_refused(void)
{
    const fxl_angle fov = FXL_ANGLE_QUARTER;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(0, 9, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 0, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(FXL_SCREEN_MAX + 1, 9, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, FXL_SCREEN_MAX + 1, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(FXL_SCREEN_MAX + 1, 1, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(1, FXL_SCREEN_MAX + 1, fov, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, FXL_FOV_MIN - 1, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, FXL_FOV_MAX + 1, 999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, FXL_NEAR_MIN - 1, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, -999, 99999, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, 999, FXL_FAR_MAX + 1, 0));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, 999, 99999, -1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, 999, FXL_FAR_MAX, FXL_INSET_MAX + 1));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, 1000, 1020, 10));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, try_lens(9, 9, fov, INT32_MAX, 99999, FXL_INSET_MAX));
}

void test_a_lens_refuses_null(void)
{
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT,
                      fxl_lens_from_fov(9, 9, FXL_ANGLE_QUARTER, 999, 99999, 0, NULL));
    TEST_ASSERT_FALSE(fxl_lens_is_valid(NULL));
}

/* What a lens would be with one member changed. */
static bool is_valid_with(int member, int32_t value)
{
    fxl_lens lens = {.width = 320,
                     .height = 240,
                     .focal = Q16(160),
                     .near_z = Q16(1),
                     .far_z = Q16(1) + 1000,
                     .inset = 4};
    lens.width = member == 0 ? (uint16_t)value : lens.width;
    lens.height = member == 1 ? (uint16_t)value : lens.height;
    lens.focal = member == 2 ? value : lens.focal;
    lens.near_z = member == 3 ? value : lens.near_z;
    lens.far_z = member == 4 ? value : lens.far_z;
    lens.inset = member == 5 ? value : lens.inset;
    lens.centre_x = lens.width * 32768;
    lens.centre_y = lens.height * 32768;
    /* The focal length of 90 degrees is that of the width. */
    lens.focal = member == 0 ? Q16(0.5) * (lens.width > 0 ? lens.width : 1) : lens.focal;
    return fxl_lens_is_valid(&lens);
}

/* Every member has a least and a most; the focal length is measured by the width, and twice the
 * inset by the depth. */
void test_the_ends_of_a_valid_lens(void)
{
    static const struct {
        int member;
        int32_t least, most;
    } ends[] = {{0, 1, FXL_SCREEN_MAX},
                {1, 1, FXL_SCREEN_MAX},
                {2, 320 * 0x2240, 320 * 0x5B800}, /* widths times 0.1338 and 5.719 */
                {3, FXL_NEAR_MIN, Q16(1) + 1000 - 9},
                {4, Q16(1) + 9, FXL_FAR_MAX},
                {5, 0, 499}};
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        TEST_ASSERT_TRUE(is_valid_with(ends[i].member, ends[i].least));
        TEST_ASSERT_TRUE(is_valid_with(ends[i].member, ends[i].most));
        TEST_ASSERT_FALSE(is_valid_with(ends[i].member, ends[i].least - 1));
        TEST_ASSERT_FALSE(is_valid_with(ends[i].member, ends[i].most + 1));
    }
    TEST_ASSERT_FALSE(is_valid_with(2, INT32_MIN));
    TEST_ASSERT_FALSE(is_valid_with(2, INT32_MAX));
    fxl_lens lens = unit_lens(320, 240);
    lens.inset = FXL_INSET_MAX;
    TEST_ASSERT_TRUE(fxl_lens_is_valid(&lens));
    lens.inset = FXL_INSET_MAX + 1;
    TEST_ASSERT_FALSE(fxl_lens_is_valid(&lens));
}
