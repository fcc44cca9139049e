/* SPDX-License-Identifier: MIT */
/* Converts the library's records to those of the reference renderer. Every conversion is exact,
 * so both sides of a stage get the same input. */
#ifndef STAGES_BRIDGE_H
#define STAGES_BRIDGE_H

#include "draw/stages.h"
#include "fixel/all.h"
#include "reference/camera.h"
#include "reference/clip.h"
#include "reference/record.h"

_Static_assert((int)FXL_PLANE_NEAR == (int)REF_PLANE_NEAR &&
                   (int)FXL_PLANE_FAR == (int)REF_PLANE_FAR &&
                   (int)FXL_PLANE_LEFT == (int)REF_PLANE_LEFT &&
                   (int)FXL_PLANE_RIGHT == (int)REF_PLANE_RIGHT &&
                   (int)FXL_PLANE_BOTTOM == (int)REF_PLANE_BOTTOM &&
                   (int)FXL_PLANE_TOP == (int)REF_PLANE_TOP,
               "the order of planes");

ref_point bridge_point(const fxl_point *point);
ref_plane bridge_plane(const fxl_plane *plane);
ref_camera bridge_camera(const fxl_camera *camera);
/* Requires a lens that has an eye. */
ref_lens bridge_lens(const fxl_lens *lens);
ref_polygon bridge_polygon(const fxl_polygon *polygon);
ref_view_point bridge_view_point(const fxl_view_point *point);
ref_view_polygon bridge_view_polygon(const fxl_view_polygon *polygon);
ref_view_frustum bridge_view_frustum(const fxl_view_frustum *frustum);
ref_screen_polygon bridge_screen_polygon(const fxl_screen_polygon *polygon);

#endif
