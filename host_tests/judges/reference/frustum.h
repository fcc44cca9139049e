/* SPDX-License-Identifier: MIT */
/* Planes, and the view frustum in the world, in double. */
#ifndef REF_FRUSTUM_H
#define REF_FRUSTUM_H

#include "reference/camera.h"

/* Makes the plane through a point, with a normal that points inside, moved inside by inset. */
ref_plane ref_plane_from_point(const ref_point *point, const ref_point *normal, double inset);

/* Returns how far a point lies inside; negative outside. Summed in 64 bits: exact where normal
 * and point are the library's integers. */
long double ref_plane_distance(const ref_plane *plane, const ref_point *point);

/* Makes the plane through three points. Its normal points to where they run clockwise. Returns
 * false where they lie on one line. */
bool ref_plane_from_points(const ref_point *a, const ref_point *b, const ref_point *c,
                           ref_plane *plane);

/* The view frustum (SPEC.md, section 4.3), in double. */

enum {
    REF_PLANE_NEAR,
    REF_PLANE_FAR,
    REF_PLANE_LEFT,
    REF_PLANE_RIGHT,
    REF_PLANE_BOTTOM,
    REF_PLANE_TOP,
    REF_PLANE_COUNT
};

typedef struct {
    ref_plane planes[REF_PLANE_COUNT];
} ref_frustum;

ref_frustum ref_frustum_from_camera(const ref_camera *camera, const ref_lens *lens);

/* Makes the same frustum, except for the sides without a bit in cuts: they lie at this many
 * pixels from the middle of the screen, without an inset (docs/extras/clippers.md, section 2.3). */
ref_frustum ref_frustum_with_guard(const ref_camera *camera, const ref_lens *lens, unsigned cuts,
                                   double pixels);

#endif
