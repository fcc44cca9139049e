/* SPDX-License-Identifier: MIT */
/* The projection from the view onto the screen (SPEC.md, section 4.8), in double. */
#ifndef REF_PROJECT_H
#define REF_PROJECT_H

#include "reference/lens.h"

/* Requires view->z > 0. */
ref_screen_point ref_project_point(const ref_lens *lens, const ref_view_point *view);

/* A point in the view of those that are seen at a point of the screen; the others are its
 * multiples. */
ref_view_point ref_ray_through(const ref_lens *lens, const ref_screen_point *screen);
void ref_project_polygon(const ref_lens *lens, const ref_view_polygon *view,
                         ref_screen_polygon *screen);

#endif
