/* SPDX-License-Identifier: MIT */
#include "reference/player.h"

#include <math.h>

#include "reference/camera.h"

ref_player ref_player_at(const ref_pose *pose)
{
    return (ref_player){.position = ref_point_from_lattice(&pose->position),
                        .yaw = pose->yaw,
                        .pitch = pose->pitch,
                        .roll = pose->roll};
}

static int pressed(uint32_t keys, uint32_t plus, uint32_t minus)
{
    return ((keys & plus) != 0) - ((keys & minus) != 0);
}

static ref_angle turned(ref_angle angle, int direction, ref_angle by)
{
    return direction > 0 ? angle + by : direction < 0 ? angle - by : angle;
}

static double held(double value, double limit)
{
    return fmax(-limit, fmin(limit, value));
}

void ref_player_step(ref_player *viewer, uint32_t keys, const ref_motion_limits *motion_limits)
{
    viewer->yaw =
        turned(viewer->yaw, pressed(keys, REF_KEY_RIGHT, REF_KEY_LEFT), motion_limits->turn);
    viewer->pitch = turned(viewer->pitch, pressed(keys, REF_KEY_PITCH_UP, REF_KEY_PITCH_DOWN),
                           motion_limits->turn);
    viewer->roll = turned(viewer->roll, pressed(keys, REF_KEY_ROLL_LEFT, REF_KEY_ROLL_RIGHT),
                          motion_limits->turn);

    double push = motion_limits->acceleration * pressed(keys, REF_KEY_FORWARD, REF_KEY_BACK);
    viewer->speed = held(viewer->speed + push, motion_limits->speed_max);

    ref_point forward = ref_forward(viewer->yaw, viewer->pitch);
    double x = viewer->position.x + forward.x * viewer->speed;
    double z = viewer->position.z + forward.z * viewer->speed;
    viewer->position.x = held(x, REF_COORDINATE_MAX);
    viewer->position.z = held(z, REF_COORDINATE_MAX);
    viewer->clamped += viewer->position.x != x || viewer->position.z != z;

    viewer->speed = copysign(fmax(fabs(viewer->speed) - motion_limits->friction, 0), viewer->speed);
}
