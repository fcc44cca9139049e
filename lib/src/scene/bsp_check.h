/* SPDX-License-Identifier: MIT */
/* Checks of a scene's tree, after all other tables were found sound. Internal. */
#ifndef FXL_BSP_CHECK_H
#define FXL_BSP_CHECK_H

#include "fixel/scene.h"

/* FXL_OK where there is none. Linear in the tree and in its model. */
fxl_status fxl_bsp_check(const fxl_scene *scene, fxl_scene_fault *fault);

#endif
