/* SPDX-License-Identifier: MIT */
/* The outcode: the planes of the frustum that a point of the view lies outside of. */
#ifndef FXL_OUTCODE_H
#define FXL_OUTCODE_H

#include "fixel/stage/frustum.h"

/* A set of planes: bit n stands for plane n (FXL_PLANE_...). */
typedef uint8_t fxl_planes;

#define FXL_PLANES_ALL ((fxl_planes)((1u << FXL_PLANE_COUNT) - 1u))

/* Those of the given planes that the point lies outside of.
 * Requires |x|, |y|, |z| < 2^61 units.
 * Exact: the bit of a given plane n is set if fxl_view_distance of plane n is negative.
 * Source: A10. */
fxl_planes fxl_outcode(const fxl_view_frustum *frustum, fxl_planes planes,
                       const fxl_view_point *point);

#endif
