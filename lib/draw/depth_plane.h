/* SPDX-License-Identifier: MIT */
/* The depth of the plane through a point with a normal. A kernel: Armv6-M and Armv7-M have their own. Internal. */
#ifndef FXL_DEPTH_PLANE_H
#define FXL_DEPTH_PLANE_H

#include "../paint/depth_code.h"
#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Sets *plane to the depth of the plane through a point of the view. The normal in the view is
 * axes . normal, scaled and rounded so that its components have 30 bits, and turned away from the
 * eye; if axes is null, it is the given one. Where the point is not beyond the eye along the
 * normal, *plane is at infinity. Requires rows of axes of unit length or shorter, and a normal of
 * unit length to within FXL_NORMAL_SQUARE_MAX_ERROR; without axes, components of at most 2^30.
 * Error, given the rounded normal: relatively less than 2^-28, and less than one unit of each of
 * the gradient's members. With a field of view of 90 degrees the latter is at most 2^-9 of what
 * half a unit of the normal changes. */
void fxl_find_depth_plane(const fxl_direction *normal, const fxl_axes *axes,
                          const fxl_view_point *point, const fxl_view *view,
                          fxl_depth_plane *plane);

#ifdef __cplusplus
}
#endif

#endif
