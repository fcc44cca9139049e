/* SPDX-License-Identifier: MIT */
/* Random poses about the cubes of tiny.h. */
#ifndef TINY_POSES_H
#define TINY_POSES_H

#include "unit.h"

/* Between and beside the cubes, where many faces are cut; turned any way. */
fxl_pose tiny_pose_between(void);

/* Before, between and beside the cubes, and mostly turned to some of them. */
fxl_pose tiny_pose_about(void);

/* The three cubes are ahead, often one behind another. */
fxl_pose tiny_pose_before(void);

#endif
