/* SPDX-License-Identifier: MIT */
#include "fixel/viewer.h"

#include "arith.h"
#include "fixel/camera.h"

static bool gait_in_range(const fxl_gait *gait)
{
    return gait->acceleration >= 0 && gait->acceleration <= FXL_GAIT_MAX && gait->friction >= 0 &&
           gait->friction <= FXL_GAIT_MAX && gait->speed_max >= 0 &&
           gait->speed_max <= FXL_GAIT_MAX && gait->turn <= FXL_ANGLE_QUARTER;
}

/* +1, 0 or -1: a key, or its opposite, or neither or both. */
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

/* Takes friction off a speed, to no less than 0. */
static fxl_q16_16 slowed(fxl_q16_16 speed, fxl_q16_16 friction)
{
    if (speed > friction) {
        return speed - friction;
    }
    return speed < -friction ? speed + friction : 0;
}

fxl_status fxl_viewer_step(fxl_viewer *viewer, uint32_t keys, const fxl_gait *gait, bool *clamped)
{
    if (viewer == NULL || gait == NULL) {
        return FXL_E_ARGUMENT;
    }
    if ((keys & ~(uint32_t)FXL_KEY_ALL) != 0 || !gait_in_range(gait) ||
        !fxl_within(viewer->speed, FXL_GAIT_MAX) || !fxl_point_in_range(&viewer->pose.position)) {
        return FXL_E_RANGE;
    }
    fxl_pose *pose = &viewer->pose;
    pose->yaw = turned(pose->yaw, key_sign(keys, FXL_KEY_RIGHT, FXL_KEY_LEFT), gait->turn);
    pose->pitch =
        turned(pose->pitch, key_sign(keys, FXL_KEY_PITCH_UP, FXL_KEY_PITCH_DOWN), gait->turn);
    pose->roll =
        turned(pose->roll, key_sign(keys, FXL_KEY_ROLL_LEFT, FXL_KEY_ROLL_RIGHT), gait->turn);

    bool speed_held = false;        /* the top speed is a setting, not a boundary of the world */
    int32_t speed = viewer->speed + /* both within FXL_GAIT_MAX */
                    key_sign(keys, FXL_KEY_FORWARD, FXL_KEY_BACK) * gait->acceleration;
    viewer->speed = held_within(speed, gait->speed_max, &speed_held);

    fxl_camera camera;
    fxl_status status = fxl_camera_from_pose(pose, &camera);
    FXL_ASSERT(status == FXL_OK);
    (void)status;

    /* A unit vector times at most 2^24 is below 2^55. */
    int64_t move_x = fxl_round_shift(fxl_multiply_s32(camera.forward.x, viewer->speed), 30);
    /* bug: viewer-cut */
    int64_t move_z = fxl_round_shift(fxl_multiply_s32(camera.forward.z, viewer->speed), 30);
    bool held = false;
    pose->position.x = held_within(pose->position.x + move_x, FXL_COORDINATE_MAX, &held);
    pose->position.z = held_within(pose->position.z + move_z, FXL_COORDINATE_MAX, &held);
    if (held) {
        viewer->clamped += 1;
    }
    if (clamped != NULL) {
        *clamped = held;
    }
    viewer->speed = slowed(viewer->speed, gait->friction);
    return FXL_OK;
}
