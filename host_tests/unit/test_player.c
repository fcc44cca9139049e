/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "unit.h"

static const fxl_motion_limits motion_limits = {Q16(0.5), Q16(0.25), Q16(2), FXL_ANGLE_QUARTER};

static bool step(fxl_player *viewer, uint32_t keys)
{
    bool clamped = false;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_player_step(viewer, keys, &motion_limits, &clamped));
    return clamped;
}

/* formats 1.3 */
void test_forward_speeds_up_moves_and_rubs(void)
{
    fxl_player viewer = {0};
    TEST_ASSERT_FALSE(step(&viewer, FXL_KEY_FORWARD));
    TEST_ASSERT_EQUAL_INT32(Q16(0.5), viewer.pose.position.z);
    TEST_ASSERT_EQUAL_INT32(Q16(0.25), viewer.speed);
    step(&viewer, FXL_KEY_FORWARD);
    TEST_ASSERT_EQUAL_INT32(Q16(1.25), viewer.pose.position.z);
    TEST_ASSERT_EQUAL_INT32(Q16(0.5), viewer.speed);
    TEST_ASSERT_EQUAL_INT32(0, viewer.pose.position.x | viewer.pose.position.y);
}

void test_friction_stops_and_does_not_turn_back(void)
{
    fxl_player viewer = {.speed = Q16(0.3)};
    step(&viewer, 0);
    TEST_ASSERT_EQUAL_INT32(Q16(0.3) - Q16(0.25), viewer.speed);
    step(&viewer, 0);
    TEST_ASSERT_EQUAL_INT32(0, viewer.speed);
    step(&viewer, 0);
    TEST_ASSERT_EQUAL_INT32(0, viewer.speed);
    TEST_ASSERT_EQUAL_INT32(Q16(0.3) + Q16(0.3) - Q16(0.25), viewer.pose.position.z);
    viewer.speed = Q16(-0.3);
    step(&viewer, 0);
    TEST_ASSERT_EQUAL_INT32(Q16(0.25) - Q16(0.3), viewer.speed);
    step(&viewer, 0);
    TEST_ASSERT_EQUAL_INT32(0, viewer.speed);
}

void test_speed_is_held_both_ways(void)
{
    fxl_player viewer = {.speed = Q16(1.9)};
    step(&viewer, FXL_KEY_FORWARD);
    TEST_ASSERT_EQUAL_INT32(Q16(2), viewer.pose.position.z);
    TEST_ASSERT_EQUAL_INT32(Q16(1.75), viewer.speed);
    viewer = (fxl_player){.speed = Q16(-1.9)};
    step(&viewer, FXL_KEY_BACK);
    TEST_ASSERT_EQUAL_INT32(Q16(-2), viewer.pose.position.z);
    TEST_ASSERT_EQUAL_INT32(Q16(-1.75), viewer.speed);
}

void test_turning_wraps(void)
{
    fxl_player viewer = {0};
    for (int i = 0; i < 4; i++) {
        step(&viewer, FXL_KEY_RIGHT | FXL_KEY_PITCH_UP | FXL_KEY_ROLL_LEFT);
    }
    TEST_ASSERT_EQUAL_HEX32(0, viewer.pose.yaw | viewer.pose.pitch | viewer.pose.roll);
    step(&viewer, FXL_KEY_LEFT | FXL_KEY_PITCH_DOWN | FXL_KEY_ROLL_RIGHT);
    TEST_ASSERT_EQUAL_HEX32(0xC0000000u, viewer.pose.yaw);
    TEST_ASSERT_EQUAL_HEX32(0xC0000000u, viewer.pose.pitch);
    TEST_ASSERT_EQUAL_HEX32(0xC0000000u, viewer.pose.roll);
}

/* formats 1.3 */
void test_each_key_turns_its_own_angle(void)
{
    fxl_player viewer = {0};
    step(&viewer, FXL_KEY_RIGHT);
    TEST_ASSERT_EQUAL_HEX32(FXL_ANGLE_QUARTER, viewer.pose.yaw);
    step(&viewer, FXL_KEY_PITCH_UP);
    TEST_ASSERT_EQUAL_HEX32(FXL_ANGLE_QUARTER, viewer.pose.pitch);
    step(&viewer, FXL_KEY_ROLL_LEFT);
    TEST_ASSERT_EQUAL_HEX32(FXL_ANGLE_QUARTER, viewer.pose.roll);
    TEST_ASSERT_EQUAL_HEX32(FXL_ANGLE_QUARTER, viewer.pose.yaw);
}

