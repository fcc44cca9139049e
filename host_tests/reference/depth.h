/* SPDX-License-Identifier: MIT */
/* By how much a depth of the library may differ from the exact one, and the frustum with
 * near and far moved by so much (SPEC.md 6 and 10). */
#ifndef REF_DEPTH_H
#define REF_DEPTH_H

#include "reference/clip_view.h"

/* What rounding may add to the depth of a point of the polygon or take from it: 2 units of
 * 2^-30 an entry of the camera's matrix, times |dx| + |dy| + |dz| of the vertex where that is
 * largest, and 4 units of 2^-46 of a clipper's own coordinates, which may be as much smaller
 * than the world's as the shorter side of the screen is than twice the focal length. */
double ref_depth_bound(const ref_polygon *polygon, const ref_point *eye, const ref_lens *lens);

/* Whether near or far, moved by no more than the bound, cuts the polygon or meets a vertex
 * of it. */
bool ref_depth_is_in_doubt(const ref_view_frustum *frustum, const ref_camera *camera,
                           const ref_polygon *polygon, double bound);

/* Moves near and far apart; towards each other where the distance is below 0. */
void ref_depth_move_frustum(ref_frustum *frustum, double distance);
void ref_depth_move_view_frustum(ref_view_frustum *frustum, double distance);

#endif
