/* SPDX-License-Identifier: MIT */
/* Checks of a scene's tree, after all other tables were found sound. Internal. */
#ifndef FXL_TREE_CHECK_H
#define FXL_TREE_CHECK_H

#include "fixel/scene.h"

/* FXL_OK where there is none. Linear in the tree and in its model. */
fxl_status fxl_tree_check(const fxl_scene *scene, fxl_scene_fault *fault);

#endif
