/* SPDX-License-Identifier: MIT */
/* Clipping in the view (SPEC.md, section 4.7), to the frustum of section 4.3 before it is
 * transformed into the world. There each plane's normal has two components. */
#ifndef REF_CLIP_VIEW_H
#define REF_CLIP_VIEW_H

#include "reference/clip_world.h"

/* 113 bits where the compiler has them. Then products of 31 by 62 bits and their sums are exact,
 * so the sign of a distance is right. */
#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 ref_wide;
#else
typedef long double ref_wide;
#endif

/* A point is inside where across * right-or-up + along * forward >= distance. */
typedef struct {
    bool upright; /* across is along up, else along right */
    double across, along;
    long double distance;
} ref_view_plane;

typedef struct {
    ref_view_plane planes[REF_PLANE_COUNT];
} ref_view_frustum;

ref_view_frustum ref_view_frustum_from_lens(const ref_lens *lens);

/* Returns how far a point lies inside; negative outside. */
ref_wide ref_view_distance(const ref_view_plane *plane, const ref_view_point *point);

/* Returns the outcode: bit n is set where the point lies outside plane n. */
unsigned ref_outcode(const ref_view_frustum *frustum, const ref_view_point *point);

ref_clip_result ref_clip_view_to_plane(const ref_view_polygon *in, const ref_view_plane *plane,
                                       ref_view_polygon *out);

#endif
