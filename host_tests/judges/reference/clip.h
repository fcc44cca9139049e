/* SPDX-License-Identifier: MIT */
#ifndef REF_CLIP_H
#define REF_CLIP_H

#include "reference/frustum.h"

/* Polygons clipped by planes: in the world, in the view, and to a rectangle of the screen. */

/* What a plane leaves of a polygon. */
typedef enum {
    REF_CLIP_INSIDE,     /* wholly inside: out is a copy */
    REF_CLIP_CUT,        /* out is what is left */
    REF_CLIP_OUTSIDE,    /* no vertex inside */
    REF_CLIP_DEGENERATE, /* fewer than three vertices left */
    REF_CLIP_CAPACITY    /* more than REF_POLYGON_CAPACITY: refused */
} ref_clip_result;

/* Clipping in world space (docs/extras/clippers.md, section 5), in double. */

ref_clip_result ref_clip_world_to_plane(const ref_polygon *in, const ref_plane *plane,
                                        ref_polygon *out);
/* By the planes whose bit, 1 << REF_PLANE_..., is set. */
ref_clip_result ref_clip_world_to_planes(const ref_polygon *in, const ref_frustum *frustum,
                                         unsigned planes, ref_polygon *out);
ref_clip_result ref_clip_world_to_frustum(const ref_polygon *in, const ref_frustum *frustum,
                                          ref_polygon *out);

/* Clipping in the view (SPEC.md, section 4.7), to the frustum of section 4.3 before it is
 * transformed into the world. There each plane's normal has two components. */

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

/* Polygons of the screen clipped to a rectangle (docs/extras/clippers.md, section 3), in double. */

/* In pixels, y down. */
typedef struct {
    double left, top, right, bottom;
} ref_rectangle;

/* Clips a convex polygon. Returns false where fewer than three vertices are left. Requires room for
 * four vertices more in REF_POLYGON_CAPACITY. */
bool ref_clip_to_rectangle(const ref_screen_polygon *in, const ref_rectangle *rectangle,
                           ref_screen_polygon *out);

/* Clipping to a convex volume (docs/extras/clippers.md): the result that every other clipper
 * must give, whatever its method. */

enum {
    REF_CARRIED_MAX = 6,
    REF_VOLUME_CAPACITY = 64
};

/* A half-space. A point is inside where a x + b y + c z + d >= 0. */
typedef struct {
    ref_wide a, b, c, d;
} ref_half_space;

typedef struct {
    ref_wide x, y, z;
    double carried[REF_CARRIED_MAX];
} ref_volume_vertex;

typedef struct {
    int count, carried; /* count 0: nothing is left */
    ref_volume_vertex vertices[REF_VOLUME_CAPACITY];
} ref_volume_polygon;

/* Makes the planes of a lens, with insets, in the order of REF_PLANE_.... */
void ref_volume_from_lens(const ref_lens *lens, ref_half_space planes[REF_PLANE_COUNT]);

/* Makes the planes of a frustum whose window, on the plane z = near_z, reaches from left to
 * right and from bottom to top. */
void ref_volume_from_window(double left, double right, double bottom, double top, double near_z,
                            double far_z, ref_half_space planes[REF_PLANE_COUNT]);

ref_wide ref_half_space_distance(const ref_half_space *plane, const ref_volume_vertex *vertex);
bool ref_volume_holds(const ref_half_space *planes, int count, const ref_volume_vertex *vertex);

/* Clips a polygon to all planes. Returns true where a plane cut it, or nothing is left. */
bool ref_clip_to_volume(const ref_volume_polygon *in, const ref_half_space *planes, int count,
                        ref_volume_polygon *out);

/* Clips a line. The part inside is (1 - t) from + t to for t from *enter to *leave. Returns
 * false where there is none. */
bool ref_clip_line(const ref_volume_vertex *from, const ref_volume_vertex *to,
                   const ref_half_space *planes, int count, ref_wide *enter, ref_wide *leave);

/* How a line and a plane lie to each other. */
typedef enum {
    REF_LINE_MEETS,
    REF_LINE_LIES_IN,
    REF_LINE_IS_PARALLEL
} ref_line_relation;

/* The endless line (1 - t) from + t to. *t is set where it meets the plane in one point. */
ref_line_relation ref_line_meet_plane(const ref_volume_vertex *from, const ref_volume_vertex *to,
                                      const ref_half_space *plane, ref_wide *t);

ref_volume_vertex ref_volume_between(const ref_volume_vertex *from, const ref_volume_vertex *to,
                                     ref_wide t);

#endif
