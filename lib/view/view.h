/* SPDX-License-Identifier: MIT */
/* Sets up a view: camera, lens and frustum of a frame, which the stages share. Internal. */
#ifndef FXL_VIEW_H
#define FXL_VIEW_H

#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Sets the lens, and what depends on it; frame becomes 0.
 * Requires a lens made by the functions of fixel/camera.h. */
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

/* Counts a change of what is attached to the renderer of a view as a frame: so fxl_changed_find sees
 * it (lib/draw/changed.c). Before the first frame it counts nothing. */
static inline void fxl_view_count_change(fxl_view *view)
{
    view->frame += view->frame != 0;
}

static inline void fxl_view_next_frame(fxl_view *view)
{
    view->frame += 1;
    view->frame += view->frame == 0;
}

/* Sets the pose, which begins the next frame. Requires and rounds as
 * fxl_camera_from_pose; right and up of an off-centre lens are rounded once more, and within 4
 * units of 2^-30 of the exact ones. Requires a view that fxl_view_set_lens set up.
 * FXL_E_ARGUMENT: pose is null.
 * FXL_E_RANGE: pose is out of range; or the eye of an orthographic lens would be, moved to where the
 * middle of the screen is.
 * With each of these statuses: view untouched. */
fxl_status fxl_view_set_pose(fxl_view *view, const fxl_pose *pose);

/* The same with camera and frame alone, whatever the lens is: for fxl_off_centre_code. */
fxl_status fxl_view_set_own_pose(fxl_view *view, const fxl_pose *pose);

/* Sets up the planes in the world: fxl_clipper.begin of clippers that clip there. Requires a pose.
 * Error: that of fxl_frustum_from_sides. */
void fxl_view_set_world_frustum(fxl_view *view);

/* Sets up the frustum in the view.
 * Requires a lens made by fxl_lens_from_fov.
 * Error: (x_side, x_depth) is (focal, width/2) scaled to unit length, each
 * component within 1 unit of 2^-30; (y_side, y_depth) likewise, with height/2.
 * near_z, far_z and inset are exact. Source: A4. */
void fxl_view_frustum_from_lens(const fxl_lens *lens, fxl_view_frustum *frustum);

/* Sets up the six planes in the world, each moved inward by lens->inset, with the sides set up
 * beforehand. It reads near_z, far_z and inset of the lens. In view
 * space, before the inset, their normals are
 *   left (focal, 0, width/2),    right (-focal, 0, width/2),
 *   bottom (0, focal, height/2), top (0, -focal, height/2),
 * each scaled to unit length, and these four planes pass through the eye; near has
 * (0, 0, 1) at lens->near_z, far has (0, 0, -1) at lens->far_z.
 * Requires the sides of a view, and its camera. In the sheared view of an off-centre lens a side's
 * normal is at most 1 long, and its direction is that of the border that it stands for.
 * Error: each component of a normal within 4 units of 2^-30. The side planes pass
 * through the eye, and near and far lie at their distance from it, to within 1 unit of
 * 1/65536 (exactly, except for the length of the normal).
 * Source: A4 (Listing 65.3, SetUpFrustum). */
void fxl_frustum_from_sides(const fxl_camera *camera, const fxl_lens *lens,
                            const fxl_view_frustum *sides, fxl_frustum *frustum);

#ifdef __cplusplus
}
#endif

#endif
