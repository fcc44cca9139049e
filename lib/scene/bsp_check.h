/* SPDX-License-Identifier: MIT */
/* The check of a scene's BSP tree. Internal. */
#ifndef FXL_BSP_CHECK_H
#define FXL_BSP_CHECK_H

#include "fixel/scene.h"

/* Checks the tree; FXL_OK if there is none. Requires that all other tables were checked. *fault
 * (may be null) is written only on an error. Takes time linear in the tree and in its model. */
fxl_status fxl_bsp_check(const fxl_scene *scene, fxl_scene_fault *fault);

#endif
