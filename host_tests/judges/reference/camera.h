/* SPDX-License-Identifier: MIT */
/* The camera (SPEC.md, section 1.3), in double. */
#ifndef REF_CAMERA_H
#define REF_CAMERA_H

#include "reference/record.h"

typedef struct {
    ref_point position;
    ref_point right, up, forward;
} ref_camera;

/* Makes the camera: R . P . Y, computed as three turns one after the other. */
ref_camera ref_camera_from_pose(const ref_pose *pose);

/* Returns the direction in which a player looks: the image of (0, 0, 1) under the turns. */
ref_point ref_forward(ref_angle yaw, ref_angle pitch);

ref_point ref_point_from_lattice(const ref_lattice_point *point);

#endif
