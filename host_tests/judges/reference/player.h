/* SPDX-License-Identifier: MIT */
/* The movement of a player (docs/extras/player.md), in double. */
#ifndef REF_PLAYER_H
#define REF_PLAYER_H

#include "reference/record.h"

enum {
    REF_KEY_FORWARD = 1,
    REF_KEY_BACK = 2,
    REF_KEY_LEFT = 4,
    REF_KEY_RIGHT = 8,
    REF_KEY_PITCH_UP = 16,
    REF_KEY_PITCH_DOWN = 32,
    REF_KEY_ROLL_LEFT = 64,
    REF_KEY_ROLL_RIGHT = 128
};

/* Limits per step: world units, and an angle. */
typedef struct {
    double acceleration, friction, speed_max;
    ref_angle turn;
} ref_motion_limits;

/* A player. The position is never rounded: the judge compares the library's positions with it. */
typedef struct {
    ref_point position;
    ref_angle yaw, pitch, roll;
    double speed;
    uint32_t clamped; /* steps in which the position was clamped to the range */
} ref_player;

ref_player ref_player_at(const ref_pose *pose);
void ref_player_step(ref_player *player, uint32_t keys, const ref_motion_limits *limits);

#endif
