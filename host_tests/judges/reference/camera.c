/* SPDX-License-Identifier: MIT */
#include "reference/camera.h"

#include "reference/angle.h"

/* The axes of the view start as the axes of the world. Each turn rotates the view about one of
 * its own axes: it replaces the two other axes by combinations of themselves. This follows the
 * words of SPEC.md, section 1.3, so the table of products there is checked, not copied. */

/* Turns axis a towards axis b by an angle whose sine and cosine are given. */
static void turn(ref_point *a, ref_point *b, double s, double c)
{
    ref_point old_a = *a, old_b = *b;
    a->x = c * old_a.x + s * old_b.x;
    a->y = c * old_a.y + s * old_b.y;
    a->z = c * old_a.z + s * old_b.z;
    b->x = c * old_b.x - s * old_a.x;
    b->y = c * old_b.y - s * old_a.y;
    b->z = c * old_b.z - s * old_a.z;
}

ref_point ref_point_from_lattice(const ref_lattice_point *point)
{
    return (ref_point){point->x / REF_ONE, point->y / REF_ONE, point->z / REF_ONE};
}

ref_camera ref_camera_from_pose(const ref_pose *pose)
{
    ref_camera camera = {.position = ref_point_from_lattice(&pose->position),
                         .right = {1, 0, 0},
                         .up = {0, 1, 0},
                         .forward = {0, 0, 1}};
    /* Yaw: the view from +z towards +x. */
    turn(&camera.forward, &camera.right, ref_sin(pose->yaw), ref_cos(pose->yaw));
    /* Pitch: the view towards up. */
    turn(&camera.forward, &camera.up, ref_sin(pose->pitch), ref_cos(pose->pitch));
    /* Roll: the right side towards the up side. */
    turn(&camera.right, &camera.up, ref_sin(pose->roll), ref_cos(pose->roll));
    return camera;
}

ref_point ref_forward(ref_angle yaw, ref_angle pitch)
{
    ref_pose pose = {.yaw = yaw, .pitch = pitch};
    return ref_camera_from_pose(&pose).forward;
}
