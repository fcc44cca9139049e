/* SPDX-License-Identifier: MIT */
/* Planes, in double. */
#ifndef REF_PLANE_H
#define REF_PLANE_H

#include "reference/record.h"

/* Makes the plane through a point, with a normal that points inside, moved inside by inset. */
ref_plane ref_plane_from_point(const ref_point *point, const ref_point *normal, double inset);

/* Returns how far a point lies inside; negative outside. Summed in 64 bits: exact where normal
 * and point are the library's integers. */
long double ref_plane_distance(const ref_plane *plane, const ref_point *point);

/* Makes the plane through three points. Its normal points to where they run clockwise. Returns
 * false where they lie on one line. */
bool ref_plane_from_points(const ref_point *a, const ref_point *b, const ref_point *c,
                           ref_plane *plane);

#endif
