/* SPDX-License-Identifier: MIT */
/* On which side of the frustum's planes a point of the view lies. */
#ifndef FXL_OUTCODE_H
#define FXL_OUTCODE_H

#include "fixel/stage/frustum.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A set of planes: bit n is that of plane n (FXL_PLANE_...). */
typedef uint8_t fxl_planes;

#define FXL_PLANES_ALL FXL_CAST(fxl_planes, (1u << FXL_PLANE_COUNT) - 1u)

/* Those of the given planes that the point lies outside of. Exact: bit n is set
 * where fxl_view_distance of plane n is negative.
 * Requires |x|, |y|, |z| < 2^61 units. */
fxl_planes fxl_outcode(const fxl_view_frustum *frustum, fxl_planes planes,
                       const fxl_view_point *point);

#ifdef __cplusplus
}
#endif

#endif
