/* SPDX-License-Identifier: MIT */
/* What the checks of a scene share: of the whole scene, of its tree, its clusters and its motions.
 * Internal. */
#ifndef FXL_SCENE_CHECK_H
#define FXL_SCENE_CHECK_H

#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef fxl_status fxl_scene_checker(const fxl_scene *scene, fxl_scene_fault *fault);

/* Checks the tables that every scene has, then calls more; sets scene->draw_list_needed if no check
 * failed. */
fxl_status fxl_scene_check_with(fxl_scene *scene, fxl_scene_fault *fault, fxl_scene_checker *more);

/* Checks the tree; FXL_OK if there is none. Requires that all other tables were checked. *fault
 * (may be null) is written only on an error. Takes time linear in the tree and in its model. */
fxl_status fxl_bsp_check(const fxl_scene *scene, fxl_scene_fault *fault);

/* Checks the clusters; FXL_OK if there are none. Requires that the tables that every scene has were
 * checked. *fault (may be null) is written only on an error. Takes time linear in the faces. */
fxl_status fxl_cluster_check(const fxl_scene *scene, fxl_scene_fault *fault);

static inline bool fxl_motion_limits_in_range(const fxl_motion_limits *limits)
{
    return limits->acceleration >= 0 && limits->acceleration <= FXL_MOTION_MAX &&
           limits->friction >= 0 && limits->friction <= FXL_MOTION_MAX && limits->speed_max >= 0 &&
           limits->speed_max <= FXL_MOTION_MAX && limits->turn <= FXL_ANGLE_QUARTER;
}

/* The status, and where it is not FXL_OK what of the scene is at fault; fault may be null. */
static inline fxl_status fxl_fault_at(fxl_scene_fault *fault, const char *what, uint32_t index,
                                      fxl_status status)
{
    if (fault != NULL) {
        fault->what = what;
        fault->index = index;
    }
    return status;
}

#ifdef __cplusplus
}
#endif

#endif
