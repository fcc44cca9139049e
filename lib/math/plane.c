/* SPDX-License-Identifier: MIT */

#include "arith.h"
#include "plane.h"

fxl_plane fxl_plane_from_point(const fxl_point *point, const fxl_direction *normal,
                               fxl_q16_16 inset)
{
    FXL_ASSERT(fxl_point_in_range(point) && inset >= 0 && inset <= FXL_INSET_MAX);
    fxl_plane plane;
    plane.normal = *normal;
    /* The sum is below 2^61 (fxl_dot), the product of the inset below 2^47. */
    plane.distance = fxl_dot(normal, point->x, point->y, point->z) + (int64_t)inset * FXL_Q2_30_ONE;
    return plane;
}

fxl_q18_46 fxl_plane_distance(const fxl_plane *plane, const fxl_point *point)
{
    FXL_ASSERT(fxl_point_in_range(point));
    /* The sum is below 2^61. The plane's distance is below 2^61 for a point in range,
     * plus 2^61 for near or far. So the difference is below 2^63. */
    return fxl_dot(&plane->normal, point->x, point->y, point->z) - plane->distance;
}
