/* SPDX-License-Identifier: MIT */
#include "../clip/clip_view.h"
#include "outcode.h"

unsigned fxl_outside_of_pair(const fxl_view_frustum *frustum, int plane,
                             const fxl_view_point *point)
{
    unsigned first = fxl_view_distance(frustum, plane, point) < 0;
    unsigned second = fxl_view_distance(frustum, plane + 1, point) < 0;
    return (first | second << 1) << plane;
}

/* SPEC 4.7 */
fxl_planes fxl_outcode(const fxl_view_frustum *frustum, fxl_planes planes,
                       const fxl_view_point *point)
{
    unsigned outside = fxl_outside(frustum, planes, point);
    if ((outside & FXL_OUTSIDE_IS_OPEN) != 0) {
        outside &= FXL_PLANES_DEPTH;
        outside |= fxl_outside_of_pair(frustum, FXL_PLANE_LEFT, point) |
                   fxl_outside_of_pair(frustum, FXL_PLANE_BOTTOM, point);
    }
    return (fxl_planes)(outside & planes);
}
