/* SPDX-License-Identifier: MIT */
/* Clipping to a convex volume (docs/extras/clippers.md): the result that every other clipper
 * must give, whatever its method. */
#ifndef REF_VOLUME_H
#define REF_VOLUME_H

#include "reference/clip_view.h"

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
