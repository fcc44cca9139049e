/* SPDX-License-Identifier: MIT */
/* The view: camera, lens and frustum of a frame, which the stages share. */
#ifndef FXL_VIEW_H
#define FXL_VIEW_H

#include "fixel/stage/frustum.h"
#include "fixel/stage/project.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A view. The caller owns it, and sets first the lens, then the pose of each frame. */
typedef struct {
    fxl_camera camera;
    fxl_lens lens;
    fxl_projection projection;
    fxl_view_frustum view_frustum;
    fxl_frustum frustum; /* in the world; valid after fxl_view_set_world_frustum */
    uint32_t frame;      /* counts poses, skipping 0; 0: no pose yet */
} fxl_view;

/* Sets the lens, and what depends on it; frame becomes 0.
 * Requires a lens made by fxl_lens_from_fov. */
void fxl_view_set_lens(fxl_view *view, const fxl_lens *lens);

/* Sets the pose, which begins the next frame. Requires and rounds as
 * fxl_camera_from_pose. FXL_E_ARGUMENT, FXL_E_RANGE (pose): view untouched. */
fxl_status fxl_view_set_pose(fxl_view *view, const fxl_pose *pose);

/* Sets up the planes in the world: fxl_clipper.begin of clippers that clip there. Requires a pose.
 * Error: that of fxl_frustum_from_camera. */
void fxl_view_set_world_frustum(fxl_view *view);

#ifdef __cplusplus
}
#endif

#endif
