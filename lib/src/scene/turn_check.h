/* SPDX-License-Identifier: MIT */
/* The check of a scene's turns. Internal. */
#ifndef TURN_CHECK_H
#define TURN_CHECK_H

#include "fixel/scene.h"

/* Checks the turns of a scene whose other tables are in range: that first_turned is an instance,
 * that the tree's instance stands still, that each orientation is a rotation and each scale in
 * range, and that each turned instance lies in the world with all its model's sphere. */
fxl_status fxl_turn_check(const fxl_scene *scene, fxl_scene_fault *fault);

#endif
