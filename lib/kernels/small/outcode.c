/* SPDX-License-Identifier: MIT */
/* Every plane is asked by its exact distance. */
#include "fixel/outcode.h"

#include "fixel/clip_view.h"
#include "outside.h"

unsigned fxl_outside_of_pair(const fxl_view_frustum *frustum, int plane,
                             const fxl_view_point *point)
{
    return fxl_outcode(frustum, (fxl_planes)(3u << plane), point);
}

fxl_planes fxl_outcode(const fxl_view_frustum *frustum, fxl_planes planes,
                       const fxl_view_point *point)
{
    unsigned outside = 0;
    for (int plane = 0; planes >> plane != 0; plane++) {
        if ((planes >> plane & 1u) != 0 && fxl_view_distance(frustum, plane, point) < 0) {
            outside |= 1u << plane;
        }
    }
    return (fxl_planes)outside;
}