/* formats 1.3 */
void test_keys_of_a_pair_cancel(void)
{
    fxl_player viewer = {.pose = {{1, 2, 3}, 4, 5, 6}}, before = viewer;
    step(&viewer, FXL_KEY_ALL);
    TEST_ASSERT_EQUAL_MEMORY(&before, &viewer, sizeof before);
}

void test_the_new_direction_counts(void)
{
    fxl_player viewer = {0};
    step(&viewer, FXL_KEY_FORWARD | FXL_KEY_RIGHT);
    TEST_ASSERT_EQUAL_INT32(Q16(0.5), viewer.pose.position.x);
    TEST_ASSERT_EQUAL_INT32(0, viewer.pose.position.z);
}

void test_looking_up_is_slower_and_stays_on_the_ground(void)
{
    fxl_player viewer = {.pose.pitch = DEGREES(60), .pose.position.y = Q16(7)};
    step(&viewer, FXL_KEY_FORWARD);
    TEST_ASSERT_INT32_WITHIN(1, Q16(0.25), viewer.pose.position.z);
    TEST_ASSERT_EQUAL_INT32(Q16(7), viewer.pose.position.y);
}

void test_the_end_of_the_world_is_reported_and_counted(void)
{
    fxl_player viewer = {.pose.position.z = FXL_COORDINATE_MAX - Q16(0.5)};
    TEST_ASSERT_FALSE(step(&viewer, FXL_KEY_FORWARD));
    TEST_ASSERT_EQUAL_INT32(FXL_COORDINATE_MAX, viewer.pose.position.z);
    TEST_ASSERT_TRUE(step(&viewer, FXL_KEY_FORWARD));
    TEST_ASSERT_TRUE(step(&viewer, FXL_KEY_FORWARD));
    TEST_ASSERT_EQUAL_INT32(FXL_COORDINATE_MAX, viewer.pose.position.z);
    TEST_ASSERT_EQUAL_UINT32(2, viewer.clamped);
    viewer = (fxl_player){.pose.position = {-FXL_COORDINATE_MAX, 0, 0}, .speed = Q16(-1)};
    viewer.pose.yaw = FXL_ANGLE_QUARTER;
    TEST_ASSERT_TRUE(step(&viewer, 0));
    TEST_ASSERT_EQUAL_INT32(-FXL_COORDINATE_MAX, viewer.pose.position.x);
}

/* Both coordinates held in one step are one step. */
void test_a_corner_counts_once(void)
{
    fxl_player viewer = {.pose.position = {FXL_COORDINATE_MAX, 0, FXL_COORDINATE_MAX},
                         .pose.yaw = FXL_ANGLE_QUARTER / 2,
                         .speed = Q16(1)};
    TEST_ASSERT_TRUE(step(&viewer, 0));
    TEST_ASSERT_EQUAL_UINT32(1, viewer.clamped);
}

void test_clamped_may_be_null(void)
{
    fxl_player viewer = {.pose.position.z = FXL_COORDINATE_MAX, .speed = Q16(1)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_player_step(&viewer, 0, &motion_limits, NULL));
    TEST_ASSERT_EQUAL_UINT32(1, viewer.clamped);
}

/* fxl_cos and the rows of the camera are measured elsewhere; here the move is
 * taken from the angles themselves. */
/* accuracy 1.2k */
void test_a_step_is_within_its_bound(void)
{
    const double turn = 3.14159265358979323846 / 2147483648.0;
    for (int i = 0; i < UNIT_REPEAT; i++) {
        fxl_player viewer = {.speed = unit_between(-FXL_MOTION_MAX, FXL_MOTION_MAX)};
        fxl_motion_limits fast = {0, 0, FXL_MOTION_MAX, 0};
        viewer.pose = unit_pose();
        viewer.pose.position = unit_point(Q16(7000));
        fxl_player before = viewer;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_player_step(&viewer, 0, &fast, NULL));
        double x = cos(before.pose.pitch * turn) * sin(before.pose.yaw * turn) * before.speed;
        double z = cos(before.pose.pitch * turn) * cos(before.pose.yaw * turn) * before.speed;
        double bound = 0.51 + fabs((double)before.speed) / 536870912.0;
        TEST_ASSERT_NEAR(viewer.pose.position.x - before.pose.position.x, x, bound);
        TEST_ASSERT_NEAR(viewer.pose.position.z - before.pose.position.z, z, bound);
        TEST_ASSERT_EQUAL_INT32(before.speed, viewer.speed);
    }
}

static void expect_refused(fxl_status status, fxl_player viewer, uint32_t keys,
                           fxl_motion_limits with)
{
    fxl_player before = viewer;
    bool clamped = false;
    TEST_ASSERT_EQUAL(status, fxl_player_step(&viewer, keys, &with, &clamped));
    TEST_ASSERT_EQUAL_MEMORY(&before, &viewer, sizeof before);
}

