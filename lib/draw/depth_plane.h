/* SPDX-License-Identifier: MIT */
/* The depth of a face on the screen. Internal. */
#ifndef FXL_DEPTH_PLANE_H
#define FXL_DEPTH_PLANE_H

#include "surface_polygon.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The plane through the face's first corner with the face's normal.
 * A face that is seen edge-on, to within the rounding of its normal, is at infinity.
 * Error: the normal is off by less than 2^-28, and the depth of the plane relatively by less than
 * 2^-27. */
void fxl_depth_plane_find(const fxl_model_view *model_view, const fxl_face *face,
                          const fxl_traversal *traversal, fxl_depth_plane *plane);

#ifdef __cplusplus
}
#endif

#endif
