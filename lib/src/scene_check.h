/* SPDX-License-Identifier: MIT */
/* What the two checks of a scene share. */
#ifndef SCENE_CHECK_H
#define SCENE_CHECK_H

#include "fixel/scene.h"

typedef fxl_status fxl_scene_checker(const fxl_scene *scene, fxl_scene_fault *fault);

/* Checks all tables that every scene has, then what more says; sets order_needed. */
fxl_status fxl_scene_check_with(fxl_scene *scene, fxl_scene_fault *fault, fxl_scene_checker *more);

#endif
