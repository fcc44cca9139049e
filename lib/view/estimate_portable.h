/* SPDX-License-Identifier: MIT */
/* Estimates that decide a comparison before the exact sum is computed, where a family's exact
 * products are slow. The others compute the exact sum. Internal. */
#ifndef FXL_ESTIMATE_H
#define FXL_ESTIMATE_H

#include "../math/arith.h"
#include "fixel/stage/sphere.h"

/* Whether direction . (x, y, z) is negative. Requires what fxl_dot requires. Exact. */
static inline bool fxl_dot_is_negative(const fxl_direction *direction, int32_t x, int32_t y,
                                       int32_t z)
{
    return fxl_dot(direction, x, y, z) < 0;
}

/* Of fxl_sphere_planes, where an estimate does not decide the result. */
#define FXL_SPHERE_UNDECIDED UINT32_MAX

/* The result of fxl_sphere_planes, or FXL_SPHERE_UNDECIDED. from_eye is the centre less the eye,
 * each coordinate below 2^30; reach is the radius with its slack in units of 2^-12. */
static inline uint32_t fxl_estimated_sphere(const fxl_axes *axes, const fxl_view_frustum *frustum,
                                            const fxl_point *from_eye, int32_t reach)
{
    (void)axes, (void)frustum, (void)from_eye, (void)reach;
    return FXL_SPHERE_UNDECIDED;
}

#endif
