/* SPDX-License-Identifier: MIT */
/* Light beams: convex parts of the world in which faces are drawn lit. What of a face lies
 * within a beam is drawn in its colour's lit variant, if the face is turned to the light;
 * the rest is drawn dark. Nothing throws a shadow within a beam. Source: "Realtime
 * 3D Clipping" (C6). */
#ifndef FXL_BEAM_H
#define FXL_BEAM_H

#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The beam that falls through a window, a convex polygon of 3 to FXL_BEAM_PLANES_MAX - 1
 * corners in either direction of winding: a plane for each side of the window, from a corner
 * to the next, then the window's own through its first three corners, behind which the beam
 * begins. Each plane passes exactly through the corner with which it begins.
 * Error: a component of a normal 2 units of 2^-30 from the exact one's.
 * FXL_E_ARGUMENT, FXL_E_COUNT; FXL_E_RANGE (a corner or a point beyond FXL_COORDINATE_MAX, a
 * direction not of unit length); FXL_E_DEGENERATE where the light lies in the plane of the
 * window or of one of its sides, or the window is not convex, to within 2^-12 unit: *beam
 * untouched. */
fxl_status fxl_beam_from_point(const fxl_point *light, const fxl_point *window, uint32_t count,
                               fxl_beam *beam);
fxl_status fxl_beam_from_direction(const fxl_direction *travel, const fxl_point *window,
                                   uint32_t count, fxl_beam *beam);

/* Checks a beam written as a table: FXL_E_RESERVED (kind, what is unused), FXL_E_COUNT,
 * FXL_E_RANGE (point, distance), FXL_E_NORMAL (a normal or a direction not of unit length). */
fxl_status fxl_beam_check(const fxl_beam *beam);

/* Whether every part of a face of so many vertices fits a polygon that a clipper may cut: the
 * face's vertices, the planes of the first beam, and twice those of each further one add up
 * to no more than FXL_FACE_VERTICES_MAX. Requires checked beams. */
bool fxl_beams_fit(const fxl_beam *beams, uint32_t beam_count, uint32_t face_vertices);

/* A beam's plane for the functions that take one. */
fxl_plane fxl_beam_plane_at(const fxl_beam *beam, uint32_t number);

/* Whether a face with a vertex there and that normal is turned to the light. Exact.
 * Requires a point in range and a checked beam. */
bool fxl_beam_shines_on(const fxl_beam *beam, const fxl_point *vertex, const fxl_direction *normal);

/* Whether anything within a sphere may lie in the beam. Never false where some of it does:
 * false says that the sphere is behind one plane by 2^-14 unit or more.
 * Requires a centre in range, 0 <= radius <= FXL_RADIUS_MAX, a checked beam. */
bool fxl_beam_reaches(const fxl_beam *beam, const fxl_point *centre, fxl_q16_16 radius);

#ifdef __cplusplus
}
#endif

#endif