void test_what_is_out_of_range_is_refused(void)
{
    const fxl_motion_limits top = {FXL_MOTION_MAX, FXL_MOTION_MAX, FXL_MOTION_MAX,
                                   FXL_ANGLE_QUARTER};
    fxl_player viewer = {.speed = Q16(1)};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_player_step(&(fxl_player){0}, 0, &top, NULL));
    TEST_ASSERT_EQUAL(FXL_OK, fxl_player_step(&(fxl_player){0}, 0, &(fxl_motion_limits){0}, NULL));
    expect_refused(FXL_E_RANGE, viewer, 0x100, motion_limits);
    for (int member = 0; member < 4; member++) {
        fxl_motion_limits low = top, high = top;
        fxl_q16_16 *const lows[] = {&low.acceleration, &low.friction, &low.speed_max};
        fxl_q16_16 *const highs[] = {&high.acceleration, &high.friction, &high.speed_max};
        if (member < 3) {
            *lows[member] = -1;
            *highs[member] = FXL_MOTION_MAX + 1;
            expect_refused(FXL_E_RANGE, viewer, 0, low);
        } else {
            high.turn = FXL_ANGLE_QUARTER + 1;
        }
        expect_refused(FXL_E_RANGE, viewer, 0, high);
    }
    viewer.speed = FXL_MOTION_MAX + 1;
    expect_refused(FXL_E_RANGE, viewer, 0, top);
    viewer.speed = 0;
    viewer.pose.position.y = -FXL_COORDINATE_MAX - 1;
    expect_refused(FXL_E_RANGE, viewer, 0, top);
}

void test_null_is_refused(void)
{
    fxl_player viewer = {0};
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_player_step(NULL, 0, &motion_limits, NULL));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_player_step(&viewer, 0, NULL, NULL));
}

/* --- flying, factors, looking at ---------------------------------------------------------- */

/* accuracy 1.2k */
void test_a_flight_goes_where_the_view_goes(void)
{
    const double turn = 3.14159265358979323846 / 2147483648.0;
    const fxl_motion_limits fast = {0, 0, FXL_MOTION_MAX, 0};
    for (int i = 0; i < UNIT_REPEAT / 4; i++) {
        fxl_player viewer = {.speed = unit_between(-FXL_MOTION_MAX, FXL_MOTION_MAX)};
        viewer.pose = unit_pose();
        viewer.pose.position = unit_point(Q16(7000));
        fxl_player walker = viewer;
        const fxl_player before = viewer;
        TEST_ASSERT_EQUAL(FXL_OK, fxl_player_fly(&viewer, 0, &fast, NULL));
        TEST_ASSERT_EQUAL(FXL_OK, fxl_player_step(&walker, 0, &fast, NULL));
        const double y = sin(before.pose.pitch * turn) * before.speed;
        TEST_ASSERT_NEAR(viewer.pose.position.y - before.pose.position.y, y,
                         0.51 + fabs((double)before.speed) / 536870912.0);
        walker.pose.position.y = viewer.pose.position.y;
        TEST_ASSERT_EQUAL_MEMORY(&walker, &viewer, sizeof walker);
    }
    fxl_player up = {.pose.position.y = FXL_COORDINATE_MAX, .speed = Q16(1)};
    up.pose.pitch = FXL_ANGLE_QUARTER;
    bool clamped = false;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_player_fly(&up, 0, &fast, &clamped));
    TEST_ASSERT_TRUE(clamped && up.clamped == 1);
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_player_fly(NULL, 0, &fast, NULL));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_player_fly(&up, 0x100, &fast, NULL));
}

void test_a_factor_scales_speeds_and_no_turn(void)
{
    const fxl_motion_limits limits = {Q16(0.5), 3, Q16(2), 7};
    fxl_motion_limits scaled = limits, untouched = limits;
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scale_motion_limits(&limits, Q16(1.5), &scaled));
    TEST_ASSERT_TRUE(scaled.acceleration == Q16(0.75) && scaled.friction == 5 &&
                     scaled.speed_max == Q16(3) && scaled.turn == 7);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scale_motion_limits(&limits, Q16(128), &scaled));
    TEST_ASSERT_EQUAL_INT32(FXL_MOTION_MAX, scaled.speed_max);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_scale_motion_limits(&scaled, 0, &scaled)); /* in place */
    TEST_ASSERT_TRUE(scaled.acceleration == 0 && scaled.friction == 0 && scaled.speed_max == 0);
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_scale_motion_limits(&limits, Q16(128) + 1, &untouched));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_scale_motion_limits(&limits, -1, &untouched));
    TEST_ASSERT_EQUAL(FXL_E_RANGE,
                      fxl_scale_motion_limits(&limits, FXL_MOTION_MAX + 1, &untouched));
    const fxl_motion_limits wrong = {0, -1, 0, 0};
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_scale_motion_limits(&wrong, Q16(1), &untouched));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scale_motion_limits(NULL, Q16(1), &untouched));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_scale_motion_limits(&limits, Q16(1), NULL));
    TEST_ASSERT_EQUAL_MEMORY(&limits, &untouched, sizeof limits);
}

