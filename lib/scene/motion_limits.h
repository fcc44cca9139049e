/* SPDX-License-Identifier: MIT */
/* The range of a player's motion limits, for fxl_scene_open and for the player. Internal. */
#ifndef FXL_MOTION_LIMITS_H
#define FXL_MOTION_LIMITS_H

#include "fixel/scene.h"

static inline bool fxl_motion_limits_in_range(const fxl_motion_limits *limits)
{
    return limits->acceleration >= 0 && limits->acceleration <= FXL_MOTION_MAX &&
           limits->friction >= 0 && limits->friction <= FXL_MOTION_MAX && limits->speed_max >= 0 &&
           limits->speed_max <= FXL_MOTION_MAX && limits->turn <= FXL_ANGLE_QUARTER;
}

#endif
