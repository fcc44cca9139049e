/* SPDX-License-Identifier: MIT */
#include "tiny_poses.h"

/* Turned so far to the side at the most, and 30 degrees up or down. */
static void turn_ahead(fxl_pose *pose, int32_t degrees)
{
    pose->yaw = DEGREES(1) * (fxl_angle)unit_between(-degrees, degrees);
    pose->pitch = DEGREES(1) * (fxl_angle)unit_between(-30, 30);
}

fxl_pose tiny_pose_between(void)
{
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(3));
    pose.position.z += Q16(5) * unit_between(0, 2);
    return pose;
}

fxl_pose tiny_pose_about(void)
{
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(3));
    pose.position.z += Q16(5) * unit_between(-1, 1);
    turn_ahead(&pose, 60);
    return pose;
}

fxl_pose tiny_pose_before(void)
{
    fxl_pose pose = unit_pose();
    pose.position = unit_point(Q16(3));
    pose.position.z = unit_between(Q16(-6), Q16(4));
    turn_ahead(&pose, 40);
    return pose;
}
