/* SPDX-License-Identifier: MIT */
/* Clips lines to a volume, in two ways. Source: notes on homogeneous view volumes (D3, D4) and
 * on a line and a plane (B1). */
#ifndef FXL_LINE_H
#define FXL_LINE_H

#include "fixel/records.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How many varyings a vertex may carry: texture coordinates, colours, light. */
#define FXL_CARRIED_MAX 6

/* A vertex and its varyings. A varying is within 16383 either way. The clipper cuts it by the
 * same fraction as the position. */
typedef struct {
    fxl_view_point position; /* each below 2^61 */
    fxl_q16_16 carried[FXL_CARRIED_MAX];
} fxl_varying_vertex;

/* A point (x, y, z, 1) of the view is inside where
 *   normal . (x, y, z) + offset >= 0.
 * The normal need not have unit length: |x| + |y| + |z| < 2^31. |offset| < 2^62, in units of
 * 2^-46. The plane is exactly what these integers say. */
typedef struct {
    fxl_direction normal;
    fxl_q18_46 offset;
} fxl_half_space;

/* Six half-spaces in the order of FXL_PLANE_... They need not form a frustum. */
typedef struct {
    fxl_half_space planes[FXL_PLANE_COUNT];
} fxl_volume;

/* A line between two points of the view. Its varyings are cut with it. */
typedef struct {
    fxl_varying_vertex from, to;
    uint8_t carried; /* how many varyings of its ends are cut: 0..FXL_CARRIED_MAX */
} fxl_clip_line;

/* Clips a line plane by plane, in the order of the planes: moves an end that is outside onto the
 * plane. An end that is inside keeps its bits. Returns false where nothing is left; the line may
 * then have been changed. Adds the number of intersections computed to *intersections. Requires
 * coordinates below 2^61.
 * Error of a moved end, for each plane that moved it: 1 unit of 2^-46 a coordinate from the
 * line, and half a unit of 2^-16 a varying. It lies within 3 units of the plane that moved it
 * last. A line that passes a corner of the volume by less than this, or lies in a plane to
 * within this, may be kept or rejected. */
bool fxl_line_by_planes(fxl_clip_line *line, const fxl_volume *volume, uint32_t *intersections);

/* Clips a line by outcodes. A line with both ends outside one plane is rejected. A line with
 * both ends inside all planes stays as it is. Otherwise one end is moved onto a plane that it
 * lies outside of, and both tests are repeated. Computes fewer distances than
 * fxl_line_by_planes, and no more intersections. Requirements, result and error are those of
 * fxl_line_by_planes. */
bool fxl_line_by_codes(fxl_clip_line *line, const fxl_volume *volume, uint32_t *intersections);

/* How a line and a plane lie to each other. */
typedef enum {
    FXL_LINE_MEETS,      /* they have one point in common */
    FXL_LINE_MEETS_FAR,  /* they have one, out of range */
    FXL_LINE_LIES_IN,    /* every point of the line lies in the plane */
    FXL_LINE_IS_PARALLEL /* they have no point in common */
} fxl_line_relation;

/* The common point of a line and a plane. */
typedef struct {
    int64_t parameter; /* 32.32: 0 at the line's first point, 1 at its second */
    fxl_view_point point;
} fxl_line_meeting;

/* Tells how the line through two points lies to a plane, and where they meet. The line is endless:
 * the parameter may be below 0 or above 1, beyond the ends. The relation is exact. If the two
 * points are one, the "line" lies in the plane or is parallel to it. FXL_LINE_MEETS: *meeting is
 * written. Otherwise it is untouched. FXL_LINE_MEETS_FAR: the parameter is 2^31 or more either way,
 * or a coordinate of the point 2^61 or more. Requires coordinates below 2^61. Error: the parameter
 * is rounded towards 0, so by less than 2^-32. The point is within 1.25 units of 2^-46 a coordinate
 * of the exact common point. Source: B1. */
fxl_line_relation fxl_line_meet_plane(const fxl_view_point *first, const fxl_view_point *second,
                                      const fxl_half_space *plane, fxl_line_meeting *meeting);

#ifdef __cplusplus
}
#endif

#endif
