/* SPDX-License-Identifier: MIT */
/* The checks that fxl_scene_check and fxl_scene_check_all share. Internal. */
#ifndef SCENE_CHECK_H
#define SCENE_CHECK_H

#include "fixel/scene.h"

typedef fxl_status fxl_scene_checker(const fxl_scene *scene, fxl_scene_fault *fault);

/* Checks the tables that every scene has, then calls more; sets scene->order_needed if no check
 * failed. */
fxl_status fxl_scene_check_with(fxl_scene *scene, fxl_scene_fault *fault, fxl_scene_checker *more);

#endif
