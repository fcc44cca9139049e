/* SPDX-License-Identifier: MIT */
/* The view: camera, lens and frustum of a frame, which the stages share. */
#ifndef FXL_VIEW_H
#define FXL_VIEW_H

#include "fixel/stage/frustum.h"
#include "fixel/stage/project.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A view. The caller owns it, and sets first the lens, then the pose of each frame.
 *
 * The view of an off-centre lens is that of a centred lens with a larger focal length: the camera's
 * right and up are sheared along forward, so that the middle of the screen is straight ahead
 * (SPEC.md, section 4.2). Camera, projection and frusta are those of the sheared view. */
typedef struct {
    fxl_camera camera;
    fxl_lens lens; /* as it was set */
    fxl_projection projection;
    uint32_t frame; /* counts poses, skipping 0; 0: no pose yet */
    fxl_view_frustum view_frustum;
    fxl_frustum frustum; /* in the world; valid after fxl_view_set_world_frustum */
} fxl_view;

/* Sets the lens, and what depends on it; frame becomes 0.
 * Requires a lens made by the functions of fixel/stage/lens.h. */
void fxl_view_set_lens(fxl_view *view, const fxl_lens *lens);

/* The focal length that the projection of the view has: the lens's, or, if that is off-centre, the
 * length of (focal, offset of the centre) in the axis where that is larger, and up to 2^-24 more.
 */
static inline fxl_q16_16 fxl_view_drawn_focal(const fxl_view *view)
{
    return FXL_CAST(fxl_q16_16, view->projection.factor >> 2);
}

/* The centred lens that the view is drawn with: view->lens itself if that is centred. A stage takes
 * it together with view->camera. */
fxl_lens fxl_view_drawn_lens(const fxl_view *view);

/* Sets the pose, which begins the next frame. Requires and rounds as
 * fxl_camera_from_pose; right and up of an off-centre lens are rounded once more, and within 4
 * units of 2^-30 of the exact ones. Requires a view that fxl_view_set_lens set up.
 * FXL_E_ARGUMENT: pose is null.
 * FXL_E_RANGE: pose is out of range.
 * With each of these statuses: view untouched. */
fxl_status fxl_view_set_pose(fxl_view *view, const fxl_pose *pose);

/* Sets up the planes in the world: fxl_clipper.begin of clippers that clip there. Requires a pose.
 * Error: that of fxl_frustum_from_camera. */
void fxl_view_set_world_frustum(fxl_view *view);

#ifdef __cplusplus
}
#endif

#endif
