/* SPDX-License-Identifier: MIT */
/* How far a depth of the library may differ from the exact one, and the frustum with near and
 * far moved by that much (docs/accuracy.md, sections 1 and 4). */
#ifndef REF_DEPTH_H
#define REF_DEPTH_H

#include "reference/clip_view.h"

/* Returns the most that rounding may change the depth of a point of the polygon. It is 2 units
 * of 2^-30 an entry of the camera's matrix, times the largest |dx| + |dy| + |dz| of a vertex,
 * plus 4 units of 2^-46 of a clipper's own coordinates. Those may be smaller than the world's by
 * the ratio of the shorter side of the screen to twice the focal length. */
double ref_depth_bound(const ref_polygon *polygon, const ref_point *eye, const ref_lens *lens);

/* Tells whether near or far, moved by at most the bound, cuts the polygon or meets a vertex of
 * it. */
bool ref_depth_is_in_doubt(const ref_view_frustum *frustum, const ref_camera *camera,
                           const ref_polygon *polygon, double bound);

/* Moves near and far apart by a distance; towards each other where it is negative. */
void ref_depth_move_frustum(ref_frustum *frustum, double distance);
void ref_depth_move_view_frustum(ref_view_frustum *frustum, double distance);

#endif
