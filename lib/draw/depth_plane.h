/* SPDX-License-Identifier: MIT */
/* The depth of a face on the screen. Internal. */
#ifndef FXL_DEPTH_PLANE_H
#define FXL_DEPTH_PLANE_H

#include "surface_polygon.h"

#ifdef __cplusplus
extern "C" {
#endif

/* fxl_surface_backend.find_depth: the plane through the face's first corner with the face's normal.
 * A face that is seen edge-on, to within the rounding of its normal, is at infinity.
 * Error: the normal is off by less than 2^-28, and the depth of the plane relatively by less than
 * 2^-27. */
void fxl_depth_plane_find(const fxl_model_view *model_view, const fxl_face *face,
                          const fxl_traversal *on, fxl_depth_plane *plane);

/* fxl_visibility_depth and fxl_visibility_depth_32 in the other order, for blended surfaces. */
extern const fxl_visibility fxl_depth_far_to_near, fxl_depth_far_to_near_32;

#ifdef __cplusplus
}
#endif

#endif
