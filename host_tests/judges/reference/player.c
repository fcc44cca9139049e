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

void ref_player_step(ref_player *player, uint32_t keys, const ref_motion_limits *limits)
{
    player->yaw = turned(player->yaw, pressed(keys, REF_KEY_RIGHT, REF_KEY_LEFT), limits->turn);
    player->pitch =
        turned(player->pitch, pressed(keys, REF_KEY_PITCH_UP, REF_KEY_PITCH_DOWN), limits->turn);
    player->roll =
        turned(player->roll, pressed(keys, REF_KEY_ROLL_LEFT, REF_KEY_ROLL_RIGHT), limits->turn);

    double push = limits->acceleration * pressed(keys, REF_KEY_FORWARD, REF_KEY_BACK);
    player->speed = held(player->speed + push, limits->speed_max);

    ref_point forward = ref_forward(player->yaw, player->pitch);
    double x = player->position.x + forward.x * player->speed;
    double z = player->position.z + forward.z * player->speed;
    player->position.x = held(x, REF_COORDINATE_MAX);
    player->position.z = held(z, REF_COORDINATE_MAX);
    player->clamped += player->position.x != x || player->position.z != z;

    player->speed = copysign(fmax(fabs(player->speed) - limits->friction, 0), player->speed);
}
