/* SPDX-License-Identifier: MIT */
#include "fixel/camera.h"
#include "fixel/player.h"

#include "../math/arith.h"
#include "../scene/motion_limits.h"

/* +1 for the plus key, -1 for the minus key, 0 for neither or both. */
static int32_t key_sign(uint32_t keys, uint32_t plus, uint32_t minus)
{
    return ((keys & plus) != 0) - ((keys & minus) != 0);
}

static fxl_angle turned(fxl_angle angle, int32_t sign, fxl_angle turn)
{
    return sign > 0 ? angle + turn : sign < 0 ? angle - turn : angle;
}

static fxl_q16_16 held_within(int64_t value, fxl_q16_16 limit, bool *held)
{
    if (fxl_within(value, limit)) {
        return (fxl_q16_16)value;
    }
    *held = true;
    return value < 0 ? -limit : limit;
}

/* Reduces a speed by friction, to no less than 0. */
static fxl_q16_16 slow_down(fxl_q16_16 speed, fxl_q16_16 friction)
{
    if (speed > friction) {
        return speed - friction;
    }
    return speed < -friction ? speed + friction : 0;
}

/* A step of a player who walks, or who flies. */
static fxl_status step(fxl_player *viewer, uint32_t keys, const fxl_motion_limits *limits,
                       bool *clamped, bool flies)
{
    if (viewer == NULL || limits == NULL) {
        return FXL_E_ARGUMENT;
    }
    if ((keys & ~(uint32_t)FXL_KEY_ALL) != 0 || !fxl_motion_limits_in_range(limits) ||
        !fxl_within(viewer->speed, FXL_MOTION_MAX) || !fxl_point_in_range(&viewer->pose.position)) {
        return FXL_E_RANGE;
    }
    fxl_pose *pose = &viewer->pose;
    pose->yaw = turned(pose->yaw, key_sign(keys, FXL_KEY_RIGHT, FXL_KEY_LEFT), limits->turn);
    pose->pitch =
        turned(pose->pitch, key_sign(keys, FXL_KEY_PITCH_UP, FXL_KEY_PITCH_DOWN), limits->turn);
    pose->roll =
        turned(pose->roll, key_sign(keys, FXL_KEY_ROLL_LEFT, FXL_KEY_ROLL_RIGHT), limits->turn);

    bool speed_held = false; /* the top speed is a setting, not an edge of the world, so clamping it
                                is not reported */
    int32_t speed = viewer->speed + /* both within FXL_MOTION_MAX */
                    key_sign(keys, FXL_KEY_FORWARD, FXL_KEY_BACK) * limits->acceleration;
    viewer->speed = held_within(speed, limits->speed_max, &speed_held);

    fxl_camera camera;
    fxl_status status = fxl_camera_from_pose(pose, &camera);
    FXL_ASSERT(status == FXL_OK);
    (void)status;

    /* A unit vector times at most 2^24 is below 2^55. */
    int64_t move_x = fxl_round_shift(fxl_multiply_s32(camera.axes.forward.x, viewer->speed), 30);
    int64_t move_z = fxl_round_shift(fxl_multiply_s32(camera.axes.forward.z, viewer->speed), 30);
    bool held = false;
    pose->position.x = held_within(pose->position.x + move_x, FXL_COORDINATE_MAX, &held);
    pose->position.z = held_within(pose->position.z + move_z, FXL_COORDINATE_MAX, &held);
    if (flies) {
        int64_t move_y =
            fxl_round_shift(fxl_multiply_s32(camera.axes.forward.y, viewer->speed), 30);
        pose->position.y = held_within(pose->position.y + move_y, FXL_COORDINATE_MAX, &held);
    }
    if (held) {
        viewer->clamped += 1;
    }
    if (clamped != NULL) {
        *clamped = held;
    }
    viewer->speed = slow_down(viewer->speed, limits->friction);
    return FXL_OK;
}

fxl_status fxl_player_step(fxl_player *viewer, uint32_t keys, const fxl_motion_limits *limits,
                           bool *clamped)
{
    return step(viewer, keys, limits, clamped, false);
}

fxl_status fxl_player_fly(fxl_player *viewer, uint32_t keys, const fxl_motion_limits *limits,
                          bool *clamped)
{
    return step(viewer, keys, limits, clamped, true);
}
