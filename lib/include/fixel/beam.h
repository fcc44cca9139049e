/* SPDX-License-Identifier: MIT */
/* Light beams: convex parts of the world in which faces are drawn lit. If a face is turned to
 * the light, the part of it within a beam is drawn in the lit variant of its colour, and the
 * rest in its own colour. Nothing casts a shadow within a beam. Source: "Realtime 3D Clipping"
 * (C6). */
#ifndef FXL_BEAM_H
#define FXL_BEAM_H

#include "fixel/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Makes the beam that falls through a window from a light at a point, or from a direction. The
 * window is a convex polygon of 3 to FXL_BEAM_PLANES_MAX - 1 corners, in either winding. The
 * beam has a plane for each side of the window, in order; the side goes from its corner to the
 * next. After them comes the window's own plane, through its first three corners; the beam
 * begins there, on the side away from the light. Each plane passes exactly through its side's
 * first corner (the window's own plane through the first one).
 * Error: a component of a normal 2 units of 2^-30 from the exact one's.
 * FXL_E_ARGUMENT: a null pointer.
 * FXL_E_COUNT: a count is out of its range.
 * FXL_E_RANGE: a corner or a point beyond FXL_COORDINATE_MAX, a direction not of unit length.
 * FXL_E_DEGENERATE: the light lies in the plane of the window or of one of its sides, or the
 * window is not convex; all to within 2^-12 unit.
 * With each of these statuses: *beam untouched. */
fxl_status fxl_beam_from_point(const fxl_point *light, const fxl_point *window, uint32_t count,
                               fxl_beam *beam);
fxl_status fxl_beam_from_direction(const fxl_direction *travel, const fxl_point *window,
                                   uint32_t count, fxl_beam *beam);

/* Checks a beam that was written as a table.
 * FXL_E_ARGUMENT: it is null.
 * FXL_E_RESERVED: its kind is unknown, or an unused member is not 0.
 * FXL_E_COUNT: it has too few planes or too many.
 * FXL_E_RANGE: its point or a distance is out of range.
 * FXL_E_NORMAL: a normal or a direction is not of unit length. */
fxl_status fxl_beam_check(const fxl_beam *beam);

#ifdef __cplusplus
}
#endif

#endif
