/* SPDX-License-Identifier: MIT */
/* The numbers of lib/src/sphere.c, which says what they are good for; no answer
 * comes early. */
#include "fixel/sphere.h"

#include "arith.h"
#include "rotate.h"

#define SLACK 9

/* By an unsigned shift, which compilers see through. */
static int32_t upper(int64_t value)
{
    return (int32_t)((uint64_t)value >> 32);
}

/* The upper word of a product. */
static int32_t scaled(fxl_q2_30 part, int32_t size)
{
    return upper(fxl_multiply_s31(part, size));
}

/* Of the distances from the planes low and low + 1. */
static uint32_t pair(int32_t first, int32_t second, int32_t reach, int low)
{
    if (first + reach < 0 || second + reach < 0) {
        return FXL_SPHERE_OUTSIDE;
    }
    return ((uint32_t)(first < reach) | (uint32_t)(second < reach) << 1) << low;
}

uint32_t fxl_sphere_planes(const fxl_camera *camera, const fxl_view_frustum *frustum,
                           const fxl_point *centre, fxl_q16_16 radius)
{
    FXL_ASSERT(fxl_point_in_range(centre) && radius >= 0 && radius <= FXL_RADIUS_MAX);
    const fxl_point *eye = &camera->position;
    const fxl_point from_eye = {centre->x - eye->x, centre->y - eye->y, centre->z - eye->z};
    const int32_t reach = (radius >> 4) + SLACK;
    fxl_view_point seen;
    fxl_rotate(camera, &from_eye, &seen);
    const int32_t z = upper(seen.z), inset = (int32_t)(frustum->inset >> 34);
    uint32_t planes = pair((z >> 2) - (int32_t)(frustum->near >> 34),
                           (int32_t)(frustum->far >> 34) - (z >> 2), reach, FXL_PLANE_NEAR);
    int32_t apart = scaled(frustum->x_side, upper(seen.x));
    int32_t ahead = scaled(frustum->x_depth, z) - inset;
    planes |= pair(ahead + apart, ahead - apart, reach, FXL_PLANE_LEFT);
    apart = scaled(frustum->y_side, upper(seen.y));
    ahead = scaled(frustum->y_depth, z) - inset;
    planes |= pair(ahead + apart, ahead - apart, reach, FXL_PLANE_BOTTOM);
    return planes >= FXL_SPHERE_OUTSIDE ? FXL_SPHERE_OUTSIDE : planes;
}
