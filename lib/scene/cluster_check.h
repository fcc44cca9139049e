/* SPDX-License-Identifier: MIT */
/* The check of a scene's clusters. Internal. */
#ifndef FXL_CLUSTER_CHECK_H
#define FXL_CLUSTER_CHECK_H

#include "fixel/scene.h"

/* Checks the clusters; FXL_OK if there are none. Requires that the tables that every scene has were
 * checked. *fault (may be null) is written only on an error. Takes time linear in the faces. */
fxl_status fxl_cluster_check(const fxl_scene *scene, fxl_scene_fault *fault);

#endif
