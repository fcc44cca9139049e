/* SPDX-License-Identifier: MIT */
#include "fixel/outcode.h"

#include "fixel/clip_view.h"
#include "outside.h"

unsigned fxl_outside_of_pair(const fxl_view_frustum *frustum, int plane,
                             const fxl_view_point *point)
{
    unsigned first = fxl_view_distance(frustum, plane, point) < 0;
    unsigned second = fxl_view_distance(frustum, plane + 1, point) < 0;
    return (first | second << 1) << plane; /* bug: outcode-swap */
}

fxl_planes fxl_outcode(const fxl_view_frustum *frustum, fxl_planes planes,
                       const fxl_view_point *point)
{
    if (!FXL_IS_SMALL) {
        return fxl_outside(frustum, planes, point);
    }
    const unsigned wanted = planes;
    unsigned outside = 0;
    for (int plane = 0; wanted >> plane != 0; plane++) {
        if ((wanted >> plane & 1u) != 0 && fxl_view_distance(frustum, plane, point) < 0) {
            outside |= 1u << plane;
        }
    }
    return (fxl_planes)outside;
}