/* The difference of two angles, which may be on either side of 0, in units. */
static double apart(fxl_angle angle, double turns)
{
    const double difference = angle - turns * 4294967296.0;
    return fabs(difference - 4294967296.0 * floor(difference / 4294967296.0 + 0.5));
}

/* accuracy 1.2l */
void test_a_pose_looks_at_a_point(void)
{
    const double turn = 2 * 3.14159265358979323846;
    for (int i = 0; i < UNIT_REPEAT / 4; i++) {
        fxl_pose pose = unit_pose();
        fxl_point target = unit_point(FXL_COORDINATE_MAX);
        if (unit_random() % 2) { /* near: few bits */
            const fxl_point by = unit_point(1 << unit_between(1, 20));
            target.x = pose.position.x / 2 + by.x;
            target.y = pose.position.y / 2 + by.y;
            target.z = pose.position.z / 2 + by.z;
            pose.position.x /= 2;
            pose.position.y /= 2;
            pose.position.z /= 2;
        }
        const fxl_angle roll = pose.roll;
        const double x = (double)target.x - pose.position.x, y = (double)target.y - pose.position.y,
                     z = (double)target.z - pose.position.z;
        const fxl_status status = fxl_pose_look_at(&pose, &target);
        if (x == 0 && z == 0) {
            continue;
        }
        TEST_ASSERT_EQUAL(FXL_OK, status);
        TEST_ASSERT_TRUE(apart(pose.yaw, atan2(x, z) / turn) <= 0.56);
        TEST_ASSERT_TRUE(apart(pose.pitch, atan2(y, sqrt(x * x + z * z)) / turn) <= 0.75);
        TEST_ASSERT_EQUAL_HEX32(roll, pose.roll);
    }
}

void test_straight_up_and_down_keep_the_yaw(void)
{
    fxl_pose pose = {{1, 2, 3}, 4, 5, 6};
    const fxl_point above = {1, 3, 3}, below = {1, -FXL_COORDINATE_MAX, 3}, at = {1, 2, 3},
                    outside = {0, 0, FXL_COORDINATE_MAX + 1};
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pose_look_at(&pose, &above));
    TEST_ASSERT_EQUAL_HEX32(FXL_ANGLE_QUARTER, pose.pitch);
    TEST_ASSERT_EQUAL(FXL_OK, fxl_pose_look_at(&pose, &below));
    TEST_ASSERT_EQUAL_HEX32(0u - FXL_ANGLE_QUARTER, pose.pitch);
    TEST_ASSERT_TRUE(pose.yaw == 4 && pose.roll == 6);
    const fxl_pose before = pose;
    TEST_ASSERT_EQUAL(FXL_E_DEGENERATE, fxl_pose_look_at(&pose, &at));
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pose_look_at(&pose, &outside));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pose_look_at(NULL, &at));
    TEST_ASSERT_EQUAL(FXL_E_ARGUMENT, fxl_pose_look_at(&pose, NULL));
    TEST_ASSERT_EQUAL_MEMORY(&before, &pose, sizeof pose);
    pose.position.x = FXL_COORDINATE_MAX + 1;
    TEST_ASSERT_EQUAL(FXL_E_RANGE, fxl_pose_look_at(&pose, &at));
}

/* Each axis and each quarter exactly. */
void test_looking_along_the_axes_is_exact(void)
{
    static const int8_t steps[4][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
    for (uint32_t i = 0; i < 4; i++) {
        fxl_pose pose = {{0, 0, 0}, 1, 2, 3};
        const fxl_point target = {steps[i][0] * Q16(7), 0, steps[i][1] * Q16(7)};
        TEST_ASSERT_EQUAL(FXL_OK, fxl_pose_look_at(&pose, &target));
        TEST_ASSERT_EQUAL_HEX32(i * FXL_ANGLE_QUARTER, pose.yaw);
        TEST_ASSERT_EQUAL_HEX32(0, pose.pitch);
    }
}
