/* SPDX-License-Identifier: MIT */
#include "reference/box.h"

#include "reference/plane.h"

uint32_t ref_box_planes(const ref_frustum *frustum, const ref_point *least, const ref_point *most)
{
    uint32_t crossed = 0;
    for (int i = 0; i < REF_PLANE_COUNT; i++) {
        int outside = 0, inside = 0;
        for (int corner = 0; corner < 8; corner++) {
            ref_point at = {corner & 1 ? most->x : least->x, corner & 2 ? most->y : least->y,
                            corner & 4 ? most->z : least->z};
            long double distance = ref_plane_distance(&frustum->planes[i], &at);
            outside += distance < -0x1p-9L;
            inside += distance >= 0x1p-9L;
        }
        if (outside == 8) {
            return 1u << REF_PLANE_COUNT;
        }
        crossed |= inside == 8 ? 0 : 1u << i;
    }
    return crossed;
}
